from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.twin.ardrone.altitude_estimator import AltitudeEstimator
from housefly.twin.contracts import FlightState, OnboardState

PERIOD = 0.005
FLYING = OnboardState(
    0.0, FlightState.FLYING, 0.8, 11.5, *[0.0] * 4, *[(0.0, 0.0, 0.0)] * 3, (0.5, 0.5, 0.5, 0.5)
)


def altitudes(*heights: float, flight: FlightState = FlightState.FLYING) -> list[float]:
    """Return what is told of raw heights that are 5 ms apart."""
    estimator = AltitudeEstimator()
    return [
        estimator.altitude(replace(FLYING, at=PERIOD * n, height=height, flight=flight))
        for n, height in enumerate(heights)
    ]


def test_a_table_below_changes_no_altitude() -> None:
    told = altitudes(*[1.1] * 20, *[0.7] * 20, *[1.1] * 20)
    assert told == pytest.approx([1.1] * 60)


@given(st.floats(-1.0, 1.0))
def test_a_climb_is_told(speed: float) -> None:
    heights = [1.5 + speed * PERIOD * n for n in range(200)]
    assert altitudes(*heights) == pytest.approx(heights)


def test_a_drone_that_stands_forgets_what_was_below() -> None:
    estimator = AltitudeEstimator()
    for n, height in enumerate((1.1, 0.4)):
        told = estimator.altitude(replace(FLYING, at=n * PERIOD, height=height))
    assert told == pytest.approx(1.1)
    landed = replace(FLYING, at=3 * PERIOD, height=0.0, flight=FlightState.LANDED)
    assert estimator.altitude(landed) == 0.0
