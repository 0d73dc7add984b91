"""The simulated DJI Tello on its real ports; ``server.TelloServer`` is what others use."""
