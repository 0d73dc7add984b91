"""AR.Drone 2.0: AT commands, navdata, PaVE video, configuration."""
