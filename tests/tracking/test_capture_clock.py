"""Capture times from frame numbers: jitter does not reach them, and they never run backwards."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.tracking.capture_clock import OFFSET_WINDOW, CaptureClock

PERIOD, LATENCY, START = 0.01, 0.02, 100.0


@given(st.lists(st.floats(0.0, 0.2), min_size=1, max_size=200))
def test_capture_times_neither_run_backwards_nor_into_the_future(delays: list[float]) -> None:
    clock = CaptureClock()
    last = float("-inf")
    received = 0.0
    for number, delay in enumerate(delays):
        received = max(received, START + number * PERIOD + LATENCY + delay)
        captured = clock.captured_at(number, PERIOD, LATENCY, received)
        assert last <= captured <= received - LATENCY + 1e-9
        last = captured


def test_jitter_vanishes_once_one_frame_came_without_delay() -> None:
    clock = CaptureClock()
    for number in range(90):
        delay = 0.0 if number == 5 else 0.004 * (number % 3)
        captured = clock.captured_at(
            number, PERIOD, LATENCY, START + number * PERIOD + LATENCY + delay
        )
        if number >= 5:
            assert captured == pytest.approx(START + number * PERIOD)


def test_a_server_whose_clock_slips_is_followed_within_the_window() -> None:
    clock = CaptureClock()
    slip = 0.3
    for number in range(200):
        late = slip if number >= 50 else 0.0
        captured = clock.captured_at(
            number, PERIOD, LATENCY, START + late + number * PERIOD + LATENCY
        )
        if number * PERIOD > 50 * PERIOD + OFFSET_WINDOW + 0.05:
            assert captured == pytest.approx(START + slip + number * PERIOD)


def test_without_a_period_the_latency_alone_counts() -> None:
    assert CaptureClock().captured_at(7, 0.0, LATENCY, START) == START - LATENCY
