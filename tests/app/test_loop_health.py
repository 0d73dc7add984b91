"""How late a step is, whatever held it up."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.app.loop_health import Gap


@given(st.lists(st.floats(0.0, 5.0), min_size=1, max_size=30))
def test_lateness_is_what_the_gap_has_more_than_a_period(gaps: list[float]) -> None:
    gap, now = Gap(0.01), 100.0
    assert gap.lateness(now) == 0.0
    for pause in gaps:
        now += pause
        assert gap.lateness(now) == pytest.approx(max(0.0, pause - 0.01), abs=1e-9)


def test_a_clock_that_runs_backwards_makes_no_negative_lateness() -> None:
    gap = Gap(0.01)
    gap.lateness(5.0)
    assert gap.lateness(1.0) == 0.0
