"""Motors that weaken, a load, a fan: a drone that sinks says so, lands, and hits nothing."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey


@pytest.mark.parametrize(
    ("row", "seed", "words"),
    [
        ("F22/60percent", 2, "below its height"),
        pytest.param("F23/fan", 5, "below its height", marks=pytest.mark.safety),
        pytest.param("F23/50g", 1, "lower than", marks=pytest.mark.safety),
    ],
    ids=["a weak motor in a turn", "the wind of a ceiling fan", "50 g hung on in the climb"],
)
def test_a_drone_that_cannot_keep_its_height_says_so_and_lands(
    row: str, seed: int, words: str
) -> None:
    result = fly_trial(TrialKey(row, seed))
    assert not result.unsafe and result.ending == "stands on the floor"
    assert words in result.told
    assert result.safe_after is not None and result.safe_after < 15.0
    assert result.room_clearance is not None and result.room_clearance > 0.25
