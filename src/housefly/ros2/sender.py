"""Who ROS is to the rest of the room."""

from __future__ import annotations

SENDER = "ROS 2"
"""Who orders: no node proves that it is another one."""
OWNER = "ros2"
FLIGHTS_ARE_OFF = "flights from ROS are off ([ros2] requests in the site file)"
