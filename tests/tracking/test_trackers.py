"""Every tracking system that a site can name has its client."""

from __future__ import annotations

from typing import get_args

from housefly.clock import RealClock
from housefly.config.tracking import TrackingConfig, TrackingKind
from housefly.tracking.trackers import TRACKERS, tracker_of


def test_every_kind_has_a_client_that_says_what_it_waits_for() -> None:
    assert set(TRACKERS) == set(get_args(TrackingKind))
    for kind in get_args(TrackingKind):
        tracker = tracker_of(TrackingConfig(kind=kind), RealClock())
        assert not tracker.connected
        where = "/{body}/pose" if kind == "ros2" else "127.0.0.1"
        assert where in tracker.problem
