from __future__ import annotations

from itertools import pairwise
from math import hypot, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.geometry import Vec2, distance
from housefly.messages import Path
from housefly.pilot.behavior.path_profile import CORNER_VELOCITY_JUMP, PathFollower, Track
from housefly.pilot.behavior.path_progress import (
    REFERENCE_ACCELERATION,
    profile_travelled,
    speed_allowed,
)
from housefly.pilot.behavior.waypoints import CellFollower, paper_heading

DT = 0.02
L_SHAPE = ((0.0, 0.0), (3.0, 0.0), (3.0, 2.0))


def path(*points: Vec2) -> Path:
    return Path(points, sum(distance(a, b) for a, b in pairwise(points)), 1.0)


def ridden(follower: PathFollower, moving: bool = True, seconds: float = 60.0) -> list[Track]:
    """Let a perfect drone follow until the end."""
    tracks = [follower.step(follower.step((0.0, 0.0), False, 0.0).position, moving, DT)]
    while not tracks[-1].finished and len(tracks) < seconds / DT:
        tracks.append(follower.step(tracks[-1].position, moving, DT))
    return tracks


points = st.lists(st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)), min_size=1, max_size=4)


@settings(max_examples=40)
@given(points, st.floats(0.2, 1.0))
def test_the_reference_arrives_at_the_end_of_any_path_within_all_bounds(
    way: list[Vec2], speed: float
) -> None:
    follower = PathFollower(path(*way), speed)
    tracks = ridden(follower, seconds=200.0)
    assert tracks[-1].finished and tracks[-1].position == pytest.approx(way[-1], abs=1e-9)
    for before, after in pairwise(tracks):
        assert hypot(*after.velocity) <= speed + 1e-9
        jump = hypot(after.velocity[0] - before.velocity[0], after.velocity[1] - before.velocity[1])
        assert jump <= CORNER_VELOCITY_JUMP + 5.0 * REFERENCE_ACCELERATION * DT
        assert distance(before.position, after.position) <= speed * DT + 2e-4


def test_it_cruises_at_the_speed_asked_and_creeps_around_a_right_angle() -> None:
    tracks = ridden(PathFollower(path(*L_SHAPE), 0.5))
    speeds = [hypot(*track.velocity) for track in tracks]
    assert max(speeds) == pytest.approx(0.5, abs=1e-6)
    corner = min(range(len(tracks)), key=lambda k: distance(tracks[k].position, (3.0, 0.0)))
    assert speeds[corner] <= CORNER_VELOCITY_JUMP / np.sqrt(2.0) + 0.01


def test_feed_forward_is_the_derivative_of_the_speed() -> None:
    tracks = ridden(PathFollower(path((0.0, 0.0), (4.0, 0.0)), 0.5))
    for before, after in pairwise(tracks[:-1]):
        assert after.velocity[0] - before.velocity[0] == pytest.approx(
            after.acceleration[0] * DT, abs=1e-9
        )


def test_it_waits_for_a_drone_that_lags() -> None:
    follower = PathFollower(path((0.0, 0.0), (9.0, 0.0)), 0.5)
    for _ in range(1000):
        track = follower.step((0.0, 0.0), True, DT)
    assert 0.3 < track.position[0] < 0.7
    assert track.velocity == (0.0, 0.0)


def test_it_brakes_and_waits_while_it_must_not_move() -> None:
    follower = PathFollower(path((0.0, 0.0), (9.0, 0.0)), 0.5)
    track = follower.step((0.0, 0.0), True, DT)
    for _ in range(300):
        track = follower.step(track.position, True, DT)
    for _ in range(200):
        track = follower.step(track.position, False, DT)
    assert track.velocity == (0.0, 0.0) and not track.finished


def test_the_nose_points_along_the_path_and_turns_before_the_corner() -> None:
    tracks = ridden(PathFollower(path(*L_SHAPE), 0.5))
    assert tracks[10].yaw == pytest.approx(0.0)
    before_corner = [t for t in tracks if 2.7 < t.position[0] < 2.95 and t.position[1] == 0.0]
    assert all(t.yaw is not None and 0.0 < t.yaw < pi / 2 for t in before_corner)
    assert tracks[-1].yaw == pytest.approx(pi / 2)


def test_a_path_of_one_point_is_finished_at_once_and_has_no_heading() -> None:
    track = PathFollower(path((1.0, 2.0)), 0.5).step((0.0, 0.0), True, DT)
    assert track.finished and track.position == (1.0, 2.0) and track.yaw is None


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


def test_the_papers_follower_goes_on_when_nearer_than_eps3() -> None:
    follower = CellFollower(path((0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)), 0.1)
    assert follower.step((-0.4, 0.0), True, DT).position == (0.0, 0.0)
    assert follower.step((-0.39, 0.0), True, DT).position == (0.5, 0.0)
    assert follower.step((0.3, 0.0), True, DT).position == (0.5, 0.5)
    last = follower.step((0.45, 0.4), True, DT)
    assert last.position == (0.0, 0.5) and last.finished and last.velocity == (0.0, 0.0)


def test_the_papers_heading_is_zero_or_pi_by_the_legs_x_and_kept_along_y() -> None:
    follower = CellFollower(path((0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)), 3.0)
    yaws = [
        follower.step(here, True, DT).yaw
        for here in ((9.0, 0.0), (0.0, 0.0), (0.5, 0.0), (0.5, 0.5))
    ]
    assert yaws == [pi, 0.0, 0.0, pi]


@given(st.floats(-10.0, 10.0))
def test_paper_heading_is_the_nearer_of_its_two(yaw: float) -> None:
    off = np.angle(np.exp(1j * (paper_heading(yaw) - yaw)))
    assert abs(off) <= pi / 2 + 1e-9
