"""ROS bags of others: rosbag 1, rosbag2 folders, and single MCAP files of ROS 2 messages."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path
from typing import Any

from housefly.bus.interfaces import recorded_store
from housefly.errors import RecordingError
from housefly.geometry import Quaternion, euler_from_quaternion, normalized, rotate, yaw_of
from housefly.messages import Severity
from housefly.record.flight_log import FlightLog, LogEvent, LogSamples, Quantity, on_one_time
from housefly.record.mcap_reader import read_messages

_SEVERE, _WARNING = 40, 30
_ROS1_SEVERE, _ROS1_WARNING = 8, 4
_EVENTS_KEPT = 2000
_SETPOINT = ("setpoint", "cmd", "goal", "reference", "target", "desired")
"""A topic with one of these in its name says what was wanted, not what was."""

BagMessage = tuple[str, str, float, Any]
"""Topic, type, time [s], message."""


@dataclass(frozen=True, slots=True)
class _Source:
    """Which messages tell a quantity: types by preference, and how one is read."""

    quantity: Quantity
    type_name: str
    is_wanted: bool
    read: Callable[[Any], tuple[float, ...]]


def read_bag(path: Path) -> FlightLog:
    """Return a bag as a log; of each quantity the topic of the best type with most messages counts.

    Args:
        path: a .bag, a folder with ``metadata.yaml``, or an .mcap.

    Raises:
        RecordingError: it cannot be read at all, or holds no pose.
    """
    kind = "rosbag 1" if path.suffix == ".bag" else "rosbag2"
    contents = _Contents()
    problems: list[str] = []
    try:
        for message in _messages(path):
            contents.take(*message)
    except Exception as error:  # whatever a damaged file makes the libraries raise
        words = str(error) or type(error).__name__
        if not contents.count:
            raise RecordingError(f"{path} cannot be read as a bag: {words}") from error
        problems.append(
            f"cut off or damaged after {contents.count} messages ({words}): what comes later is not"
            " here"
        )
    chosen = _chosen(contents.found)
    return on_one_time(
        kind,
        [contents.found[key] for key in chosen.values()],
        events=contents.events,
        started_at=0.0,
        sources={quantity: topic for quantity, (_, _, topic) in chosen.items()},
        problems=problems,
    )


@dataclass(slots=True)
class _Contents:
    """What was read so far: samples by quantity, rank of the type, and topic; events."""

    found: dict[tuple[Quantity, int, str], LogSamples] = field(default_factory=dict)
    events: list[LogEvent] = field(default_factory=list)
    count: int = 0

    def take(self, topic: str, type_name: str, at: float, message: Any) -> None:
        """Take one message; it counts when all of it could be read."""
        for rank, source in enumerate(_SOURCES):
            if source.type_name == type_name and source.is_wanted == _says_what_is_wanted(topic):
                key = source.quantity, rank, topic
                values = source.read(message)
                if all(map(isfinite, values)):
                    self.found.setdefault(key, LogSamples(source.quantity)).add(at, *values)
        if type_name in _LOGS and len(self.events) < _EVENTS_KEPT:
            self.events.append(_event(at, message, type_name))
        self.count += 1


def _says_what_is_wanted(topic: str) -> bool:
    return any(word in topic.lower() for word in _SETPOINT)


def _chosen(
    found: Mapping[tuple[Quantity, int, str], LogSamples],
) -> dict[Quantity, tuple[Quantity, int, str]]:
    """Return for each quantity the topic of the best type, of several the one with most samples."""
    best: dict[Quantity, tuple[Quantity, int, str]] = {}
    for key, samples in found.items():
        known = best.get(key[0])
        if samples.times and (
            known is None or (key[1], -len(samples.times)) < (known[1], -len(found[known].times))
        ):
            best[key[0]] = key
    return best


def _messages(path: Path) -> Iterator[BagMessage]:
    is_single = path.is_file() and path.suffix != ".bag"
    return _mcap_messages(path) if is_single else _bag_messages(path)


def _bag_messages(path: Path) -> Iterator[BagMessage]:
    from rosbags.highlevel import AnyReader
    from rosbags.typesys import Stores, get_typestore

    wanted = {source.type_name for source in _SOURCES} | _LOGS.keys()
    with AnyReader([path], default_typestore=get_typestore(Stores.ROS2_JAZZY)) as reader:
        used = [one for one in reader.connections if one.msgtype in wanted]
        for one, stamp, data in reader.messages(used) if used else ():
            yield one.topic, one.msgtype, stamp / 1e9, reader.deserialize(data, one.msgtype)


def _mcap_messages(path: Path) -> Iterator[BagMessage]:
    wanted = {source.type_name for source in _SOURCES} | _LOGS.keys()
    for message in read_messages(path):
        if message.type_name in wanted and message.encoding == "cdr":
            store = recorded_store(message.type_name, message.schema)
            value = store.deserialize_cdr(message.data, message.type_name)
            yield message.topic, message.type_name, message.at, value


def _position(pose: Any) -> tuple[float, ...]:
    return pose.position.x, pose.position.y, pose.position.z


def _turn(orientation: Any) -> Quaternion:
    return normalized((orientation.w, orientation.x, orientation.y, orientation.z))


def _attitude(orientation: Any) -> tuple[float, ...]:
    return euler_from_quaternion(_turn(orientation))


def _vector(vector: Any) -> tuple[float, float, float]:
    return vector.x, vector.y, vector.z


def _twist(twist: Any) -> tuple[float, ...]:
    return *_vector(twist.linear), twist.angular.z


def _wanted(pose: Any) -> tuple[float, ...]:
    return *_position(pose), yaw_of(_turn(pose.orientation))


def _world_velocity(odometry: Any) -> tuple[float, ...]:
    """Return the velocity of an Odometry in the world; it is told in the body's own axes."""
    turn = _turn(odometry.pose.pose.orientation)
    return rotate(turn, _vector(odometry.twist.twist.linear))


