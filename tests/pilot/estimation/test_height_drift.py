"""A tracked height that rises by itself is told apart from things below the drone."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from ardrone_flow import FLOW
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.messages import DroneStatus, Pose, Sighting, Telemetry
from housefly.pilot.estimation.displacement import OdometryTolerance
from housefly.pilot.estimation.tracking_monitor import TrackingMonitor
from housefly.pilot.safety.tracking_rules import HEIGHT_DISAGREES

TICK = 0.01
LASTS = 0.5
"""A drift counts for the gate once it has been there for so long [s]."""
Heights = Callable[[float], float]
"""Of the time [s]; [m]."""


def first_drift(
    height: Heights,
    floor: Heights = lambda t: 0.0,
    lie: Heights = lambda t: 0.0,
    *,
    seconds: float = 20.0,
    ping: float = 0.04,
    is_heard: Callable[[float], bool] = lambda t: True,
    is_seen: Callable[[float], bool] = lambda t: True,
    seed: int = 0,
) -> float:
    """Return the lie [m] at which the gate lands a drone at these heights; nan for never."""
    monitor, rng = (
        TrackingMonitor(
            OdometryTolerance(0.002, 0.05, FLOW), 0.58, airframe_named("ardrone").sonar
        ),
        np.random.default_rng(seed),
    )
    since, reading, next_ping = np.inf, 0.0, 0.0
    for t in np.arange(0.0, seconds, TICK).tolist():
        if t >= next_ping:
            next_ping += ping
            reading = height(t) - floor(t) + 0.01 * float(rng.standard_normal())
        if is_heard(t):
            report = Telemetry(t, DroneStatus.FLYING, 0.8, 0.001, 0.001, 0.0, reading)
            monitor.feel(report, DroneStatus.FLYING, 0.0)
        # Along x, so that the floor at the take-off is far behind.
        place = (0.5 * t, 0.0, height(t) + lie(t) + 0.001 * float(rng.standard_normal()))
        if is_seen(t):
            monitor.accept(Sighting("drone", Pose(place, (1.0, 0.0, 0.0, 0.0)), t, t))
        drift = monitor.consistency(t).height_drift
        since = min(since, t) if drift > HEIGHT_DISAGREES else np.inf
        if t - since >= LASTS:
            return lie(t)
    return float("nan")


def steady(t: float) -> float:
    return 1.1


def rising(rate: float, since: float = 4.0) -> Heights:
    return lambda t: rate * max(0.0, t - since)


@given(st.floats(0.01, 0.2), st.integers(0, 99))
@settings(max_examples=15)
def test_a_height_that_rises_by_itself_is_found_before_it_is_half_a_metre(
    rate: float, seed: int
) -> None:
    found = first_drift(steady, lie=rising(rate), seconds=4.0 + 0.6 / rate, seed=seed)
    assert HEIGHT_DISAGREES - 0.03 < found < 0.5


@given(st.floats(0.05, 1.0), st.floats(0.1, 6.0), st.integers(0, 99))
@settings(max_examples=25)
def test_a_thing_below_is_no_drift_of_the_height(size: float, length: float, seed: int) -> None:
    found = first_drift(steady, lambda t: size if 4.0 < t < 4.0 + length else 0.0, seed=seed)
    assert np.isnan(found)


@given(st.lists(st.integers(0, 6), min_size=3, max_size=40), st.integers(0, 99))
@settings(max_examples=25)
def test_a_rough_floor_is_no_drift_of_the_height(steps: list[int], seed: int) -> None:
    found = first_drift(steady, lambda t: 0.15 * steps[int(2.0 * t) % len(steps)], seed=seed)
    assert np.isnan(found)


@pytest.mark.parametrize("rate", [-0.7, 0.7])
@pytest.mark.parametrize("ping", [0.02, 0.04, 0.065])
def test_a_climb_above_a_thing_is_no_drift_of_the_height(rate: float, ping: float) -> None:
    found = first_drift(
        lambda t: 1.8 + rate * min(max(t - 8.0, 0.0), 1.2), lambda t: 0.7 if t > 4.0 else 0.0,
        ping=ping,
    )  # fmt: skip
    assert np.isnan(found)


def test_a_height_that_rises_above_a_thing_is_found_too() -> None:
    found = first_drift(steady, lambda t: 0.5 if t > 3.0 else 0.0, rising(0.05))
    assert found < 0.5


def test_after_a_gap_of_the_reports_nothing_is_said_before_the_floor_is_seen() -> None:
    found = first_drift(
        steady, lambda t: 0.7 if 5.0 < t < 12.0 else 0.0, is_heard=lambda t: not 4.5 < t < 5.5
    )
    assert np.isnan(found)


@given(st.floats(0.3, 0.9), st.floats(0.0, 0.3), st.integers(0, 99))
@settings(max_examples=25)
def test_the_last_sighting_before_a_gap_says_nothing_of_a_floor_that_has_just_stepped_away(
    size: float, after: float, seed: int
) -> None:
    found = first_drift(
        steady,
        lambda t: size if 4.0 < t < 8.0 else 0.0,
        is_seen=lambda t: not 8.0 + after < t < 9.0,
        seconds=10.0,
        seed=seed,
    )
    assert np.isnan(found)
