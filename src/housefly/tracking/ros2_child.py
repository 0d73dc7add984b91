"""Hears poses on ROS 2 topics; writes one line a pose, and once a second the topics that it hears.

``tracking.ros2`` starts it; it ends with its parent.
"""

from __future__ import annotations

import importlib
import json
import os
import re
import sys
import threading
from collections.abc import Callable, Iterator
from typing import IO, Any

_LOOK_PERIOD = 1.0
"""How often new topics are looked for [s]."""

Pose = tuple[float, ...]
"""Position x, y, z and orientation w, x, y, z."""
Told = tuple[str, Any, Pose]
"""Name of the body ("": that of the topic), stamp, pose."""


def hear_poses() -> None:
    """Hear poses until the parent is gone."""
    settings = json.loads(sys.argv[1])
    out = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)  # what the library itself prints
    threading.Thread(target=_end_with_parent, daemon=True).start()
    try:
        _hear(settings, out)
    except BrokenPipeError:
        return
    except Exception as error:  # whatever the library raises; the parent says it in words
        _write(out, {"problem": str(error) or type(error).__name__})


def topic_pattern(topic: str) -> re.Pattern[str]:
    """Return what finds the topics, with the body's name as ``body``, of ``tracking.ros_topic``."""
    before, _, after = topic.partition("{body}")
    body = r"(?P<body>\w+)" if "{body}" in topic else ""
    return re.compile(re.escape(before) + body + re.escape(after))


def _hear(settings: dict[str, Any], out: IO[str]) -> None:
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = settings["discovery"].upper()
    rclpy = importlib.import_module("rclpy")
    qos = importlib.import_module("rclpy.qos").qos_profile_sensor_data
    rclpy.init(args=[], domain_id=settings["domain"])
    node = rclpy.create_node("housefly_tracking")
    pattern, heard = topic_pattern(settings["topic"]), set[str]()

    def look() -> None:
        for name, kinds in node.get_topic_names_and_types():
            found = pattern.fullmatch(name)
            if found is None or name in heard or kinds[0] not in READERS:
                continue
            heard.add(name)
            body = found.groupdict().get("body") or name.strip("/").replace("/", "_")
            package, kind, interface = kinds[0].split("/")
            message_type = getattr(importlib.import_module(f"{package}.{kind}"), interface)
            receive = _receiver(READERS[kinds[0]], body, out)
            node.create_subscription(message_type, name, receive, qos)
        _write(out, {"topics": sorted(heard)})

    node.create_timer(_LOOK_PERIOD, look)
    look()
    rclpy.spin(node)


def _receiver(
    read: Callable[[Any], Iterator[Told]], body: str, out: IO[str]
) -> Callable[[Any], None]:
    def receive(message: Any) -> None:
        for name, stamp, pose in read(message):
            at = stamp.sec * 1_000_000_000 + stamp.nanosec
            _write(out, {"body": name or body, "stamp": at, "pose": pose})

    return receive


def _of_pose(pose: Any) -> Pose:
    return _numbers(pose.position, pose.orientation)


def _numbers(place: Any, turn: Any) -> Pose:
    return place.x, place.y, place.z, turn.w, turn.x, turn.y, turn.z


def _stamped(message: Any) -> Iterator[Told]:
    yield "", message.header.stamp, _of_pose(message.pose)


def _with_covariance(message: Any) -> Iterator[Told]:
    yield "", message.header.stamp, _of_pose(message.pose.pose)


def _transform(message: Any) -> Iterator[Told]:
    moved = message.transform
    yield "", message.header.stamp, _numbers(moved.translation, moved.rotation)


def _transforms(message: Any) -> Iterator[Told]:
    for one in message.transforms:
        moved = one.transform
        yield one.child_frame_id, one.header.stamp, _numbers(moved.translation, moved.rotation)


READERS: dict[str, Callable[[Any], Iterator[Told]]] = {
    "geometry_msgs/msg/PoseStamped": _stamped,
    "geometry_msgs/msg/PoseWithCovarianceStamped": _with_covariance,
    "geometry_msgs/msg/TransformStamped": _transform,
    "nav_msgs/msg/Odometry": _with_covariance,
    "tf2_msgs/msg/TFMessage": _transforms,
}
"""How each type of message tells poses."""


def _write(out: IO[str], line: dict[str, Any]) -> None:
    out.write(json.dumps(line) + "\n")


def _end_with_parent() -> None:
    sys.stdin.buffer.read()
    os._exit(0)


if __name__ == "__main__":
    hear_poses()