_ODOMETRY, _POSE = "nav_msgs/msg/Odometry", "geometry_msgs/msg/PoseStamped"
_POSE_COVARIANCE = "geometry_msgs/msg/PoseWithCovarianceStamped"
_TRANSFORM, _TWIST = "geometry_msgs/msg/TransformStamped", "geometry_msgs/msg/TwistStamped"
_SOURCES: tuple[_Source, ...] = (
    _Source(Quantity.POSITION, _ODOMETRY, False, lambda one: _position(one.pose.pose)),
    _Source(Quantity.ATTITUDE, _ODOMETRY, False, lambda one: _attitude(one.pose.pose.orientation)),
    _Source(Quantity.VELOCITY, _ODOMETRY, False, _world_velocity),
    _Source(Quantity.POSITION, _POSE, False, lambda one: _position(one.pose)),
    _Source(Quantity.ATTITUDE, _POSE, False, lambda one: _attitude(one.pose.orientation)),
    _Source(Quantity.POSITION, _POSE_COVARIANCE, False, lambda one: _position(one.pose.pose)),
    _Source(
        Quantity.ATTITUDE, _POSE_COVARIANCE, False, lambda one: _attitude(one.pose.pose.orientation)
    ),
    _Source(Quantity.POSITION, _TRANSFORM, False, lambda one: _vector(one.transform.translation)),
    _Source(Quantity.ATTITUDE, _TRANSFORM, False, lambda one: _attitude(one.transform.rotation)),
    _Source(
        Quantity.ATTITUDE, "sensor_msgs/msg/Imu", False, lambda one: _attitude(one.orientation)
    ),
    _Source(Quantity.VELOCITY, _TWIST, False, lambda one: _vector(one.twist.linear)),
    _Source(Quantity.WANTED, _POSE, True, lambda one: _wanted(one.pose)),
    _Source(Quantity.WANTED_VELOCITY, _TWIST, True, lambda one: _twist(one.twist)),
    _Source(Quantity.WANTED_VELOCITY, "geometry_msgs/msg/Twist", True, _twist),
    _Source(Quantity.BATTERY, "sensor_msgs/msg/BatteryState", False, lambda one: (one.percentage,)),
)
_LOGS: Mapping[str, tuple[int, int]] = {
    "rcl_interfaces/msg/Log": (_SEVERE, _WARNING),
    "rosgraph_msgs/msg/Log": (_ROS1_SEVERE, _ROS1_WARNING),
}
"""Messages of a program's log, and from which level on they are faults and warnings."""


def _event(at: float, message: Any, type_name: str) -> LogEvent:
    severe, warning = _LOGS[type_name]
    level = int(message.level)
    severity = (
        Severity.FAULT
        if level >= severe
        else Severity.WARNING
        if level >= warning
        else Severity.INFO
    )
    return LogEvent(at, severity, str(message.msg))
