"""Sightings of tracked furniture as obstacles: where they stand, how they move, and for how long
they are believed.
"""

from __future__ import annotations

from math import cos, inf, nan, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.furniture import FurnitureConfig
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.geometry import quaternion_from_euler
from housefly.messages import Obstacle, Pose, Sighting
from housefly.pilot.planning.furniture import (
    FURNITURE_REPORT_PERIOD,
    FURNITURE_SOURCE,
    TrackedFurniture,
)
from housefly.pilot.planning.obstacles import FREED_AFTER, ObstacleMemory, obstacle_fault
from housefly.room.bsen import bsen

TABLE = FurnitureConfig(
    name="table",
    body="Table 1",
    length=1.2,
    width=0.6,
    top=0.75,
    x=0.3,
    y=0.1,
    yaw=0.5,
    remembered=5.0,
)
EXTENT = (0.0, 0.0, 10.0, 5.0)


def tracked(*pieces: FurnitureConfig) -> TrackedFurniture:
    return TrackedFurniture(changed(Site(), furniture=pieces), bsen())


def seen(
    at: float, x: float = 2.0, y: float = 1.0, yaw: float = 0.0, body: str = "Table 1"
) -> Sighting:
    return Sighting(body, Pose((x, y, 0.7), quaternion_from_euler(0.0, 0.0, yaw)), at, at)


@given(x=st.floats(0.0, 10.0), y=st.floats(0.0, 5.0), yaw=st.floats(-pi, pi))
def test_the_footprint_lies_where_the_body_says(x: float, y: float, yaw: float) -> None:
    (table,) = tracked(TABLE).step((seen(1.0, x, y, yaw),), 1.02)
    assert table.position[0] == pytest.approx(x + cos(yaw) * 0.3 - sin(yaw) * 0.1)
    assert table.position[1] == pytest.approx(y + sin(yaw) * 0.3 + cos(yaw) * 0.1)
    assert cos(table.yaw - yaw - 0.5) == pytest.approx(1.0)
    assert (table.id, table.source, table.size, table.bottom, table.top) == (
        "table",
        FURNITURE_SOURCE,
        (1.2, 0.6),
        0.0,
        0.75,
    )
    assert table.confidence == 1.0 and table.velocity == (0.0, 0.0)
    assert not obstacle_fault(table, 1.02, EXTENT)


def test_a_body_that_is_no_furniture_is_nothing() -> None:
    assert not tracked(TABLE).step((seen(1.0, body="ardrone"),), 1.0)
    assert not tracked().step((seen(1.0),), 1.0)


def test_what_stands_still_is_told_a_few_times_a_second_and_what_is_moved_at_once() -> None:
    furniture = tracked(TABLE)
    told = [len(furniture.step((seen(0.01 * n),), 0.01 * n)) for n in range(200)]
    assert sum(told) == pytest.approx(2.0 / FURNITURE_REPORT_PERIOD, abs=2)
    assert furniture.step((seen(2.0, 2.05),), 2.0)


def test_what_is_not_seen_is_believed_as_long_as_the_site_says_and_then_forgotten() -> None:
    furniture, memory = tracked(TABLE), ObstacleMemory()
    memory = memory.updated(furniture.step((seen(0.0),), 0.0), 0.0)
    freed = inf
    for n in range(1, 1000):
        memory = memory.updated(furniture.step((), 0.01 * n), 0.01 * n)
        freed = freed if memory.obstacles else min(freed, 0.01 * n)
    assert (
        TABLE.remembered + FREED_AFTER - FURNITURE_REPORT_PERIOD - 0.02
        <= freed
        <= TABLE.remembered + FREED_AFTER + 0.02
    )


def test_what_is_pushed_has_its_velocity_and_none_when_it_is_let_go_or_not_seen() -> None:
    furniture = tracked(TABLE)
    told: list[Obstacle] = []
    for n in range(100):
        told.extend(furniture.step((seen(0.01 * n, 2.0 + 0.005 * n),), 0.01 * n))
    assert told[-1].velocity == pytest.approx((0.5, 0.0), abs=0.02)
    (unseen,) = furniture.step((), 1.5)
    assert unseen.velocity == (0.0, 0.0)
    assert unseen.position == pytest.approx((2.0 + 0.005 * 99 + 0.3, 1.1))


def test_what_is_put_elsewhere_is_nowhere_else_and_does_not_race() -> None:
    furniture, memory = tracked(TABLE), ObstacleMemory()
    for n in range(100):
        x = 2.0 if n < 50 else 7.0
        memory = memory.updated(furniture.step((seen(0.01 * n, x),), 0.01 * n), 0.01 * n)
        (table,) = memory.obstacles
        assert table.position[0] == pytest.approx(x + 0.3) and table.velocity == (0.0, 0.0)


def test_what_the_room_model_has_stands_there_until_it_is_seen_and_is_never_forgotten() -> None:
    shelf = FurnitureConfig(
        name="shelf", body="Shelf", model="smart shelf", width=0.35, top=1.0, remembered=5.0
    )
    furniture, memory = tracked(shelf), ObstacleMemory()
    for n in range(3000):
        seen_now = (seen(0.01 * n, 3.0, body="Shelf"),) if n == 1000 else ()
        memory = memory.updated(furniture.step(seen_now, 0.01 * n), 0.01 * n)
        (known,) = memory.obstacles
        assert known.position == pytest.approx((11.5, 4.2) if n < 1000 else (3.0, 1.0), abs=0.02)
        assert not obstacle_fault(known, 0.01 * n, EXTENT)


@pytest.mark.parametrize(
    "bad", [seen(nan), seen(9.0), seen(0.5, nan), seen(0.5, inf), seen(-1.0), seen(0.0, 5.0)]
)
def test_sightings_that_cannot_be_or_are_older_change_nothing(bad: Sighting) -> None:
    furniture = tracked(TABLE)
    (before,) = furniture.step((seen(0.0),), 0.0)
    (after,) = furniture.step((bad,), 1.0)
    assert after.position == before.position and after.seen_at == 1.0


@pytest.mark.parametrize(
    ("pieces", "words"),
    [
        ([{"name": "a", "body": "x"}, {"name": "a", "body": "y"}], "same name"),
        ([{"name": "a", "body": "x"}, {"name": "b", "body": "x"}], "same body"),
        ([{"name": "a", "body": "ardrone"}], "the drone or the visitor"),
        ([{"name": "a", "body": "x", "bottom": 1.0, "top": 0.5}], "below top"),
        ([{"name": "a", "body": "x", "length": 50.0}], "length"),
        ([{"name": "a"}], "body"),
    ],
)
def test_furniture_that_cannot_be_is_refused_in_words(
    pieces: list[dict[str, object]], words: str
) -> None:
    with pytest.raises(ConfigError, match=words):
        changed(Site(), furniture=pieces)
