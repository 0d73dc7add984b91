"""The offset between two clocks, by the quickest of what came lately."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.clock import ClockOffset


@given(st.lists(st.tuples(st.floats(0.0, 1.0), st.floats(-5.0, 5.0)), max_size=60))
def test_it_is_the_smallest_offset_of_the_window(steps: list[tuple[float, float]]) -> None:
    clock, at, seen = ClockOffset(2.0), 0.0, list[tuple[float, float]]()
    for pause, offset in steps:
        at += pause
        seen.append((at, offset))
        assert clock.least(offset, at) == min(one for when, one in seen if when >= at - 2.0)


def test_another_clock_begins_anew() -> None:
    clock = ClockOffset(2.0)
    clock.least(-3.0, 1.0)
    clock.reset()
    assert clock.least(4.0, 1.1) == 4.0
