"""Flights that are alike until their faults begin are flown together, and are no others for it."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.campaign import alike, fly_alike
from housefly.lab.safety_case.faulty_flight import course_of, fly_trial, onset_of
from housefly.lab.safety_case.plan import SafetyPlan
from housefly.lab.safety_case.trial import TrialKey

CLIMBING = (TrialKey("F22/off", 1), TrialKey("F22/60percent", 1))
"""Two that fail while they climb, and are soon over."""


def test_every_flight_of_a_plan_is_in_one_group_and_a_group_has_one_course() -> None:
    keys = SafetyPlan(seeds=20, controls=4, pairs=1, fault_free=9).keys()
    groups = list(alike(keys))
    assert sorted((key for group in groups for key in group), key=repr) == sorted(keys, key=repr)
    assert all(len({course_of(key) for key in group}) == 1 for group in groups)
    assert len(groups) < len(keys) / 3


@pytest.mark.safety
def test_flown_together_they_are_the_same_to_the_last_bit_as_flown_alone() -> None:
    assert len({onset_of(key) for key in CLIMBING}) > 1
    together = {result.key: result for result in fly_alike(CLIMBING)}
    assert together == {key: fly_trial(key) for key in CLIMBING}


def test_a_flight_that_fails_in_its_child_is_told(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    keys = (TrialKey("F22/off", 0), TrialKey("F25/gone", 0))
    monkeypatch.setattr("housefly.lab.safety_case.faulty_flight._cannot_hover", lambda key: 1 / 0)
    with pytest.raises(ChildProcessError):
        fly_alike(keys)
    assert "ZeroDivisionError" in capfd.readouterr().err
