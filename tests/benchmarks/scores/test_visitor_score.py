"""What counts as a useful picture of the visitor; ``test_task_campaigns.py`` flies the runs."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

import pytest
from task_flights import premises

from housefly.geometry import Vec3
from housefly.twin.world import SimulatedWorld
from scores.visitor_score import is_useful, picture_of

BEFORE_THE_DOOR = (3.05, 4.15, 1.1)
IN_THE_KITCHEN = (8.0, 3.4, 1.1)


@pytest.fixture(scope="module")
def world() -> SimulatedWorld:
    loaded = premises()
    return SimulatedWorld(loaded.site, loaded.room)


@pytest.fixture
def visited(world: SimulatedWorld) -> Iterator[SimulatedWorld]:
    world.set_visitor(True)
    yield world
    world.set_visitor(False)


@pytest.mark.parametrize(
    ("place", "yaw", "useful"),
    [
        (BEFORE_THE_DOOR, pi, True),
        (BEFORE_THE_DOOR, 0.0, False),
        (BEFORE_THE_DOOR, pi - 0.45, False),
        (IN_THE_KITCHEN, pi, False),
    ],
    ids=["facing", "turned away", "at the edge of the picture", "far away"],
)
def test_a_picture_is_useful_from_near_and_turned_to_the_visitor(
    visited: SimulatedWorld, place: Vec3, yaw: float, useful: bool
) -> None:
    visited.put_drone(place, yaw)
    assert is_useful(picture_of(visited, 0.0)) is useful


def test_without_a_visitor_no_picture_is_useful(world: SimulatedWorld) -> None:
    world.put_drone(BEFORE_THE_DOOR, pi)
    picture = picture_of(world, 0.0)
    assert picture.share == 0.0 and not is_useful(picture)
