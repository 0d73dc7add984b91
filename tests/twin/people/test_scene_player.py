"""Simulated people in the room: rays hit them, tracking loses what they hide, hulls touch them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from housefly.config.site import Site, changed
from housefly.geometry import Vec3
from housefly.messages import Pose
from housefly.room.model import Room
from housefly.twin.camera.messages import PictureRequest
from housefly.twin.contracts import DroneCamera
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.people import Scene, load_scene, scene_from_tree
from housefly.twin.world import SimulatedWorld

MakeRoom = Callable[..., Room]


def scene(
    *steps: dict[str, Any], start: tuple[float, float] | None = (5.0, 2.5), **keys: Any
) -> Scene:
    return scene_from_tree(
        {
            "name": "t",
            "people": [
                {"name": "ann", "start": start, "height": 1.6, "steps": list(steps), **keys}
            ],
        }
    )


def world(make_room: MakeRoom, played: Scene | None, **values: Any) -> SimulatedWorld:
    return SimulatedWorld(changed(Site(), **values), make_room(visitor=(9.0, 2.5)), played)


def ray(world: SimulatedWorld, start: Vec3, direction: Vec3) -> tuple[float, str]:
    """Return how far a ray runs [m], and the name of what it meets."""
    physics, geom = world._physics, np.zeros(1, np.int32)
    length = mujoco.mj_ray(
        physics.model, physics.data, np.array(start), np.array(direction), None, 1, -1, geom
    )
    return length, physics.model.geom(int(geom[0])).name if geom[0] >= 0 else ""


def test_a_ray_meets_somebody_who_stands_there_and_nobody_who_went(make_room: MakeRoom) -> None:
    walked = world(
        make_room,
        scene({"do": "wait", "seconds": 1.0}, {"do": "go", "to": [5.0, 4.5], "speed": 2.0}),
    )
    walked.advance(0.5)
    length, name = ray(walked, (3.0, 2.5, 1.0), (1.0, 0.0, 0.0))
    assert (name, length) == ("person ann trunk", pytest.approx(2.0 - 0.17, abs=0.01))
    walked.advance(2.0)
    assert not ray(walked, (3.0, 2.5, 1.0), (1.0, 0.0, 0.0))[1].startswith("person")
    assert ray(walked, (3.0, 4.5, 1.0), (1.0, 0.0, 0.0))[1] == "person ann trunk"


@pytest.mark.parametrize(
    ("step", "top"),
    [
        ({"do": "wait", "seconds": 9}, 1.6),
        ({"do": "sit", "at": [5.0, 2.5], "seat": 0.45, "seconds": 9}, 0.45 + 0.17 + 0.48 * 1.6),
        ({"do": "lie", "at": [5.0, 2.5], "height": 0.5, "seconds": 9}, 0.5 + 2 * 0.17),
    ],
)
def test_who_stands_is_as_tall_as_they_are_who_sits_and_lies_is_lower(
    make_room: MakeRoom, step: dict[str, Any], top: float
) -> None:
    resting = world(make_room, scene(step))
    resting.advance(0.5)
    length, name = ray(resting, (5.0, 2.5, 2.5), (0.0, 0.0, -1.0))
    assert name.startswith("person ann")
    assert 2.5 - length == pytest.approx(top, abs=0.02)


def test_somebody_who_is_away_is_nowhere_in_the_room(make_room: MakeRoom) -> None:
    away = world(make_room, scene(start=None))
    away.advance(0.1)
    assert away.people()[0].position[2] < -10.0


def test_the_drone_that_flies_into_somebody_touches_them(make_room: MakeRoom) -> None:
    standing = world(make_room, scene())
    standing.put_drone((5.0 - 0.17 - 0.25, 2.5, 1.0), 0.0)
    standing.advance(0.01)
    assert standing.truth().contacts > 0


def test_tracking_loses_a_drone_that_people_hide(
    make_room: MakeRoom, ceiling_cameras: tuple[Any, ...]
) -> None:
    """The cameras look straight down; a tall person bends over the pad."""
    room = make_room(cameras=ceiling_cameras)
    bent = scene(
        {"do": "wait", "seconds": 0.5}, {"do": "lie", "at": [2.0, 2.5], "height": 1.0, "seconds": 9}
    )
    hidden = SimulatedWorld(Site(), room, bent)
    hidden.advance(0.3)
    assert hidden.mocap_frames()[-1].bodies[0][1] is not None
    hidden.advance(0.7)
    assert hidden.mocap_frames()[-1].bodies[0][1] is None


def test_the_scenes_visitor_is_the_rooms_and_comes_and_goes_by_the_script(
    make_room: MakeRoom,
) -> None:
    steps = (
        {"do": "wait", "seconds": 1.0},
        {"do": "appear", "at": [9.0, 2.5]},
        {"do": "wait", "seconds": 1.0},
        {"do": "vanish"},
    )
    rung = world(make_room, scene(*steps, start=None, visitor=True))
    present = []
    for _ in range(3):
        rung.advance(0.7)
        present.append((rung.visitor_present, rung.mocap_frames()[-1].bodies[1][1] is not None))
    assert present == [(False, False), (True, True), (False, False)]
    assert rung.people() == ()
    rung.set_visitor(True)
    rung.advance(0.5)
    assert rung.visitor_present, (
        "between the script's comings and goings somebody else may call the visitor"
    )


def test_a_flight_among_people_is_the_same_bit_for_bit() -> None:
    def fly() -> list[object]:
        from housefly.room.files import load_room

        peopled = SimulatedWorld(
            changed(Site(), twin__seed=3), load_room("bsen"), load_scene("bsen")
        )
        peopled.request_take_off()
        peopled.advance(2.0)
        return [peopled.truth(), peopled.mocap_frames(), peopled.people()]

    assert fly() == fly()


def test_a_request_for_a_picture_carries_the_people() -> None:
    people = (
        Pose((1.0, 2.0, 3.0), (1.0, 0.0, 0.0, 0.0)),
        Pose((4.0, 5.0, 6.0), (0.0, 1.0, 0.0, 0.0)),
    )
    request = PictureRequest(people[0], True, DroneCamera.FRONT, 2.5, people)
    assert PictureRequest.unpack(request.pack()) == request


def test_tracking_loses_a_visitor_when_somebody_comes_between(
    make_room: MakeRoom, ceiling_cameras: tuple[Any, ...]
) -> None:
    room = make_room(cameras=ceiling_cameras, visitor=(2.0, 2.6))
    between = scene(
        {"do": "wait", "seconds": 0.5}, {"do": "lie", "at": [2.0, 2.6], "height": 1.9, "seconds": 9}
    )
    crowded = SimulatedWorld(Site(), room, between)
    crowded.advance(0.3)
    assert crowded.mocap_frames()[-1].bodies[1][1] is not None
    crowded.advance(0.7)
    assert crowded.mocap_frames()[-1].bodies[1][1] is None
