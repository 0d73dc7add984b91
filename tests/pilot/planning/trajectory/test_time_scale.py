"""Travelling through a trajectory, and the heading along it."""

from __future__ import annotations

from itertools import pairwise
from math import atan2, nan, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from space_room import LIMITS, bsen_voxels, way_between

from housefly.numeric import FloatArray, wrapped
from housefly.pilot.planning.space.solid_rows import room_rows
from housefly.pilot.planning.trajectory.heading import headings
from housefly.pilot.planning.trajectory.time_scale import TimeScale, motion_at, scale_advanced
from housefly.pilot.planning.trajectory.timing import TICK
from housefly.pilot.planning.trajectory.trajectory import at_rest, trajectory_along
from housefly.room.bsen import bsen

BRAKING = 1.0
DT = 0.01


@pytest.fixture(scope="module")
def rows() -> FloatArray:
    start, goal = np.array([4.0, 4.2, 1.1]), np.array([13.5, 1.3, 1.1])
    voxels = bsen_voxels()
    flown = trajectory_along(
        voxels,
        voxels.free(),
        room_rows(bsen()),
        way_between(start, goal),
        at_rest(start),
        LIMITS,
    )
    assert flown is not None
    return flown.rows


def travelled(rows: FloatArray, wishes: FloatArray) -> FloatArray:
    """Return what is tracked at each tick while the wanted rates are these, shape (n, 9)."""
    scale, found = TimeScale(0.0, 1.0, 0.0), []
    for wish in wishes.tolist():
        scale = scale_advanced(scale, rows, TICK, wish, BRAKING, DT)
        found.append(motion_at(scale, rows, TICK))
    return np.array(found)


def test_at_full_rate_it_is_flown_as_planned_at_its_times(rows: FloatArray) -> None:
    tracked = travelled(rows, np.ones(2 * len(rows)))
    assert np.allclose(tracked[1::2][: len(rows) - 1, :6], rows[1:, :6], atol=1e-9)
    assert np.allclose(tracked[-1], rows[-1], atol=1e-9)


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1))
def test_slowing_down_and_stopping_stays_on_the_curve_and_brakes_no_harder(
    rows: FloatArray, seed: int
) -> None:
    random = np.random.default_rng(seed)
    wishes = np.repeat(random.choice((0.0, 0.4, 1.0), 12), 120)
    tracked = travelled(rows, wishes)
    speed = np.linalg.norm(tracked[:, 3:6], axis=1)
    own = np.linalg.norm(rows[:, 6:9], axis=1).max()
    pushed = np.diff(tracked[:, 3:6], axis=0) / DT
    assert np.abs(pushed - tracked[1:, 6:9]).max() < 0.15
    assert np.abs(np.diff(speed)).max() / DT <= BRAKING + own + 0.05
    fine = np.stack(
        [
            np.interp(np.linspace(0, 1, 4000), np.linspace(0, 1, len(rows)), c)
            for c in rows[:, :3].T
        ],
        axis=1,
    )
    for place in tracked[::37, :3]:
        assert np.linalg.norm(fine - place, axis=1).min() < 2e-3
    steps = np.linalg.norm(np.diff(tracked[:, :3], axis=0), axis=1) / DT
    assert np.abs(steps - 0.5 * (speed[1:] + speed[:-1])).max() < 0.02


def test_a_stop_takes_the_way_that_the_braking_gives(rows: FloatArray) -> None:
    fast = int(np.argmax(np.linalg.norm(rows[:, 3:6], axis=1)))
    scale = TimeScale(fast * TICK, 1.0, 0.0)
    way, before = 0.0, motion_at(scale, rows, TICK)
    for _ in range(200):
        scale = scale_advanced(scale, rows, TICK, 0.0, BRAKING, DT)
        here = motion_at(scale, rows, TICK)
        way += float(np.linalg.norm(np.array(here[:3]) - np.array(before[:3])))
        before = here
    assert scale.rate == 0.0
    speed = float(np.linalg.norm(rows[fast, 3:6]))
    assert 0.3 * speed**2 / BRAKING < way < 0.9 * speed**2 / BRAKING


def test_no_time_and_the_end_change_nothing(rows: FloatArray) -> None:
    scale = TimeScale(1.0, 0.5, 0.0)
    assert scale_advanced(scale, rows, TICK, 1.0, BRAKING, 0.0) == scale
    late = scale_advanced(TimeScale(1e6, 1.0, 0.0), rows, TICK, 1.0, BRAKING, DT)
    assert late.time == pytest.approx(TICK * (len(rows) - 1))


@settings(max_examples=30)
@given(st.floats(-pi, pi), st.floats(-pi, pi))
def test_a_heading_turns_no_faster_and_looks_at_the_subject_on_arrival(
    rows: FloatArray, start: float, arrival: float
) -> None:
    found = headings(rows, TICK, start, arrival, 0.9)
    turns = [abs(wrapped(b - a)) for a, b in pairwise(found.tolist())]
    assert max(turns) <= 0.9 * TICK + 1e-9
    assert found[0] == start
    assert abs(wrapped(found[-1] - arrival)) < 0.05


def test_on_the_way_it_looks_where_it_flies(rows: FloatArray) -> None:
    found = headings(rows, TICK, atan2(rows[30, 4], rows[30, 3]), nan, 0.9)
    middle = len(rows) // 2
    ahead = rows[middle + 25]
    assert abs(wrapped(found[middle] - atan2(ahead[4], ahead[3]))) < 0.5
    assert abs(wrapped(found[-1] - found[-20])) < 0.2
