"""Who and what is there now, as tasks see it."""

from __future__ import annotations

import pytest

from housefly.messages import (
    Obstacle,
    ObstacleKind,
    Pose,
    Sighting,
    TrackedFrame,
)
from housefly.sites.loaded_site import load_site
from housefly.tasks.execution.live_obstacles import LiveObstacles

LOADED = load_site("bsen", people__bodies=("guest",))


def seen(body: str, x: float, at: float) -> TrackedFrame:
    return TrackedFrame((Sighting(body, Pose((x, 1.0, 1.6)), at, at),))


@pytest.fixture
def live() -> LiveObstacles:
    return LiveObstacles(LOADED.site, LOADED.room)


def test_a_tracked_person_has_a_name_a_place_and_a_velocity(live: LiveObstacles) -> None:
    for number in range(101):
        live.heard_frame(seen("guest", 2.0 + 0.01 * number, 0.01 * number))
    (guest,) = live.people(1.0)
    assert (guest.id, guest.position) == ("guest", (3.0, 1.0, 1.6))
    assert guest.velocity == pytest.approx((1.0, 0.0), abs=0.05)
    assert live.people(3.5) == (), "who was seen long ago is not there now"


def test_a_body_that_is_taken_for_another_has_no_velocity(live: LiveObstacles) -> None:
    live.heard_frame(seen("guest", 2.0, 0.0))
    live.heard_frame(seen("guest", 9.0, 0.4))
    assert live.people(0.4)[0].velocity == (0.0, 0.0)


def test_a_person_whom_a_scanner_sees_too_is_one_person(live: LiveObstacles) -> None:
    live.heard_frame(seen("guest", 2.0, 0.0))
    for name, x in (("1", 2.2), ("2", 6.0)):
        live.heard_obstacle(
            Obstacle(name, (x, 1.0), 0.3, source="laser", kind=ObstacleKind.PERSON, seen_at=0.0)
        )
    assert [person.id for person in live.people(0.1)] == ["guest", "laser/2"]
    assert [one.id for one in live.obstacles(0.1)] == ["1", "2"]
    live.heard_obstacle(Obstacle("2", (6.0, 1.0), confidence=0.0, source="laser"))
    assert [one.id for one in live.obstacles(0.1)] == ["1"]
    assert live.obstacles(2.5) == ()
