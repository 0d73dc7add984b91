"""A mirrored tracking frame and a drone that tells no speed of its own."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey
from housefly.pilot.safety import lean_consistency

MIRRORED = TrialKey("F07/axes", 0, model="tello")


@pytest.mark.safety
@pytest.mark.slow
def test_it_lands_before_it_touches_anything_and_flies_into_the_kitchen_unwatched(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    watched = fly_trial(MIRRORED)
    assert not watched.violations
    assert watched.ending == "stands on the floor"
    assert "mirror image" in watched.told
    monkeypatch.setattr(lean_consistency, "MIRRORED_SHARE", 0.0)
    assert fly_trial(MIRRORED).violations
