"""The simulated Crazyflie: its computer, and its side of CRTP."""
