"""Hears poses on ROS 2 topics; writes one line a pose, and once a second the topics that it hears.

``tracking.ros2`` starts it; it ends with its parent.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable, Iterator
from typing import IO, Any

from housefly.bus.ros2_child import ros2_node, ros2_type, run_ros2_child, write_line

_LOOK_PERIOD = 1.0
"""How often new topics are looked for [s]."""

Pose = tuple[float, ...]
"""Position x, y, z and orientation w, x, y, z."""
Told = tuple[str, Any, Pose]
"""Name of the body ("": that of the topic), stamp, pose."""


def hear_poses() -> None:
    """Hear poses until the parent is gone."""
    run_ros2_child(_hear)


def topic_pattern(topic: str) -> re.Pattern[str]:
    """Return what finds the topics, with the body's name as ``body``, of ``tracking.ros_topic``."""
    before, _, after = topic.partition("{body}")
    body = r"(?P<body>\w+)" if "{body}" in topic else ""
    return re.compile(re.escape(before) + body + re.escape(after))


def _hear(settings: dict[str, Any], out: IO[str]) -> None:
    node = ros2_node("housefly_tracking", settings)
    qos = importlib.import_module("rclpy.qos").qos_profile_sensor_data
    pattern, heard = topic_pattern(settings["topic"]), set[str]()

    def look() -> None:
        for name, kinds in node.get_topic_names_and_types():
            found = pattern.fullmatch(name)
            if found is None or name in heard or kinds[0] not in READERS:
                continue
            heard.add(name)
            body = found.groupdict().get("body") or name.strip("/").replace("/", "_")
            receive = _receiver(READERS[kinds[0]], body, out)
            node.create_subscription(ros2_type(kinds[0]), name, receive, qos)
        write_line(out, {"topics": sorted(heard)})

    node.create_timer(_LOOK_PERIOD, look)
    look()
    importlib.import_module("rclpy").spin(node)


def _receiver(
    read: Callable[[Any], Iterator[Told]], body: str, out: IO[str]
) -> Callable[[Any], None]:
    def receive(message: Any) -> None:
        for name, stamp, pose in read(message):
            at = stamp.sec * 1_000_000_000 + stamp.nanosec
            write_line(out, {"body": name or body, "stamp": at, "pose": pose})

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


if __name__ == "__main__":
    hear_poses()
