"""CRTP, the wire of the Crazyflie: bytes to values and back; docs/drones/crazyflie.md."""
