"""Trust in words that grow old."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.confidence import KNOWN_THRESHOLD, freshness, noisy_or

AGES = st.floats(0.0, 1e6)
BEATS = st.floats(0.1, 3600.0)
SHARES = st.lists(st.floats(0.0, 1.0), max_size=6)


@given(AGES, AGES, BEATS)
def test_an_older_word_is_never_believed_more(age: float, more: float, heartbeat: float) -> None:
    assert 0.0 <= freshness(age + more, heartbeat) <= freshness(age, heartbeat) <= 1.0


@given(BEATS)
def test_two_missing_beats_cost_nothing_and_after_four_nothing_is_known(heartbeat: float) -> None:
    assert freshness(1.999 * heartbeat, heartbeat) == 1.0
    assert freshness(3.999 * heartbeat, heartbeat) >= KNOWN_THRESHOLD
    assert freshness(4.001 * heartbeat, heartbeat) == 0.0


@given(SHARES, st.floats(0.0, 1.0))
def test_a_further_word_never_lowers_the_confidence(shares: list[float], further: float) -> None:
    assert 0.0 <= noisy_or(shares) <= noisy_or([*shares, further]) + 1e-12 <= 1.0 + 1e-9


def test_two_halves_make_three_quarters() -> None:
    assert noisy_or([0.5, 0.5]) == pytest.approx(0.75)
