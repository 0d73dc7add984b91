"""Scans are as old as they are, whatever their way here took."""

from __future__ import annotations

import random
from math import inf

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.sensors.scan_clock import CLOCK_DRIFT, ScanClock

STAMPS = 1 << 24
PERIOD_MS = 25


@given(
    delays=st.lists(st.floats(0.0, 20.0), min_size=2, max_size=60),
    start=st.integers(0, STAMPS - 1),
    drift=st.floats(-3e-4, 3e-4),
)
def test_a_scan_is_dated_by_the_quickest_before_it_however_long_it_waited(
    delays: list[float], start: int, drift: float
) -> None:
    clock, received, quickest = ScanClock(), 0.0, inf
    for number, delay in enumerate(delays):
        taken = number * PERIOD_MS / 1000.0 * (1.0 + drift)
        received = max(received, taken + delay)
        quickest = min(quickest, received - taken)
        dated = clock.taken_at((start + number * PERIOD_MS) % STAMPS, received)
        assert dated <= received + 1e-9
        assert abs(dated - taken - quickest) < 0.001 + CLOCK_DRIFT * received


def test_scans_that_come_ever_later_grow_old() -> None:
    clock = ScanClock()
    for number in range(2000):
        received = number * 0.025 * 1.5  # a third of them is read in time
        age = received - clock.taken_at(25 * number, received)
    assert age > 0.49 * received / 1.5


@pytest.mark.parametrize("lost", [0.4, 1.0, 368.0])
def test_a_clock_that_lost_time_is_found_anew_within_seconds(lost: float) -> None:
    clock, jitter = ScanClock(), random.Random(3)
    ages = []
    for number in range(2000):
        stood_still = lost if number >= 800 else 0.0
        now = 0.025 * number + jitter.uniform(0.0, 0.03) + stood_still
        ages.append(now - clock.taken_at(25 * number, now))
    assert max(ages[:800]) < 0.05 and ages[801] > 0.9 * lost
    assert max(ages[800 + 400 :]) < 0.05, "found within ten seconds"


def test_a_backlog_that_shrinks_is_no_lost_time() -> None:
    clock = ScanClock()
    clock.taken_at(0, 0.0)
    for number in range(1, 800):
        backlog = 0.005 * (800 - number)
        received = 0.025 * number + backlog
        assert received - clock.taken_at(25 * number, received) > backlog - 0.02


def test_a_clock_that_is_set_back_begins_anew() -> None:
    clock = ScanClock()
    assert clock.taken_at(500_000, 10.0) == 10.0
    assert clock.taken_at(25, 10.1) == 10.1
