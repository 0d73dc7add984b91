from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.drones.ardrone.telemetry import EchoFilter

REPORT_PERIOD, REPORTS_PER_ECHO = 0.005, 8


def filtered(*echoes: float) -> list[float]:
    """Return what is believed at the end of each echo, which 8 reports repeat."""
    echo_filter, believed = EchoFilter(), list[float]()
    for number, echo in enumerate(echoes):
        for repeat in range(REPORTS_PER_ECHO):
            at = REPORT_PERIOD * (REPORTS_PER_ECHO * number + repeat)
            height = echo_filter.filtered(echo, at)
        believed.append(height)
    return believed


@given(st.floats(0.0, 6.0), st.integers(1, 20))
def test_one_wrong_echo_is_not_believed(wrong: float, at: int) -> None:
    echoes = [1.1 + 0.001 * n for n in range(25)]
    told = filtered(*echoes[:at], wrong, *echoes[at + 1 :])
    assert told[:at] + told[at + 1 :] == echoes[:at] + echoes[at + 1 :]
    assert told[at] in (wrong, echoes[at - 1]) and abs(told[at] - 1.1) < 0.2


def test_something_below_is_believed_with_the_second_echo() -> None:
    assert filtered(1.1, 1.1, 0.7, 0.7, 0.7, 1.1, 1.1) == [1.1, 1.1, 1.1, 0.7, 0.7, 0.7, 1.1]
    assert filtered(1.1, 1.1, 0.7, 0.68)[2:] == [1.1, 0.68]


@given(st.lists(st.floats(-0.06, 0.06), min_size=2, max_size=40))
def test_a_climb_is_not_late(steps: list[float]) -> None:
    heights = [1.5]
    for step in steps:
        heights.append(heights[-1] + step)
    assert filtered(*heights) == heights


def test_an_echo_that_stays_the_same_to_the_last_bit_is_believed() -> None:
    echo_filter = EchoFilter()
    echo_filter.filtered(1.1, 0.0)
    told = [echo_filter.filtered(0.7, 0.005 * n) for n in range(1, 13)]
    assert told[0] == 1.1 and told[-1] == pytest.approx(0.7)
