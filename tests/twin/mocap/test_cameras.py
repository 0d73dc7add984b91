"""Which bodies the simulated tracking cameras see."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import pytest

from housefly.geometry import distance, quaternion_from_euler, rotate
from housefly.messages import Pose
from housefly.room.files import load_room
from housefly.room.model import Room, Shape, Solid, TrackingCamera
from housefly.twin.world import SimulatedWorld

MakeWorld = Callable[..., SimulatedWorld]
MakeRoom = Callable[..., Room]
Cameras = tuple[TrackingCamera, ...]
POSE = Pose((1.0, 2.0, 3.0), quaternion_from_euler(0.1, -0.2, 2.5))


def sees_drone(world: SimulatedWorld) -> bool:
    world.mocap_frames()
    world.advance(0.2)
    return world.mocap_frames()[-1].bodies[0][1] is not None


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
