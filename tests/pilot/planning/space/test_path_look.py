"""The look along a path in space."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import Obstacle, ObstacleKind
from housefly.pilot.planning.space.clearance import HullCylinder
from housefly.pilot.planning.space.path_look import first_block_in_space
from housefly.pilot.planning.space.solid_rows import live_rows

HULL, TIGHT = HullCylinder(0.343, 0.065), 0.08
LEVEL = np.array([(0.0, 0.0, 1.1), (2.0, 0.0, 1.1), (4.0, 0.0, 1.1)])


def box(x: float, y: float, top: float = 3.0) -> Obstacle:
    return Obstacle("box", (x, y), 0.2, top=top, kind=ObstacleKind.THING)


def looked(points: np.ndarray, *obstacles: Obstacle) -> tuple[float, int]:
    rows = live_rows(obstacles, 0.0, 0.0)
    return first_block_in_space(rows, rows, points, HULL, TIGHT)


@given(st.floats(1.0, 3.0), st.floats(-1.5, 1.5))
def test_a_path_is_blocked_where_the_hull_first_comes_too_near(x: float, y: float) -> None:
    along, row = looked(LEVEL, box(9.0, 9.0), box(x, y))
    reach = 0.2 + HULL.radius + TIGHT
    if abs(y) >= reach:
        assert (along, row) == (inf, -1)
    elif abs(y) < reach - 0.02:
        first = x - (reach**2 - y**2) ** 0.5
        assert first - 1e-9 <= along <= max(first, 0.0) + 0.051 and row == 1


def test_it_may_fly_over_a_thing_that_is_low_and_not_through_one_that_is_high() -> None:
    over = LEVEL + np.array([0.0, 0.0, 0.5])
    assert looked(over, box(2.0, 0.0, top=1.4)) == (inf, -1)
    assert looked(LEVEL, box(2.0, 0.0, top=1.4))[0] == pytest.approx(2.0 - 0.623, abs=0.06)
    assert looked(over, box(2.0, 0.0, top=1.5))[0] < 2.0


def test_out_of_what_is_too_near_already_it_may_go_but_not_nearer() -> None:
    near = box(-0.4, 0.0)
    assert looked(LEVEL, near) == (inf, -1)
    assert looked(-LEVEL * (1.0, 1.0, -1.0), near)[0] == pytest.approx(0.05, abs=0.01)
    assert looked(LEVEL, near, box(3.0, 0.0))[0] == pytest.approx(3.0 - 0.623, abs=0.06)


def test_nothing_known_and_nowhere_to_go_are_free() -> None:
    assert looked(LEVEL) == looked(LEVEL[:1], box(0.0, 0.0)) == (inf, -1)
