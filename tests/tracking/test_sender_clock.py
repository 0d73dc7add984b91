"""Capture times from a sender's stamps: never in the future, never backwards, each frame once."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.tracking.counts import FrameCounts
from housefly.tracking.sender_clock import CLOCK_JUMP, SenderClock

TICK, LATENCY = 1e-6, 0.02


@given(st.lists(st.tuples(st.integers(0, 2**63), st.floats(0.0, 2.0)), min_size=1, max_size=50))
def test_whatever_is_stamped_captures_neither_run_backwards_nor_into_the_future(
    frames: list[tuple[int, float]],
) -> None:
    counts = FrameCounts()
    clock = SenderClock(counts)
    now, last, used = 100.0, float("-inf"), 0
    for stamp, pause in frames:
        now += pause
        captured = clock.captured_at(stamp, TICK, LATENCY, now)
        if captured is not None:
            used += 1
            assert last <= captured <= now - LATENCY + 1e-9
            last = captured
    assert used + counts.repeated + counts.backward == len(frames)


@given(st.lists(st.floats(0.0, 0.005), min_size=20, max_size=100), st.integers(0, 10**15))
def test_jitter_on_the_way_does_not_reach_the_capture_times(
    delays: list[float], start: int
) -> None:
    clock = SenderClock(FrameCounts())
    times = []
    for number, delay in enumerate([0.0, *delays]):
        now = 100.0 + 0.01 * number + LATENCY + delay
        times.append(clock.captured_at(start + 10_000 * number, TICK, LATENCY, now))
    assert times == pytest.approx([100.0 + 0.01 * number for number in range(len(times))], abs=1e-5)


def test_repeated_and_late_frames_are_dropped_and_counted() -> None:
    counts = FrameCounts()
    clock = SenderClock(counts)
    taken = [
        clock.captured_at(stamp, 0.001, LATENCY, 100.0 + 0.01 * n)
        for n, stamp in enumerate((50, 60, 60, 55, 70))
    ]
    assert [captured is not None for captured in taken] == [True, True, False, False, True]
    assert (counts.repeated, counts.backward) == (1, 1)


@pytest.mark.parametrize("leap", [3600.0, -3600.0, CLOCK_JUMP + 0.1, -CLOCK_JUMP - 0.1])
def test_a_clock_that_was_set_anew_costs_no_frame(leap: float) -> None:
    counts = FrameCounts()
    clock = SenderClock(counts)
    for number in range(200):
        stamp = 10_000 * number + round((5000.0 + leap * (number >= 100)) / TICK)
        captured = clock.captured_at(stamp, TICK, LATENCY, 100.0 + 0.01 * number + LATENCY)
        assert captured == pytest.approx(100.0 + 0.01 * number)
    assert counts.jumps == 1


def test_a_pause_is_no_leap() -> None:
    counts = FrameCounts()
    clock = SenderClock(counts)
    clock.captured_at(0, 1.0, LATENCY, 100.0)
    assert clock.captured_at(30, 1.0, LATENCY, 130.0) == pytest.approx(130.0 - LATENCY)
    assert counts.jumps == 0
