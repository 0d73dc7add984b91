"""Where a landing that the gate asks for comes down, scored on the truth."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey


@pytest.mark.safety
def test_held_by_a_tether_above_the_corner_of_a_sofa_it_lands_beside_the_sofa() -> None:
    result = fly_trial(TrialKey("F23+F34", 0))
    assert not result.violations
    assert result.ending == "stands on the floor"
