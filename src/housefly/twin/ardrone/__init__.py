"""The simulated AR.Drone 2.0: body, onboard computer and its four ports."""
