"""Tracking that lies in pieces, and reports with holes: nothing that was found is forgotten."""

from __future__ import annotations

from math import inf, radians

import pytest
from felt_flight import FeltFlight, judged

from housefly.pilot.safety.tracking_rules import DRIFT_WARN

BEGINS = 10.0
"""Lies begin then [s]."""
LIE_MAX = 0.3
"""By then the drone has to be landing [m]."""


def cruise(t: float) -> float:
    """Return the speed of a drone that sets off after a second [m/s]."""
    return min(max(t - 1.0, 0.0), 0.5)


def drifting(t: float) -> float:
    """Return a lie that grows by 2 cm a second [m]."""
    return 0.02 * max(0.0, t - BEGINS)


@pytest.mark.parametrize("size", [0.10, 0.13])
@pytest.mark.parametrize("seed", range(3))
def test_lies_in_bursts_add_up(size: float, seed: int) -> None:
    def lie(t: float) -> float:
        bursts, since = divmod(max(0.0, t - BEGINS), 30.0)
        return size * bursts + min(size, 0.05 * since)

    judgement = judged(FeltFlight(lie=lie, way_error=0.001, seed=seed), 120.0)
    assert judgement.lie_when_landing < LIE_MAX


def test_a_lie_that_stays_is_not_forgotten() -> None:
    flight = FeltFlight(lie=lambda t: min(0.14, 0.05 * max(0.0, t - BEGINS)), way_error=0.001)
    judgement = judged(flight, 60.0)
    assert judgement.lie_when(DRIFT_WARN) < 0.1
    assert all(said > DRIFT_WARN for at, _, said in judgement.drifts if at > 15.0)


@pytest.mark.parametrize("period", [3.0, 5.0])
def test_a_drift_is_found_although_reports_have_holes(period: float) -> None:
    flight = FeltFlight(lie=drifting, reports=lambda t: t % period > 0.3, way_error=0.001)
    assert judged(flight, 40.0).lie_when_landing < LIE_MAX


def test_a_drift_is_found_although_the_clock_of_the_drone_stands() -> None:
    flight = FeltFlight(lie=drifting, clock=lambda t: 5.0, way_error=0.001)
    assert judged(flight, 40.0).lie_when_landing < LIE_MAX


@pytest.mark.parametrize("stuck", [0.0, 0.004])
def test_flow_that_hangs_says_that_nothing_is_known(stuck: float) -> None:
    flight = FeltFlight(flow=lambda t, v: stuck if t > 8.0 else v)
    assert judged(flight, 12.0).is_silent_at_the_end


@pytest.mark.parametrize("hole", [0.2, 0.26, 0.3, 0.34])
@pytest.mark.parametrize("offset", [0.01, 0.06])
def test_a_hole_of_the_reports_between_two_poses_is_no_drift(hole: float, offset: float) -> None:
    flight = FeltFlight(
        speed=cruise,
        reports=lambda t: not 6.0 + offset < t < 6.0 + offset + hole,
        seen_every=0.1,
        told_every=0.01,
    )
    assert judged(flight, 12.0).largest == 0.0


@pytest.mark.parametrize("seconds", [0.12, 0.3])
def test_flow_that_fails_for_a_moment_is_no_drift(seconds: float) -> None:
    flight = FeltFlight(
        speed=cruise, flow=lambda t, v: 0.0 if 6.0 <= t < 6.0 + seconds or 9.0 <= t < 9.2 else v
    )
    assert judged(flight, 14.0).largest == 0.0


def test_more_than_half_a_turn_while_nobody_looks_is_no_turned_frame() -> None:
    flight = FeltFlight(
        turning=lambda t: 1.75 if t > 4.0 else 0.0, sees=lambda t: not 5.0 < t < 6.9
    )
    judgement = judged(flight, 10.0)
    assert not judgement.mirrored
    assert judgement.frame_error < radians(10.0)


def test_an_honest_flight_shows_nothing() -> None:
    judgement = judged(FeltFlight(speed=cruise, turning=lambda t: 0.3), 30.0)
    assert judgement.largest == 0.0 and judgement.lie_when(0.0) == inf
    assert judgement.frame_error < radians(10.0) and not judgement.mirrored
