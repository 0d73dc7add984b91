"""AR.Drone 2.0 driver."""
