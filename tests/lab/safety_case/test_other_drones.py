"""Flights of other drones that did harm once, or never ended, in a cut of the safety case."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(
    ("model", "row", "seed", "told"),
    [
        ("crazyflie", "F22/60percent", 0, "while it took off"),
        ("tello", "F23/tether", 0, "and does not move"),
        pytest.param("px4", "F02/1s", 1, "tracking lost", marks=pytest.mark.interop),
        pytest.param("crazyflie", "F12/0.2s", 1, "", marks=pytest.mark.interop),
        pytest.param("betaflight", "F12/0.2s", 0, "", marks=pytest.mark.interop),
        pytest.param("betaflight", "F12/0.2s", 1, "", marks=pytest.mark.interop),
        pytest.param("betaflight", "F50/garbage", 14, "", marks=pytest.mark.interop),
    ],
)
def test_it_lands_or_flies_on_and_touches_nothing(
    model: str, row: str, seed: int, told: str
) -> None:
    result = fly_trial(TrialKey(row, seed, model=model))
    assert result.violations == () and result.ending == "stands on the floor"
    assert told in result.told
