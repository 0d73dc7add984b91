"""A trajectory as the profile that is flown and the path that is shown."""

from __future__ import annotations

from itertools import pairwise
from math import dist, nan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from straight_motion import straight

from housefly.numeric import wrapped
from housefly.pilot.behavior.path_profile import NO_PATH
from housefly.pilot.behavior.trajectory_profile import trajectory_path, trajectory_profile
from housefly.pilot.behavior.trajectory_progress import is_in_space
from housefly.pilot.behavior.yaw_reference import YAW_REFERENCE_RATE
from housefly.pilot.planning.trajectory.timing import TICK


@settings(max_examples=25)
@given(st.floats(0.0, 6.0), st.floats(0.1, 12.0), st.floats(-0.5, 0.5))
def test_the_shown_points_lie_on_the_motion_at_their_times_near_each_other(
    length: float, seconds: float, height: float
) -> None:
    rows = straight(length, seconds, height)
    path, profile = trajectory_path(rows, 0.4), trajectory_profile(rows, 0.3, nan)
    places = [(x, y, z) for (x, y), z in zip(path.waypoints, path.heights, strict=True)]
    for place, at, speed in zip(places, path.times, path.speeds, strict=True):
        row = rows[round(at / TICK)]
        assert place == pytest.approx(tuple(row[:3])) and speed == pytest.approx(
            np.linalg.norm(row[3:6])
        )
    assert path.times[0] == 0.0 and path.times[-1] == pytest.approx(TICK * (len(rows) - 1))
    assert all(dist(a, b) < 0.4 or b[1] for a, b in pairwise(places) if len(rows) > 60)
    assert path.length == pytest.approx(np.hypot(length, height), abs=1e-3)
    assert profile.marks.tolist() == list(path.times)
    assert profile.points.tolist() == [list(point) for point in path.waypoints]


def test_a_profile_in_space_carries_the_heading_and_one_in_the_plane_no_motion() -> None:
    rows = straight(3.0, 5.0)
    profile = trajectory_profile(rows, 1.0, -1.0)
    assert is_in_space(profile) and not is_in_space(NO_PATH)
    assert profile.motion[:, :9].tolist() == rows.tolist() and profile.motion[0, 9] == 1.0
    turns = [abs(wrapped(b - a)) for a, b in pairwise(profile.motion[:, 9].tolist())]
    assert max(turns) <= YAW_REFERENCE_RATE * TICK + 1e-9
    assert profile.motion[-1, 9] == pytest.approx(-1.0, abs=0.05)


def test_where_a_door_leaves_no_choice_its_headings_are_flown() -> None:
    rows = straight(3.0, 5.0)
    held = np.full(100, 0.7)
    found = trajectory_profile(rows, 0.2, 1.5, held).motion[:, 9]
    assert found[: len(rows) - 100].tolist() == [0.2] * (len(rows) - 100)
    assert found[-100:].tolist() == held.tolist()
