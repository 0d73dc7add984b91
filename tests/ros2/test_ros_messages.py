"""What goes to ROS is read by ROS's own reader, with the values that it was made of."""

from __future__ import annotations

import importlib
from math import pi
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.interfaces import type_store
from housefly.config.airframe import airframe_named
from housefly.geometry import yaw_of
from housefly.hub.api.answers import PlacedThing, SensorAnswer
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    LinkStatus,
    Obstacle,
    ObstacleKind,
    Outputs,
    Path,
    Phase,
    PilotStep,
    PlannedTrajectory,
    Pose,
    SafetyMode,
    Sighting,
    Telemetry,
    TrajectoryPoint,
    VideoFrame,
)
from housefly.messages.words import UNSAID, Words
from housefly.record import ros_messages
from housefly.room.bsen import bsen
from housefly.ros2 import diagnostics, room_messages
from housefly.ros2.drone_messages import (
    DroneMessages,
    RosFrames,
    camera_info,
    compressed_image,
    trajectory_message,
)
from housefly.ros2.paper.autonomy import navdata, world_velocity

FRAMES = RosFrames.of("map", "drone")
OFFSET = 1.7e9
number = st.floats(-1e3, 1e3)
point = st.tuples(number, number, number)


def by_ros(message: Any) -> Any:
    """Return a message as ROS's own code reads its bytes; skips where ROS is not installed."""
    name: str = message.__msgtype__
    package, kind, interface = name.split("/")
    serialization = pytest.importorskip("rclpy.serialization")
    type_ = getattr(importlib.import_module(f"{package}.{kind}"), interface)
    return serialization.deserialize_message(
        bytes(type_store().serialize_cdr(message, name)), type_
    )


def step(**given: Any) -> PilotStep:
    estimate = Estimate(9.98, (1.0, 2.0, 1.1), (0.3, 0.0, 0.0), pi / 2, 0.02, 0.01)
    inputs = Inputs(
        sightings=(
            Sighting("ardrone", Pose((1.0, 2.0, 1.1), (0.0, 0.0, 0.0, 1.0)), 9.99, 10.0),
            Sighting("visitor", Pose((5.0, 5.0, 1.7)), 9.99, 10.0),
        ),
        telemetry=Telemetry(9.9, DroneStatus.FLYING, 0.75),
    )
    outputs = Outputs(Command(Action.IDLE), estimate, phase=Phase.HOLDING, **given)
    return PilotStep(7, 10.0, inputs, outputs)


def told(messages: DroneMessages, one: PilotStep) -> dict[str, Any]:
    return {topic.name: make() for topic, make in messages.of(one, OFFSET)}


def test_a_step_says_pose_odometry_charge_and_phase_with_the_stamps_of_capture() -> None:
    way = Path(((1.0, 2.0), (3.0, 4.0)), 2.8, 0.5)
    found = told(DroneMessages("ardrone", FRAMES, 1.1), step(path=way))
    assert set(found) == {"pose", "/tf", "odom", "battery", "phase", "path"}
    pose, odometry = by_ros(found["pose"]), by_ros(found["odom"])
    assert pose.header.stamp.sec + 1e-9 * pose.header.stamp.nanosec == pytest.approx(OFFSET + 9.99)
    assert (pose.header.frame_id, odometry.child_frame_id) == ("map", "drone/base_link")
    # Flown along x with the nose along y, it moves to its right.
    assert odometry.twist.twist.linear.y == pytest.approx(-0.3)
    assert by_ros(found["battery"]).percentage == pytest.approx(0.75)
    assert by_ros(found["phase"]).data == "holding"
    assert [one.pose.position.x for one in by_ros(found["path"]).poses] == [1.0, 3.0]


def test_what_has_not_changed_is_not_said_again() -> None:
    messages = DroneMessages("ardrone", FRAMES, 1.1)
    told(messages, step())
    assert set(told(messages, step())) == {"pose", "/tf", "odom"}


@given(point, st.floats(-3.1, 3.1))
def test_any_pose_arrives_as_it_was(position: tuple[float, float, float], yaw: float) -> None:
    message = ros_messages.pose_stamped(1.0, Pose(position, ros_messages.about_z(yaw)), "map")
    pose = by_ros(message).pose
    assert (pose.position.x, pose.position.y, pose.position.z) == position
    turn = pose.orientation
    assert yaw_of((turn.w, turn.x, turn.y, turn.z)) == pytest.approx(yaw)


