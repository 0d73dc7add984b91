"""A drone whose reported attitude hangs leans by tracking as it should."""

from __future__ import annotations

from collections import deque
from math import isfinite, nan

import pytest

from housefly.geometry import quaternion_from_euler
from housefly.pilot.estimation.consistency import SEEN_MAX, STUCK_AFTER, LeanWatch
from housefly.pilot.estimation.onboard_odometry import OnboardReport

PERIOD = 0.01
GAIN, DELAY = 7.0, 5
"""The drone turns at this rate per wanted change of its attitude [1/s]; periods of delay."""


def report(at: float, theta: float, phi: float, speed: float, airborne: bool) -> OnboardReport:
    return OnboardReport(at, theta, phi, 0.2, speed, 0.0, 1.1, 0.0, airborne, nan)


def hung(seconds: float, *, moves: bool = True, airborne: bool = True) -> LeanWatch:
    """Return the watch over a drone that has told the same attitude for so long [s]."""
    watch = LeanWatch()
    for step in range(round(seconds / PERIOD) + 1):
        now = step * PERIOD
        watch.see(now, quaternion_from_euler(0.0, 0.0, 1.0))
        watch.feel(report(now, 0.05, -0.02, 0.1 + moves * 0.001 * step, airborne))
    return watch


def test_an_attitude_that_stands_still_while_the_speed_changes_hangs() -> None:
    assert hung(STUCK_AFTER + 0.05).is_stuck
    assert not hung(STUCK_AFTER - 0.05).is_stuck


def test_reports_that_stand_still_altogether_and_a_standing_drone_say_nothing_of_attitude() -> None:
    assert not hung(1.0, moves=False).is_stuck
    assert not hung(1.0, airborne=False).is_stuck


def test_who_tells_how_it_leans_or_is_not_seen_is_asked_for_nothing_more() -> None:
    assert hung(STUCK_AFTER - 0.05).missing(0.1) is None
    watch = hung(1.0)
    assert watch.missing(1.0) is not None
    assert watch.missing(1.0 + SEEN_MAX + 0.01) is None


def test_an_attitude_that_moves_again_is_believed_again() -> None:
    watch = hung(1.0)
    watch.feel(report(1.01, 0.051, -0.02, 0.3, True))
    assert not watch.is_stuck and watch.missing(1.01) is None


def test_a_drone_that_is_seen_before_it_tells_how_it_leans_is_asked_for_numbers() -> None:
    missing = hung(1.0).missing(1.0)
    assert missing is not None and all(map(isfinite, missing))


@pytest.mark.parametrize("crooked", [0.0, 0.03])
def test_what_is_asked_for_besides_makes_the_drone_lean_as_it_should(crooked: float) -> None:
    """A body that was defined crooked is learned before."""
    watch, theta, told = LeanWatch(), 0.0, 0.0
    seen: deque[float] = deque([0.0] * DELAY, maxlen=DELAY)
    for step in range(2000):
        now, wanted = step * PERIOD, 0.05 if step < 1000 else (-0.1, 0.1)[step // 200 % 2]
        if step < 1000:
            told = theta + 1e-9 * step
        missing = watch.missing(now) or (0.0, 0.0)
        theta += PERIOD * GAIN * (wanted + missing[0] - told)
        watch.feel(report(now, told, 1e-9, 0.001 * step, True))
        watch.see(now, quaternion_from_euler(0.0, seen[0] + crooked, 1.0))
        seen.append(theta)
        if step > 1000 and step % 200 == 199:
            assert watch.is_stuck and theta == pytest.approx(wanted, abs=0.01)
