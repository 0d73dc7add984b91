"""The Crazyflie over CRTP; docs/drones/crazyflie.md."""
