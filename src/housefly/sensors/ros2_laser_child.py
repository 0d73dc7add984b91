"""Hears scans on a ROS 2 topic; writes one line a scan, and once a second who publishes there.

``sensors.ros2_laser`` starts it; it ends with its parent.
"""

from __future__ import annotations

import base64
import importlib
import time
from typing import IO, Any

from housefly.bus.ros2_child import ros2_node, ros2_type, run_ros2_child, write_line
from housefly.sensors.message_rate import TokenBucket

_LOOK_PERIOD = 1.0
"""How often it is told who publishes [s]."""
_LASER_SCAN = "sensor_msgs/msg/LaserScan"


def hear_scans() -> None:
    """Hear scans until the parent is gone."""
    run_ros2_child(_hear)


def _hear(settings: dict[str, Any], out: IO[str]) -> None:
    node = ros2_node(f"housefly_scanner{settings['topic'].replace('/', '_')}", settings)
    listener = _ScanListener(node, settings, out)
    qos = importlib.import_module("rclpy.qos")
    # The newest only: what waited shows what was. Best effort hears publishers of both kinds.
    profile = qos.QoSProfile(depth=1, reliability=qos.ReliabilityPolicy.BEST_EFFORT)
    kind = ros2_type(_LASER_SCAN)
    node.create_subscription(kind, settings["topic"], listener.receive, profile, raw=True)
    node.create_timer(_LOOK_PERIOD, listener.look)
    listener.look()
    importlib.import_module("rclpy").spin(node)


class _ScanListener:
    """Hands on what comes, as it came: whoever reads it checks it."""

    def __init__(self, node: Any, settings: dict[str, Any], out: IO[str]) -> None:
        self._node, self._topic, self._out = node, settings["topic"], out
        self._bytes_max = settings["bytes_max"]
        self._bucket = TokenBucket(settings["rate_max"])
        self._flooded = self._publishers = 0

    def look(self) -> None:
        """Tell who publishes."""
        there = self._node.get_publishers_info_by_topic(self._topic)
        self._publishers = len(there)
        told = [one for one in there if one.topic_type == _LASER_SCAN]
        line = {
            "nodes": [f"{one.node_namespace.rstrip('/')}/{one.node_name}" for one in told],
            "types": sorted({one.topic_type for one in there}),
            "flooded": self._flooded,
        }
        write_line(self._out, line)

    def receive(self, data: bytes) -> None:
        """Tell a scan."""
        now = time.monotonic()
        if not self._bucket.consume(now):
            self._flooded += 1
            return
        if self._node.count_publishers(self._topic) != self._publishers:
            self.look()
        if len(data) > self._bytes_max:
            write_line(self._out, {"too_large": len(data)})
            return
        write_line(self._out, {"scan": base64.b64encode(data).decode(), "at": now})


if __name__ == "__main__":
    hear_scans()