def test_a_trajectory_keeps_places_and_times() -> None:
    planned = PlannedTrajectory(
        2.0,
        (TrajectoryPoint((1.0, 2.0, 1.5), 0.0, 0.0), TrajectoryPoint((4.0, 2.0, 1.5), 3.25, 1.0)),
    )
    points = by_ros(trajectory_message(planned, OFFSET, FRAMES)).points
    assert [one.transforms[0].translation.x for one in points] == [1.0, 4.0]
    assert (points[1].time_from_start.sec, points[1].time_from_start.nanosec) == (3, 250_000_000)


def test_the_camera_is_a_pinhole_that_looks_ahead() -> None:
    camera = airframe_named("ardrone").capabilities.camera
    assert camera is not None
    frame = VideoFrame(b"\0\0\0\1", True, 640, 360, 1, 1.0)
    info = by_ros(camera_info(1.0, FRAMES, camera, frame))
    assert (info.width, info.height, info.k[2], info.k[5]) == (640, 360, 320.0, 180.0)
    assert info.k[0] == pytest.approx(info.k[4], rel=0.05), "square pixels"
    image = by_ros(compressed_image(1.0, FRAMES, "jpeg", b"abc"))
    assert (image.format, bytes(image.data)) == ("jpeg", b"abc")


def test_the_room_is_drawn_with_all_its_solids() -> None:
    solids = bsen().solids
    markers = by_ros(room_messages.room_markers(1.0, "map", solids)).markers
    assert len(markers) == len(solids)
    assert {one.type for one in markers} <= {1, 3}
    assert len({(one.ns, one.id) for one in markers}) == len(markers)


def test_things_people_and_obstacles_have_their_places() -> None:
    cup = PlacedThing("cup", "the cup", "object", (1.0, 2.0, 0.8), None, "", 3.0)
    lost = PlacedThing("key", "the key", "object", None, None, "", None)
    markers = by_ros(room_messages.thing_markers(1.0, "map", (cup, lost))).markers
    assert [one.text for one in markers] == ["", "", "the cup"]
    assert len(by_ros(room_messages.people_message(1.0, "map", (cup, lost))).poses) == 1
    person = Obstacle("p1", (3.0, 4.0), radius=0.3, top=1.8, kind=ObstacleKind.PERSON)
    seen = by_ros(room_messages.obstacle_markers(1.0, "map", (person,))).markers[0]
    assert (seen.ns, seen.scale.x, seen.pose.position.z) == ("obstacles", 0.6, 0.9)


def test_diagnostics_say_what_is_wrong_by_their_level() -> None:
    sensor = SensorAnswer(
        "lidar", "laser scanner", "Scanner", False, 0.0, None, Words("silent"), {}
    )
    held = step(safety=SafetyMode.HOLD, reason=Words("people are unseen"))
    statuses = [
        diagnostics.flight_status("drone", step()),
        diagnostics.flight_status("drone", held),
        diagnostics.flight_status("drone", step(safety=SafetyMode.LAND, reason=UNSAID)),
        diagnostics.link_status("drone", LinkStatus(1.0)),
        diagnostics.sensor_status(sensor),
    ]
    found = by_ros(diagnostics.diagnostics_message(1.0, statuses)).status
    assert [one.level[0] for one in found] == [0, 1, 2, 1, 3]
    assert (found[1].message, found[4].message) == ("people are unseen", "silent")


@given(point, st.floats(-pi, pi))
def test_a_stick_never_asks_for_more_than_the_speed_by_hand(
    stick: tuple[float, float, float], yaw: float
) -> None:
    velocity = world_velocity(stick, yaw, 0.5)
    assert max(map(abs, velocity)) <= 0.5 * 2**0.5 + 1e-9


def test_navdata_has_the_units_of_the_papers_node() -> None:
    telemetry = Telemetry(
        1.0, DroneStatus.FLYING, 0.5, phi=pi / 6, height=1.1, velocity=(0.3, 0, 0)
    )
    from housefly.ros2.paper import autonomy

    autonomy.register_navdata()
    data = navdata(1.0, telemetry, "drone/base_link")
    assert (data.batteryPercent, data.state, data.altd, data.vx) == (50.0, 4, 1100, 300.0)
    assert data.rotX == pytest.approx(30.0)
    assert type_store().serialize_cdr(data, data.__msgtype__)
