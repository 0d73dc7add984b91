"""Draughts and gusts as strong as 1 m/s: told, landed, and nothing is struck."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey


@pytest.mark.parametrize(
    ("row", "seed"),
    [
        ("F23/storm", 43),
        pytest.param("F23/wind", 0, marks=pytest.mark.safety),
        pytest.param("F23/storm", 16, marks=pytest.mark.safety),
    ],
    ids=["gusts in flight", "draught at take-off", "gust at lift-off"],
)
def test_a_drone_that_is_blown_about_lands_before_it_strikes_something(row: str, seed: int) -> None:
    result = fly_trial(TrialKey(row, seed))
    assert result.violations == () and result.told
    assert result.room_clearance > 0.05


@pytest.mark.safety
def test_without_guards_gusts_blow_it_into_the_wall() -> None:
    assert fly_trial(TrialKey("F23/storm", 43, guarded=False)).violations
