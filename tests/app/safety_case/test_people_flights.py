"""People and things in the way of a lock-step flight, scored on the truth."""

from __future__ import annotations

import pytest

from housefly.app.safety_case.faulty_flight import fly_trial
from housefly.app.safety_case.trial import TrialKey


@pytest.mark.parametrize(
    ("row", "seed", "least"),
    [
        ("F34/walks_up", 2, 0.3),
        pytest.param("F34/walks_up", 3, 0.3, marks=pytest.mark.safety),
        pytest.param("F34/head_on", 3, 0.0, marks=pytest.mark.safety),
        ("F34/head_on", 7, 0.3),
        pytest.param("F44/child", 3, 0.4, marks=pytest.mark.safety),
    ],
)
def test_nobody_is_touched(row: str, seed: int, least: float) -> None:
    """Who walks up while the drone turns, cruises and lands; a child on the pad."""
    result = fly_trial(TrialKey(row, seed))
    assert not result.violations
    assert result.person_clearance is not None
    assert result.person_clearance > least
