"""How near people come, and where to make way to."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.messages import Obstacle, ObstacleKind
from housefly.pilot.planning.people import (
    PREDICTED_SPEED_MAX,
    WALKING_TIME_MAX,
    ObservedPeople,
    people_at,
    walking_time,
)
from housefly.pilot.planning.separation import refuge, separation
from housefly.room.grid import Cell, OccupancyGrid

HULL = 0.34


def hall() -> OccupancyGrid:
    """A hall of 8 m by 5 m; the left metre is a no-fly area."""
    cells = np.zeros((80, 50), dtype=np.uint8)
    cells[:10, :] = Cell.VIRTUAL
    x, y = (np.arange(80) + 0.5)[:, None] * 0.1, (np.arange(50) + 0.5)[None, :] * 0.1
    walls = np.minimum(np.minimum(x, 8.0 - x), np.minimum(y, 5.0 - y))
    return OccupancyGrid((0.0, 0.0), 0.1, cells, walls)


def people(*rows: tuple[float, ...]) -> ObservedPeople:
    """Return people by x, y, velocity and radius who can walk on for long."""
    walks = np.full((len(rows), 1), WALKING_TIME_MAX)
    return ObservedPeople(
        np.hstack([np.array(rows).reshape(-1, 5), walks]), tuple(str(n) for n in range(len(rows)))
    )


def test_somebody_who_walks_past_is_nearest_on_the_way() -> None:
    walker = people((1.0, 2.0, 1.0, 0.0, 0.2))
    found = separation(walker, (3.0, 2.5), (0.0, 0.0), HULL, 3.0)
    assert found.now == pytest.approx(hypot(2.0, 0.5) - 0.2 - HULL)
    assert found.closest == pytest.approx(0.5 - 0.2 - HULL - 0.2, abs=0.02)


def test_nobody_is_infinitely_far() -> None:
    assert separation(people(), (3.0, 2.5), (0.0, 0.0), HULL, 3.0).closest == float("inf")


walkers = st.lists(
    st.tuples(
        st.floats(0.5, 7.5),
        st.floats(0.5, 4.5),
        st.floats(-1.5, 1.5),
        st.floats(-1.5, 1.5),
        st.just(0.2),
    ),
    min_size=1,
    max_size=3,
)


@settings(max_examples=12, deadline=None)
@given(walkers, st.floats(1.6, 7.0), st.floats(1.0, 4.0))
def test_a_good_refuge_is_no_worse_than_staying_and_never_in_a_wall_or_a_no_fly_area(
    rows: list[tuple[float, ...]], x: float, y: float
) -> None:
    crowd, grid = people(*rows), hall()
    found = refuge(crowd, grid, (x, y), (0.0, 0.0), HULL, 0.8, 1.2)
    alone = refuge(crowd, _closed_around(x, y), (x, y), (0.0, 0.0), HULL, 0.8, 1.2)
    assert alone.place == (x, y)
    if max(found.separation, alone.separation) >= 0.25:
        assert min(found.separation, 1.2) >= min(alone.separation, 1.2) - 1e-9
    if found.place != (x, y):
        assert grid.kind(grid.cell_of(found.place)) is Cell.FREE
        assert grid.clearance_at(found.place) > HULL


def test_in_a_corridor_the_drone_flees_from_who_comes_as_far_as_it_can() -> None:
    """Nowhere is good, so later is better: stepping half aside would be met at once."""
    cells = np.full((80, 50), Cell.OCCUPIED, np.uint8)
    cells[:, 20:30] = Cell.FREE
    y = np.minimum(
        np.abs((np.arange(50) + 0.5) * 0.1 - 2.0), np.abs((np.arange(50) + 0.5) * 0.1 - 3.0)
    )
    corridor = OccupancyGrid((0.0, 0.0), 0.1, cells, np.tile(y, (80, 1)))
    found = refuge(
        people((0.5, 2.5, 1.0, 0.0, 0.2)), corridor, (3.0, 2.5), (0.0, 0.0), HULL, 0.8, 1.2
    )
    assert found.place[0] > 5.0


def test_stepping_aside_for_certain_is_better_than_being_met_later_in_a_dead_end() -> None:
    """At the mouth of a corridor; the room is just wide enough to let somebody pass."""
    cells = np.full((80, 50), Cell.OCCUPIED, np.uint8)
    cells[:30, 20:30] = Cell.FREE
    cells[30:, 8:32] = Cell.FREE
    x, y = (np.arange(80) + 0.5)[:, None] * 0.1, (np.arange(50) + 0.5)[None, :] * 0.1
    narrow = np.minimum(np.minimum(y - 2.0, 3.0 - y), x)
    wide = np.minimum(np.minimum(y - 0.8, 3.2 - y), 8.0 - x)
    mouth = OccupancyGrid((0.0, 0.0), 0.1, cells, np.maximum(np.where(x < 3.0, narrow, wide), 0.0))
    walker = people((5.8, 2.6, -0.8, 0.0, 0.25))
    found = refuge(walker, mouth, (3.3, 2.3), (0.0, 0.0), HULL, 1.2, 1.2)
    assert 0.25 < found.separation < 0.6
    assert found.place[0] > 3.0 and found.place[1] < 1.8


def test_who_stands_beside_the_drone_is_left_although_nothing_undoes_the_beginning() -> None:
    found = refuge(
        people((4.0, 1.8, 0.0, 0.0, 0.2)), hall(), (4.0, 2.5), (0.0, 0.0), HULL, 0.8, 1.2
    )
    assert hypot(found.place[0] - 4.0, found.place[1] - 1.8) - HULL - 0.2 > 0.9


def test_nobody_is_thought_to_walk_through_a_wall_and_who_stands_does_not_come() -> None:
    assert walking_time(hall(), (6.5, 2.5), (1.0, 0.0)) == pytest.approx(1.4, abs=0.11)
    assert walking_time(hall(), (6.5, 2.5), (0.0, 0.0)) == WALKING_TIME_MAX
    standing = separation(people((1.0, 2.0, 0.0, 0.0, 0.2)), (3.0, 2.0), (0.0, 0.0), HULL, 3.0)
    assert standing.closest == standing.now


def _closed_around(x: float, y: float) -> OccupancyGrid:
    """A hall where only the cell of a place is open."""
    cells = np.full((80, 50), Cell.VIRTUAL, np.uint8)
    cells[int(x / 0.1), int(y / 0.1)] = Cell.FREE
    return OccupancyGrid((0.0, 0.0), 0.1, cells, np.full((80, 50), 2.0))


def test_people_are_named_by_kind_or_motion_and_no_faster_than_believed() -> None:
    seen = (
        Obstacle("person", (1.0, 1.0), 0.2, kind=ObstacleKind.PERSON),
        Obstacle("chair", (2.0, 1.0), 0.2),
        Obstacle("mover", (3.0, 1.0), 0.2, velocity=(0.5, 0.0)),
        Obstacle("pushed", (4.0, 1.0), 0.2, velocity=(0.5, 0.0), kind=ObstacleKind.THING),
        Obstacle("racer", (5.0, 1.0), 0.2, velocity=(9.0, 0.0), kind=ObstacleKind.PERSON),
    )
    found = people_at(seen, 0.1)
    assert found.names == ("person", "mover", "racer")
    assert found.rows[2, 2] == pytest.approx(PREDICTED_SPEED_MAX)
