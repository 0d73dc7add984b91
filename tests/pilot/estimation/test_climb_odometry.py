from __future__ import annotations

from math import nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.climb_odometry import ClimbOdometry

PERIOD = 0.02


def climbed(*heights: float) -> float:
    """Return how far a drone has climbed whose sonar read so, a reading every 20 ms."""
    odometry = ClimbOdometry()
    for n, height in enumerate(heights):
        odometry = odometry.updated(PERIOD * n, height)
    return odometry.climbed


@given(st.floats(-1.0, 1.0), st.floats(-0.7, 0.7))
def test_a_step_of_the_floor_is_no_climb(step: float, rate: float) -> None:
    over = [1.5 + rate * PERIOD * n for n in range(50)]
    beside = [1.5 + step + rate * PERIOD * n for n in range(50, 100)]
    expected = rate * PERIOD * 99 + (step if abs(step) < 0.04 else 0.0)
    assert climbed(*over, *beside) == pytest.approx(expected, abs=0.08)


def test_readings_that_are_none_and_the_first_one_add_nothing() -> None:
    assert climbed(1.0) == 0.0
    assert climbed(1.0, 1.01, nan, 1.5, 1.51) == pytest.approx(0.02)
