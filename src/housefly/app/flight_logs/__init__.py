"""Logs of others, as one form: ROS bags, PX4 ulog, ArduPilot dataflash, Crazyflie CSV."""
