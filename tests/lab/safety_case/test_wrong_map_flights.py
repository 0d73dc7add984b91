"""A map that was wrong from the first frame on, scored on the truth."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey


@pytest.mark.parametrize("wrong", ["shifted_0.5m", "shifted_y_0.5m", "turned"])
def test_a_map_that_is_shifted_or_turned_from_the_start_keeps_the_drone_on_its_pad(
    wrong: str,
) -> None:
    result = fly_trial(TrialKey(f"F42/{wrong}", 0))
    assert not result.violations and result.phase is FaultPhase.FROM_START
    assert "tracking has not seen the drone on its pad" in result.told
    assert result.top_speed == 0.0


def test_without_looking_at_the_pad_the_same_map_leads_into_a_wall() -> None:
    result = fly_trial(TrialKey("F42/shifted_y_0.5m", 0, guarded=False))
    assert any("touched room wall" in words for words in result.violations)
