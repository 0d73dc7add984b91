"""A drone that wants its pose is told it as often as it wants, and each sighting once."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.drones.pose_rate import PoseRate
from housefly.messages import Pose, Sighting


def seen(at: float) -> Sighting:
    return Sighting("drone", Pose((0.0, 0.0, 1.0)), at, at + 0.01)


@given(st.lists(st.floats(0.0, 10.0), max_size=50), st.floats(1.0, 100.0))
def test_what_passes_is_newer_and_no_denser_than_wanted(times: list[float], rate: float) -> None:
    pose_rate = PoseRate(rate)
    told = [one.captured_at for at in times if (one := pose_rate.due(seen(at)))]
    assert all(b - a >= 0.8 / rate for a, b in pairwise(told))
    assert not times or told[0] == times[0]


@pytest.mark.parametrize(("tracker", "wanted"), [(100.0, 20.0), (30.0, 50.0), (50.0, 50.0)])
def test_of_a_regular_tracker_the_wanted_rate_is_left_or_all_there_is(
    tracker: float, wanted: float
) -> None:
    pose_rate = PoseRate(wanted)
    told = sum(pose_rate.due(seen(tick / tracker)) is not None for tick in range(int(tracker)))
    assert told == pytest.approx(min(tracker, wanted), rel=0.3)


def test_one_that_wants_none_is_told_nothing_and_nothing_is_no_pose() -> None:
    assert PoseRate(None).due(seen(1.0)) is None
    assert PoseRate(20.0).due(None) is None
