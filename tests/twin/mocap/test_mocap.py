"""What the simulated tracking system sees, how often, how late and how well."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.geometry import distance, quaternion_from_euler, rotate
from housefly.messages import Pose
from housefly.room.files import load_room
from housefly.room.model import Room, Shape, Solid, TrackingCamera
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.mocap import LEVER_ARM, FrameMaker
from housefly.twin.world import SimulatedWorld

MakeWorld = Callable[..., SimulatedWorld]
MakeRoom = Callable[..., Room]
Cameras = tuple[TrackingCamera, ...]
POSE = Pose((1.0, 2.0, 3.0), quaternion_from_euler(0.1, -0.2, 2.5))


def run(frames: FrameMaker, seconds: float) -> list[MocapFrame]:
    taken: list[MocapFrame] = []
    for tick in range(round(seconds / 0.005)):
        now = tick * 0.005
        if frames.is_due(now):
            frames.expose(now, (("body", POSE),))
        taken.extend(frames.take(now))
    return taken


def maker(seed: int = 1, **twin: float) -> FrameMaker:
    return FrameMaker(
        changed(Site(), **{f"twin__{key}": value for key, value in twin.items()}),
        np.random.default_rng(seed),
    )


def sees_drone(world: SimulatedWorld) -> bool:
    world.mocap_frames()
    world.advance(0.2)
    return world.mocap_frames()[-1].bodies[0][1] is not None


@pytest.mark.parametrize("rate", [10.0, 30.0, 100.0, 200.0])
def test_frames_come_at_the_configured_rate(rate: float) -> None:
    frames = run(maker(mocap_rate_hz=rate, mocap_latency=0.0), 10.0)
    assert len(frames) == pytest.approx(10 * rate, abs=2)


def test_frames_leave_after_the_latency_and_a_little_jitter() -> None:
    frames = run(maker(mocap_latency=0.03), 10.0)
    delays = [frame.due_at - frame.captured_at for frame in frames]
    assert min(delays) >= 0.03
    assert max(delays) < 0.04
    assert np.std(delays) > 0.0001


def test_lost_frames_are_missing_but_counted() -> None:
    frames = run(maker(mocap_dropout=0.3), 20.0)
    assert len(frames) == pytest.approx(2000 * 0.7, rel=0.05)
    assert frames[-1].number > 1980


def test_a_system_that_loses_everything_says_nothing() -> None:
    assert run(maker(mocap_dropout=1.0), 1.0) == []


def test_noise_is_as_large_as_configured_and_has_no_bias() -> None:
    poses = [frame.bodies[0][1] for frame in run(maker(mocap_noise=0.002), 30.0)]
    errors = np.array([pose.position for pose in poses if pose]) - POSE.position
    assert errors.std(axis=0) == pytest.approx((0.002,) * 3, rel=0.1)
    assert errors.mean(axis=0) == pytest.approx((0.0,) * 3, abs=0.0002)
    yaws = np.array([pose.yaw - POSE.yaw for pose in poses if pose])
    assert yaws.std() == pytest.approx(0.002 / LEVER_ARM, rel=0.15)


def test_without_noise_the_pose_is_the_truth() -> None:
    pose = run(maker(mocap_noise=0.0), 0.1)[0].bodies[0][1]
    assert pose is not None
    assert pose.position == POSE.position
    assert pose.orientation == pytest.approx(POSE.orientation)


@given(st.integers(0, 2**31), st.floats(1, 200), st.floats(0, 0.5), st.floats(0, 1))
def test_frames_are_ordered_and_none_leaves_before_it_was_taken(
    seed: int, rate: float, latency: float, dropout: float
) -> None:
    frames = run(maker(seed, mocap_rate_hz=rate, mocap_latency=latency, mocap_dropout=dropout), 1.0)
    assert [frame.number for frame in frames] == sorted({frame.number for frame in frames})
    dues = [frame.due_at for frame in frames]
    assert dues == sorted(dues)
    assert all(frame.due_at >= frame.captured_at + latency for frame in frames)


def test_cameras_above_the_pad_see_the_drone(
    make_world: MakeWorld, make_room: MakeRoom, ceiling_cameras: Cameras
) -> None:
    assert sees_drone(make_world(make_room(cameras=ceiling_cameras)))


def test_one_camera_is_not_enough(
    make_world: MakeWorld, make_room: MakeRoom, ceiling_cameras: Cameras
) -> None:
    assert not sees_drone(make_world(make_room(cameras=ceiling_cameras[:1])))


def test_out_of_every_cameras_view_the_drone_is_not_seen(
    make_world: MakeWorld, make_room: MakeRoom, ceiling_cameras: Cameras
) -> None:
    assert all(
        distance(camera.position, (5.5, 2.5, 0.05)) < camera.reach for camera in ceiling_cameras
    )
    world = make_world(make_room(cameras=ceiling_cameras))
    world.put_drone((5.5, 2.5, 0.05))
    assert not sees_drone(world)
    world.put_drone()
    assert sees_drone(world)


def test_beyond_their_reach_cameras_see_nothing(
    make_world: MakeWorld, make_room: MakeRoom, ceiling_cameras: Cameras
) -> None:
    near_sighted = tuple(
        TrackingCamera(c.name, c.position, c.orientation, c.field_of_view, 1.0)
        for c in ceiling_cameras
    )
    world = make_world(make_room(cameras=near_sighted))
    assert not sees_drone(world)


def test_under_a_table_the_drone_is_hidden(
    make_world: MakeWorld, make_room: MakeRoom, ceiling_cameras: Cameras
) -> None:
    table = Solid("top", "table", Shape.BOX, (2.0, 2.5, 0.7), (1.6, 1.6, 0.05))
    assert not sees_drone(make_world(make_room((table,), ceiling_cameras)))


def test_a_room_without_cameras_is_seen_everywhere(
    make_world: MakeWorld, make_room: MakeRoom
) -> None:
    lid = Solid("top", "table", Shape.BOX, (2.0, 2.5, 0.7), (1.6, 1.6, 0.05))
    assert sees_drone(make_world(make_room((lid,))))


def test_the_visitor_is_seen_at_the_door_and_not_when_away(make_world: MakeWorld) -> None:
    world = make_world(load_room("bsen"))

    def visitor() -> Pose | None:
        world.mocap_frames()
        world.advance(0.1)
        return world.mocap_frames()[-1].bodies[1][1]

    room = load_room("bsen")
    there = visitor()
    assert there is not None
    assert room.visitor is not None
    assert distance(there.position[:2], room.visitor) < 0.02
    world.set_visitor(False)
    assert visitor() is None
    world.set_visitor(True)
    assert visitor() is not None


def test_the_cameras_of_bsen_see_the_drone_on_its_pad_and_in_the_middle_of_the_room(
    make_world: MakeWorld,
) -> None:
    room = load_room("bsen")
    world = make_world(room)
    assert sees_drone(world)
    world.put_drone((6.0, 2.5, 1.2))
    world.mocap_frames()
    world.advance(0.05)
    assert world.mocap_frames()[-1].bodies[0][1] is not None


def test_cameras_look_along_their_own_z(ceiling_cameras: Cameras) -> None:
    assert rotate(ceiling_cameras[0].orientation, (0.0, 0.0, 1.0)) == pytest.approx(
        (0.0, 0.0, -1.0)
    )
    assert pi > ceiling_cameras[0].field_of_view[0]
