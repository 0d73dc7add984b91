"""Flights whose drone hears nobody any more: what it was last told stands until it lands itself.

Each of these touched furniture while the drone waited for 2 s, as it does by itself.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.lab.lockstep import lockstep_room
from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey

SILENT_FLIGHTS = pytest.mark.parametrize(
    "flight",
    [TrialKey("F25/gone", 187), pytest.param(TrialKey("F17/off", 238), marks=pytest.mark.safety)],
    ids=lambda key: key.row,
)


@SILENT_FLIGHTS
def test_a_drone_that_lands_after_a_second_of_silence_stays_off_the_furniture(
    flight: TrialKey,
) -> None:
    result = fly_trial(flight)
    assert not result.unsafe
    assert result.deviation < 0.6


@SILENT_FLIGHTS
def test_the_same_drone_as_it_comes_from_its_maker_does_harm(
    flight: TrialKey, monkeypatch: pytest.MonkeyPatch
) -> None:
    limits = lockstep_room.onboard_limits
    monkeypatch.setattr(
        lockstep_room, "onboard_limits", lambda site: replace(limits(site), silence=2.0)
    )
    assert any(words.startswith("I1") for words in fly_trial(flight).violations)
