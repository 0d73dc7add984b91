from __future__ import annotations

from itertools import pairwise
from math import hypot, isnan, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from path_follower import DT, PathFollower

from housefly.geometry import Vec2, distance
from housefly.pilot.behavior.path_profile import CORNER_VELOCITY_JUMP, path_profile
from housefly.pilot.behavior.path_progress import (
    HEADING_FREEZE,
    HEADING_LOOKAHEAD,
    LAG_MAX,
    REFERENCE_ACCELERATION,
    PathProgress,
    TrajectorySetpoint,
    point_on,
    profile_travelled,
    progress_advanced,
    progress_headed,
    setpoint_at,
    speed_allowed,
)

L_SHAPE = ((0.0, 0.0), (3.0, 0.0), (3.0, 2.0))
ZIGZAG = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.5), (0.5, 1.5), (0.5, 3.0))
PROFILE = path_profile(ZIGZAG)
END = float(PROFILE.marks[-1])
lengths = st.floats(0.0, END)
angles = st.floats(-pi, pi)


def place(target: TrajectorySetpoint) -> Vec2:
    return target.x, target.y


def followed(follower: PathFollower, seconds: float = 60.0) -> list[TrajectorySetpoint]:
    """Let a perfect drone follow until the end."""
    start = follower.step(0.0, 0.0, moving=False, dt=0.0)
    targets = [follower.step(*place(start))]
    while not targets[-1].finished and len(targets) < seconds / DT:
        targets.append(follower.step(*place(targets[-1])))
    return targets


points = st.lists(st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)), min_size=1, max_size=4)


@settings(max_examples=40)
@given(points, st.floats(0.2, 1.0))
def test_the_reference_arrives_at_the_end_of_any_path_within_all_bounds(
    way: list[Vec2], speed: float
) -> None:
    follower = PathFollower(tuple(way), speed)
    targets = followed(follower, 200.0)
    assert targets[-1].finished and place(targets[-1]) == pytest.approx(way[-1], abs=1e-5)
    for before, after in pairwise(targets):
        assert hypot(after.vx, after.vy) <= speed + 1e-9
        jump = hypot(after.vx - before.vx, after.vy - before.vy)
        assert jump <= CORNER_VELOCITY_JUMP + 5.0 * REFERENCE_ACCELERATION * DT
        assert distance(place(before), place(after)) <= speed * DT + 2e-4


def test_it_cruises_at_the_speed_asked_and_creeps_around_a_right_angle() -> None:
    targets = followed(PathFollower(L_SHAPE))
    speeds = [hypot(target.vx, target.vy) for target in targets]
    assert max(speeds) == pytest.approx(0.5, abs=1e-6)
    corner = min(range(len(targets)), key=lambda k: distance(place(targets[k]), (3.0, 0.0)))
    assert speeds[corner] <= CORNER_VELOCITY_JUMP / np.sqrt(2.0) + 0.01


def test_feed_forward_is_the_derivative_of_the_speed() -> None:
    targets = followed(PathFollower(((0.0, 0.0), (4.0, 0.0))))
    for before, after in pairwise(targets[:-1]):
        assert after.vx - before.vx == pytest.approx(after.ax * DT, abs=1e-9)


def test_it_waits_for_a_drone_that_lags() -> None:
    follower = PathFollower(((0.0, 0.0), (9.0, 0.0)))
    for _ in range(1000):
        target = follower.step(0.0, 0.0)
    assert 0.3 < target.x < 0.7
    assert (target.vx, target.vy) == (0.0, 0.0)


def test_it_brakes_and_waits_while_it_must_not_move() -> None:
    follower = PathFollower(((0.0, 0.0), (9.0, 0.0)))
    target = follower.step(0.0, 0.0)
    for _ in range(300):
        target = follower.step(target.x, target.y)
    for _ in range(200):
        target = follower.step(target.x, target.y, moving=False)
    assert (target.vx, target.vy) == (0.0, 0.0) and not target.finished


