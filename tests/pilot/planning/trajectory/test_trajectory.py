"""Trajectories in B-sen: smooth, within the limits, clear of everything on the curve flown."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from space_room import ARDRONE, KEEP, LIMITS, bsen_voxels, free_points, way_between

from housefly.messages.obstacles import Obstacle
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import hull_clearances
from housefly.pilot.planning.space.solid_rows import live_rows, room_rows
from housefly.pilot.planning.trajectory.control_points import stopping_points
from housefly.pilot.planning.trajectory.corridor import corridor
from housefly.pilot.planning.trajectory.curve import arc_curve
from housefly.pilot.planning.trajectory.timing import TICK, KinematicState, timed_motion
from housefly.pilot.planning.trajectory.trajectory import (
    CLEARANCE_GIVE,
    Trajectory,
    at_rest,
    trajectory_along,
)
from housefly.room.bsen import bsen

ROWS = room_rows(bsen())
SEEDS = st.integers(0, 2**32 - 1)


def flight(start: KinematicState, goal: FloatArray) -> Trajectory | None:
    corners = way_between(start.place, goal)
    voxels = bsen_voxels()
    return trajectory_along(voxels, voxels.free(), ROWS, corners, start, LIMITS)


def check_limits(rows: FloatArray) -> None:
    """Assert that a motion keeps every limit, by its own numbers and by differences."""
    places, velocities, pushes = rows[:, :3], rows[:, 3:6], rows[:, 6:9]
    assert np.linalg.norm(velocities, axis=1).max() <= LIMITS.speed * 1.02
    assert np.abs(velocities[:, 2]).max() <= LIMITS.vertical_speed * 1.03
    tilt = pushes[:, :2] + LIMITS.drag * velocities[:, :2]
    assert np.linalg.norm(tilt, axis=1).max() <= LIMITS.acceleration * 1.03
    assert np.abs(pushes[:, 2]).max() <= LIMITS.vertical_acceleration * 1.03
    jerk = np.linalg.norm(np.diff(pushes, axis=0), axis=1) / TICK
    assert jerk.max() <= LIMITS.jerk * 1.03
    for lower, upper, slack in ((places, velocities, 0.01), (velocities, pushes, 0.11)):
        slopes = np.diff(lower, axis=0) / TICK
        apart = np.abs(slopes - 0.5 * (upper[1:] + upper[:-1])).max(axis=1)
        assert apart[np.linalg.norm(velocities[:-1], axis=1) > 0.02].max() < slack


@settings(max_examples=25)
@given(SEEDS)
def test_a_trajectory_goes_from_rest_to_rest_within_all_limits_and_clear_of_everything(
    seed: int,
) -> None:
    start, goal = free_points(seed, 2, 1.1)
    assume(np.linalg.norm(goal - start) > 0.5)
    trajectory = flight(at_rest(start), goal)
    assert trajectory is not None and not trajectory.stops
    rows = trajectory.rows
    assert np.allclose(rows[0], [*start, *[0.0] * 6], atol=1e-6)
    assert np.allclose(rows[-1], [*goal, *[0.0] * 6], atol=1e-6)
    check_limits(rows)
    near = hull_clearances(ROWS, rows[:, :3], ARDRONE, 9.0).min()
    assert near >= KEEP - CLEARANCE_GIVE - 1e-3
    assert trajectory.clearance <= min(near, 1.0) + 0.01
    assert trajectory.duration >= trajectory.length / LIMITS.speed


@settings(max_examples=15)
@given(SEEDS)
def test_a_flight_in_space_keeps_the_same_promises(seed: int) -> None:
    start, goal = free_points(seed, 2)
    trajectory = flight(at_rest(start), goal)
    assert trajectory is not None
    check_limits(trajectory.rows)
    near = hull_clearances(ROWS, trajectory.rows[:, :3], ARDRONE, 9.0).min()
    assert near >= KEEP - 0.09 if trajectory.stops else near >= KEEP - CLEARANCE_GIVE - 1e-3


@settings(max_examples=15)
@given(SEEDS, st.floats(0.2, 0.8))
def test_a_new_trajectory_in_flight_begins_without_a_jump(seed: int, share: float) -> None:
    start, goal, other = free_points(seed, 3, 1.1)
    assume(np.linalg.norm(goal - start) > 2.0)
    first = flight(at_rest(start), goal)
    assert first is not None
    here = first.rows[int(share * len(first.rows))]
    second = flight(KinematicState(here[:3], here[3:6], here[6:9]), other)
    assume(second is not None)
    assert second is not None
    assert np.abs(second.rows[0, :3] - here[:3]).max() < 1e-6
    assert np.abs(second.rows[0, 3:6] - here[3:6]).max() < 1e-3
    assert np.abs(second.rows[0, 6:] - here[6:]).max() < 0.05
    check_limits(second.rows)


def test_going_on_to_the_same_goal_is_planned_anew_from_almost_any_state() -> None:
    start, goal = np.array([4.0, 4.2, 1.1]), np.array([13.5, 1.3, 1.1])
    first = flight(at_rest(start), goal)
    assert first is not None
    states = range(20, len(first.rows) - 60, 25)
    again = {n: flight(KinematicState(*np.split(first.rows[n], 3)), goal) for n in states}
    found = {n: answer for n, answer in again.items() if answer is not None}
    assert len(found) >= 0.8 * len(again)
    later = [answer.duration - (first.duration - TICK * n) for n, answer in found.items()]
    assert float(np.median(later)) < 0.1


@settings(max_examples=40)
@given(SEEDS)
def test_the_boxes_of_a_corridor_are_free_and_overlap(seed: int) -> None:
    start, goal = free_points(seed, 2)
    voxels = bsen_voxels()
    free, corners = voxels.free(), way_between(start, goal)
    boxes = corridor(free, (corners - np.array(voxels.origin)) / voxels.resolution)
    for low, high in np.floor(boxes).astype(int):
        assert free[tuple(slice(a, b + 1) for a, b in zip(low, high, strict=True))].all()
    for before, after in pairwise(boxes):
        assert (np.maximum(before[0], after[0]) <= np.minimum(before[1], after[1])).all()
    ends = np.floor((corners[[0, -1]] - np.array(voxels.origin)) / voxels.resolution) + 0.5
    assert (boxes[0, 0] <= ends[0]).all() and (ends[0] <= boxes[0, 1]).all()
    assert (boxes[-1, 0] <= ends[1]).all() and (ends[1] <= boxes[-1, 1]).all()


@pytest.mark.parametrize("speed", [0.5, 1.0, 1.5])
def test_a_faster_limit_makes_a_faster_flight(speed: float) -> None:
    start, goal = np.array([5.5, 4.2, 1.1]), np.array([10.4, 4.2, 1.1])
    voxels, corners = bsen_voxels(), way_between(start, goal)
    fast = LIMITS._replace(speed=speed, narrow_speed=speed)
    flown = trajectory_along(voxels, voxels.free(), ROWS, corners, at_rest(start), fast)
    assert flown is not None
    assert flown.length / speed < flown.duration < flown.length / speed + 2.5


def test_a_polyline_is_flown_with_a_stop_at_each_corner_before_the_turn() -> None:
    corners = np.array([[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 1.0, 1.2], [1.0, 1.0, 1.2]])
    curve = arc_curve(stopping_points(corners))
    clear = np.ones(curve.marks.size)
    rows = timed_motion(curve, clear, KEEP, at_rest(corners[0]), LIMITS)
    assert rows is not None
    check_limits(rows)
    speed = np.linalg.norm(rows[:, 3:6], axis=1)
    for corner in corners:
        near = np.linalg.norm(rows[:, :3] - corner, axis=1)
        assert near.min() < 1e-3 and speed[near.argmin()] < 1e-3


def test_what_stands_in_the_way_at_the_last_look_is_not_flown_through() -> None:
    voxels, start = bsen_voxels(), np.array([5.5, 4.2, 1.1])
    corners = way_between(start, np.array([13.5, 1.3, 1.1]))
    x, y = (0.5 * (corners[0] + corners[1])[:2]).tolist()
    post = live_rows([Obstacle("post", (x, y), 0.0, (0.1, 0.1))], 0.0, 0.0)
    known = np.vstack((ROWS, post))
    at = at_rest(corners[0])
    assert trajectory_along(voxels, voxels.free(), known, corners, at, LIMITS) is None
