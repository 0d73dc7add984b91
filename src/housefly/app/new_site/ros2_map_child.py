"""Hears one map on a ROS 2 topic, and tells it in one line; without one, who publishes there.

``app.new_site.ros2_map`` starts it; it ends with its parent.
"""

from __future__ import annotations

import base64
import importlib
import time
from typing import IO, Any

from housefly.bus.ros2_child import ros2_node, ros2_type, run_ros2_child, write_line

_SPIN_PERIOD = 0.1
_OCCUPANCY_GRID = "nav_msgs/msg/OccupancyGrid"


def hear_one_map() -> None:
    """Hear one map."""
    run_ros2_child(_hear)


def _hear(settings: dict[str, Any], out: IO[str]) -> None:
    node, topic = ros2_node("housefly_map", settings), settings["topic"]
    heard: list[bytes] = []
    for profile in _profiles():
        kind = ros2_type(_OCCUPANCY_GRID)
        node.create_subscription(kind, topic, heard.append, profile, raw=True)
    rclpy, end = importlib.import_module("rclpy"), time.monotonic() + settings["patience"]
    while not heard and time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=_SPIN_PERIOD)
    if not heard:
        there = node.get_publishers_info_by_topic(topic)
        write_line(out, {"types": sorted({one.topic_type for one in there})})
    elif len(heard[0]) > settings["bytes_max"]:
        write_line(out, {"too_large": len(heard[0])})
    else:
        write_line(out, {"map": base64.b64encode(heard[0]).decode()})


def _profiles() -> tuple[Any, Any]:
    """Return what hears a latched map, and what hears one that is told again and again."""
    qos = importlib.import_module("rclpy.qos")
    latched = qos.QoSProfile(
        depth=1,
        reliability=qos.ReliabilityPolicy.RELIABLE,
        durability=qos.DurabilityPolicy.TRANSIENT_LOCAL,
    )
    return latched, qos.QoSProfile(depth=1, reliability=qos.ReliabilityPolicy.BEST_EFFORT)


if __name__ == "__main__":
    hear_one_map()
