from __future__ import annotations

from math import isnan, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.pilot.estimation.climb_odometry import (
    READING_GAP,
    STUCK_TIME,
    ClimbOdometry,
)

SONAR = airframe_named("ardrone").sonar
PING_TIME = SONAR.ping_time
PERIOD = 0.02
STEP_MIN = SONAR.climb_rate_max * PING_TIME + SONAR.noise
"""A step of the floor that is lower may be a climb [m]."""


def felt(*heights: float, period: float = PERIOD) -> ClimbOdometry:
    """Return the odometry of a drone whose sonar read so; it began above the floor."""
    odometry = ClimbOdometry(SONAR).updated(0.0, heights[0]).over_floor()
    for n, height in enumerate(heights[1:], 1):
        odometry = odometry.updated(period * n, height)
    return odometry


def climbed(*heights: float) -> float:
    """Return how far a drone has climbed whose sonar read so, a reading every 20 ms."""
    return felt(*heights).climbed


@given(st.floats(-1.0, 1.0), st.floats(-0.7, 0.7))
def test_a_step_of_the_floor_is_no_climb(step: float, rate: float) -> None:
    over = [1.5 + rate * PERIOD * n for n in range(50)]
    beside = [1.5 + step + rate * PERIOD * n for n in range(50, 100)]
    expected = rate * PERIOD * 99 + (step if abs(step) < 0.04 else 0.0)
    assert climbed(*over, *beside) == pytest.approx(expected, abs=STEP_MIN + 0.01)


@given(st.floats(-1.0, 1.0).filter(lambda step: abs(step) > 0.11), st.floats(-0.7, 0.7))
def test_steps_of_the_floor_are_summed_until_the_floor_is_seen_again(
    step: float, rate: float
) -> None:
    over = [1.5 + rate * PERIOD * n for n in range(50)]
    beside = [1.5 + step + rate * PERIOD * n for n in range(50, 100)]
    odometry = felt(*over, *beside)
    assert odometry.stepped == pytest.approx(step, abs=0.02)
    back = [1.5 + rate * PERIOD * n for n in range(100, 150)]
    assert felt(*over, *beside, *back).stepped == pytest.approx(0.0, abs=0.04)
    assert odometry.over_floor().stepped == 0.0


def test_a_climb_is_no_step_though_reports_repeat_what_the_sonar_measured_last() -> None:
    pinged = [1.0 + 0.7 * PING_TIME * (n // 8) for n in range(200)]
    odometry = felt(*pinged, period=PING_TIME / 8)
    assert odometry.stepped == 0.0
    assert odometry.climbed == pytest.approx(pinged[-1] - pinged[0])


def test_where_readings_were_missing_nobody_knows_the_steps_until_the_floor_is_seen() -> None:
    late = felt(1.0, 1.0).updated(1.0, 0.6)
    assert isnan(late.stepped) and isnan(late.updated(1.02, 0.6).stepped)
    assert late.over_floor().updated(1.02, 0.3).stepped == pytest.approx(-0.3)
    assert isnan(felt(1.0, nan, 1.0).stepped)
    assert isnan(felt(*[1.0] * round(2.0 + STUCK_TIME / PERIOD)).stepped)
    assert felt(*[1.0] * round(STUCK_TIME / PERIOD)).stepped == 0.0
    assert felt(1.0, 1.0).updated(PERIOD + READING_GAP, 0.99).stepped == 0.0


def test_readings_that_are_none_and_the_first_one_add_nothing() -> None:
    assert climbed(1.0) == 0.0
    assert climbed(1.0, 1.01, nan, 1.5, 1.51) == pytest.approx(0.02)
