"""Measures of courses that are known, because they are made up."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.numeric import FloatArray
from housefly.pilot.planning.space.oriented_hull import OrientedHull
from housefly.pilot.planning.space.solid_rows import solid_rows
from housefly.room.model import Shape, Solid
from quality_gate.leg_measures import (
    leg_measures,
    off_polyline,
    overshoot,
    there_after,
)

HULL = OrientedHull(0.26, 0.22, 0.065)
WALL = solid_rows((Solid("wall", "wall", Shape.BOX, (2.0, 1.0, 1.0), (8.0, 0.2, 2.0)),))
GOAL = (4.0, 0.0)


def course(past: float = 0.0, aside: float = 0.0, lag: float = 0.0) -> FloatArray:
    """Fly 4 m along x in 4 s beside a reference, come past the goal once, and stand there."""
    time = np.arange(0.0, 8.0, 0.01)
    wanted = np.clip(time, 0.0, 4.0)
    x = np.clip(time - lag, 0.0, 4.0) + past * np.exp(-(((time - 4.5) / 0.2) ** 2))
    rows = np.zeros((len(time), 11))
    rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3] = time, x, aside, 1.0
    rows[:, 4] = np.gradient(x, time)
    rows[:, 7], rows[:, 9] = wanted, 1.0
    return rows


@given(st.floats(0.0, 0.3))
def test_overshoot_is_how_far_it_came_past_the_goal(past: float) -> None:
    assert overshoot(course(past), GOAL) == pytest.approx(past, abs=0.003)


def test_a_drone_that_passes_its_goal_on_the_way_has_not_come_past_it() -> None:
    out_and_back = course()
    out_and_back[:, [1, 7]] *= 1.5
    back = out_and_back[::-1].copy()
    back[:, 0] = out_and_back[-1, 0] + 0.01 + out_and_back[:, 0]
    there = np.vstack((out_and_back, back[:600]))
    end = (float(there[-1, 7]), 0.0)
    assert overshoot(there, end) < 0.01


def test_who_stays_away_never_arrives() -> None:
    assert there_after(course(), (9.0, 0.0)) == inf
    assert 3.8 < there_after(course(), GOAL) < 4.1
    assert there_after(course(past=0.3), GOAL) > 4.3


@given(st.floats(0.0, 0.5), st.floats(0.0, 0.4))
def test_off_the_reference_counts_the_lag_and_off_the_line_does_not(
    aside: float, lag: float
) -> None:
    found = leg_measures(course(aside=aside, lag=lag), 4.5, GOAL, WALL, HULL)
    assert found.reference_max == pytest.approx(np.hypot(aside, lag), abs=0.02)
    assert found.path_max == pytest.approx(aside, abs=0.02)


def test_clearance_counts_from_the_middle_and_the_hull_as_it_is_turned() -> None:
    ahead = leg_measures(course(), 4.5, GOAL, WALL, HULL)
    turned = course()
    turned[:, 10] = np.pi / 2
    across = leg_measures(turned, 4.5, GOAL, WALL, HULL)
    assert ahead.clearance == across.clearance == pytest.approx(0.9, abs=0.001)
    assert ahead.gap == pytest.approx(0.9 - 0.22, abs=0.001)
    assert across.gap == pytest.approx(0.9 - 0.26, abs=0.001)


@given(st.lists(st.tuples(st.floats(-5, 5), st.floats(-5, 5)), min_size=2, max_size=6))
def test_no_corner_of_a_line_is_off_it_and_nothing_is_farther_than_from_its_corners(
    corners: list[tuple[float, float]],
) -> None:
    line = np.array(corners)
    assert off_polyline(line, line).max() < 1e-6
    points = line + np.array([0.3, -0.2])
    apart = np.linalg.norm(points[:, None] - line[None], axis=2).min(axis=1)
    assert (off_polyline(points, line) <= apart + 1e-9).all()
