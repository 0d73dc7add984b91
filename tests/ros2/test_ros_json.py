"""ROS messages as JSON hold what rclpy's own messages hold, and are read back strictly."""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Iterator
from math import isfinite, isnan, nan
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.interfaces import type_store
from housefly.config.airframe import airframe_named
from housefly.errors import WireError
from housefly.hub.api.answers import PlacedThing
from housefly.messages import (
    DroneStatus,
    Estimate,
    Event,
    LinkStatus,
    Obstacle,
    Path,
    PlannedTrajectory,
    Pose,
    Severity,
    Telemetry,
    TrajectoryPoint,
    VideoFrame,
)
from housefly.messages.words import literal
from housefly.record import ros_messages
from housefly.ros2 import diagnostics, room_messages
from housefly.ros2.drone_messages import (
    RosFrames,
    camera_info,
    compressed_image,
    text_message,
    trajectory_message,
)
from housefly.ros2.ros_json import full_type, json_tree, message_of
from housefly.ros2.topic_table import DRONE_TOPICS, ROOM_TOPICS
from housefly.sites.loaded_site import load_site

FRAMES = RosFrames.of("map", "drone")


def messages() -> Iterator[Any]:
    """Yield a message of every type that the room tells."""
    camera = airframe_named("ardrone").capabilities.camera
    assert camera is not None
    picture = VideoFrame(b"\0\0\0\1", True, 640, 360, 1, 1.0)
    thing = PlacedThing("cup", "cup", "object", (1.0, 2.0, 0.5), None, "", 1.0)
    loaded = load_site("bsen")
    point = TrajectoryPoint((1.0, 2.0, 1.5), 0.25, 0.0)
    yield ros_messages.pose_stamped(1.7e9 + 0.25, Pose((1.0, 2.0, 1.1)), "map")
    yield ros_messages.odometry(Estimate(9.0, (1.0, 2.0, 1.1), (0.3, 0.0, 0.0), 0.5, 0.02, 0.01))
    yield ros_messages.planned_path(1.0, Path(((1.0, 2.0), (3.0, 4.0)), 2.8, 0.5), 1.1)
    yield ros_messages.battery_state(Telemetry(1.0, DroneStatus.FLYING, 0.75))
    yield ros_messages.log_message(Event(1.0, Severity.FAULT, "link", literal("it is gone")))
    yield ros_messages.occupancy(1.0, loaded.grid, "map")
    yield ros_messages.transform_message(1.0, "map", "drone", (1.0, 2.0, 3.0))
    yield trajectory_message(PlannedTrajectory(2.0, (point,)), 1.7e9, FRAMES)
    yield camera_info(1.0, FRAMES, camera, picture)
    yield compressed_image(1.0, FRAMES, "jpeg", b"\xff\xd8abc")
    yield text_message("grün \U0001f681")
    yield room_messages.room_markers(1.0, "map", loaded.room.solids)
    yield room_messages.thing_markers(1.0, "map", (thing,))
    yield room_messages.people_message(1.0, "map", (thing,))
    yield room_messages.obstacle_markers(1.0, "map", (Obstacle("1", (2.0, 2.0)),))
    status = diagnostics.link_status("drone", LinkStatus(1.0))
    yield diagnostics.diagnostics_message(1.0, [status])


def by_rclpy(message: Any) -> Any:
    """Return a message as rclpy reads its bytes; skips where the package is not installed."""
    name: str = message.__msgtype__
    package, kind, interface = name.split("/")
    serialization = pytest.importorskip("rclpy.serialization")
    type_ = getattr(pytest.importorskip(f"{package}.{kind}"), interface)
    raw = bytes(type_store().serialize_cdr(message, name))
    return serialization.deserialize_message(raw, type_)


def tree_of_rclpy(value: Any, kind: str) -> Any:
    """Return a value of rclpy as rosbridge has it, by rclpy's own names of types."""
    if hasattr(value, "get_fields_and_field_types"):
        fields = value.get_fields_and_field_types()
        return {name: tree_of_rclpy(getattr(value, name), one) for name, one in fields.items()}
    if kind == "octet":
        return int.from_bytes(value, "little")
    if "[" in kind or kind.startswith("sequence<"):
        inner = kind.partition("[")[0].removeprefix("sequence<").rstrip(">")
        if inner == "uint8":
            return b64encode(bytes(value)).decode()
        return [tree_of_rclpy(one, inner) for one in value]
    if kind in ("float", "double"):
        return float(value) if isfinite(value) else None
    return value


@pytest.mark.parametrize(
    "message", tuple(messages()), ids=lambda one: one.__msgtype__.split("/")[-1]
)
def test_json_has_the_fields_and_values_of_rclpy(message: Any) -> None:
    told = json.loads(json.dumps(json_tree(message), allow_nan=False))
    assert told == tree_of_rclpy(by_rclpy(message), "")


def test_every_type_of_the_table_is_tried_above() -> None:
    tried = {one.__msgtype__ for one in messages()}
    assert {one.type for one in (*DRONE_TOPICS, *ROOM_TOPICS)} <= tried


number = st.floats(allow_nan=False, allow_infinity=False)


@given(number, st.text(max_size=20), st.integers(-(2**31), 2**31 - 1))
def test_what_is_told_is_read_back(x: float, frame: str, second: int) -> None:
    tree = {
        "header": {"stamp": {"sec": second, "nanosec": 5}, "frame_id": frame},
        "pose": {"position": {"x": x, "y": 1, "z": 0.0}, "orientation": {"w": 1.0}},
    }
    message = message_of(tree, "geometry_msgs/msg/PoseStamped")
    again = json_tree(message)
    assert again["pose"]["position"] == {"x": x, "y": 1.0, "z": 0.0}
    assert again["header"] == {"stamp": {"sec": second, "nanosec": 5}, "frame_id": frame}
    assert type_store().serialize_cdr(message, "geometry_msgs/msg/PoseStamped")


trees = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["x", "data", "pose", "header", "stamp", "w"]), inner)
    ),
)


@given(trees, st.sampled_from(["PoseStamped", "Twist"]))
def test_any_tree_is_a_message_or_refused_in_words(tree: Any, kind: str) -> None:
    full = f"geometry_msgs/msg/{kind}"
    try:
        message = message_of(tree, full)
    except WireError as error:
        assert "allowed" in str(error) or "there are" in str(error)
    else:
        assert type_store().serialize_cdr(message, full)


def test_null_is_no_number_and_short_names_are_full_ones() -> None:
    twist = message_of({"linear": {"x": None}}, "geometry_msgs/msg/Twist")
    assert isnan(twist.linear.x) and isnan(nan)
    assert full_type("std_msgs/String") == full_type("std_msgs/msg/String") == "std_msgs/msg/String"
    with pytest.raises(WireError, match=r"msg\.data is 7; allowed: text"):
        message_of({"data": 7}, "std_msgs/msg/String")