def test_the_heading_is_that_of_the_path_and_turns_before_the_corner() -> None:
    targets = followed(PathFollower(L_SHAPE))
    assert targets[10].yaw == pytest.approx(0.0)
    before_corner = [t for t in targets if 2.7 < t.x < 2.95 and t.y == 0.0]
    assert before_corner and all(0.0 < t.yaw < pi / 2 for t in before_corner)
    assert targets[-1].yaw == pytest.approx(pi / 2)


def test_a_path_of_one_point_is_finished_at_once_and_has_no_heading() -> None:
    target = PathFollower(((1.0, 2.0),)).step(0.0, 0.0)
    assert target.finished and place(target) == (1.0, 2.0) and isnan(target.yaw)


@given(st.floats(0.0, 9.9), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_compiled_steps_match_their_plain_twins(s: float, v: float, wanted: float) -> None:
    marks, speeds = np.array([0.0, 4.0, 10.0]), np.array([0.0, 0.1, 0.0])
    ahead = [
        np.sqrt(c * c + 2.0 * 0.4 * (m - s)) for m, c in zip(marks, speeds, strict=True) if m > s
    ]
    leg = 0 if s < 4.0 else 1
    assert speed_allowed(s, leg, wanted, marks, speeds, 0.4) == pytest.approx(min([wanted, *ahead]))
    arguments = (s, v, leg, wanted, marks, speeds, 0.4, 0.01)
    assert profile_travelled(*arguments) == pytest.approx(profile_travelled.py_func(*arguments))  # type: ignore[attr-defined]


def on_path(s: float) -> np.ndarray:
    """The point at an arc length, by interpolation over all corners."""
    return np.array([np.interp(s, PROFILE.marks, PROFILE.points[:, axis]) for axis in (0, 1)])


def leg_of(s: float) -> int:
    return min(int(np.searchsorted(PROFILE.marks, s, side="right")) - 1, len(ZIGZAG) - 2)


@given(lengths)
def test_a_place_on_the_path_is_the_interpolated_one(s: float) -> None:
    assert point_on(leg_of(s), s, PROFILE) == pytest.approx(tuple(on_path(s)), abs=1e-12)


@given(lengths, angles)
def test_the_heading_is_that_of_the_point_ahead_and_stays_near_the_end(
    s: float, yaw: float
) -> None:
    ahead = on_path(min(s + HEADING_LOOKAHEAD, END)) - on_path(s)
    found = progress_headed(PathProgress(s, 0.3, 0.0, leg_of(s), yaw), PROFILE).yaw
    reach = float(np.hypot(*ahead))
    if abs(reach - HEADING_FREEZE) < 1e-9:
        return
    expected = np.arctan2(ahead[1], ahead[0]) if reach > HEADING_FREEZE else yaw
    assert np.exp(1j * found) == pytest.approx(np.exp(1j * expected), abs=1e-9)


@given(lengths, st.floats(0.0, 0.5), st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.booleans())
def test_the_reference_goes_on_only_while_it_may_and_the_drone_is_near(
    s: float, v: float, dx: float, dy: float, moving: bool
) -> None:
    before = PathProgress(s, v, 0.0, leg_of(s), 0.2)
    x, y = on_path(s) + np.array([dx, dy])
    after = progress_advanced(before, PROFILE, 0.5, x, y, moving, 0.01)
    assert s <= after.s <= END
    if np.hypot(dx, dy) > LAG_MAX + 1e-9 or not moving:
        assert after.v <= v
    assert after == progress_advanced.py_func(before, PROFILE, 0.5, x, y, moving, 0.01)  # type: ignore[attr-defined]


@given(lengths, st.floats(0.0, 0.5), st.floats(-0.6, 0.4))
def test_the_setpoint_moves_along_its_leg(s: float, v: float, a: float) -> None:
    target = setpoint_at(PathProgress(s, v, a, leg_of(s), 0.3), PROFILE)
    leg = PROFILE.points[leg_of(s) + 1] - PROFILE.points[leg_of(s)]
    along = leg / np.hypot(*leg)
    assert (target.vx, target.vy) == pytest.approx(tuple(v * along), abs=1e-12)
    assert (target.ax, target.ay) == pytest.approx(
        tuple((0.0 if s >= END else a) * along), abs=1e-12
    )
    assert target.finished == (s >= END) and target.waypoint == leg_of(s) + 1
