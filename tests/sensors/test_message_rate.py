"""Rates, ages and budgets of messages."""

from __future__ import annotations

from math import inf

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.sensors.message_rate import RATE_WINDOW, MessageRate, TokenBucket


@given(st.floats(0.5, 50.0), st.floats(0.0, 1e6))
def test_a_steady_source_has_its_rate(rate: float, start: float) -> None:
    arrivals = MessageRate()
    count = round(RATE_WINDOW * rate) + 2
    for n in range(count):
        arrivals.add(start + n / rate)
    now = start + (count - 1) / rate
    assert arrivals.rate_hz(now) == pytest.approx(rate, rel=0.01)
    assert arrivals.age(now + 3.0) == pytest.approx(3.0, abs=1e-6)


def test_who_was_never_heard_has_no_rate_and_is_infinitely_old() -> None:
    assert (MessageRate().rate_hz(5.0), MessageRate().age(5.0)) == (0.0, inf)


def test_who_fell_silent_has_no_rate() -> None:
    rate = MessageRate()
    for n in range(10):
        rate.add(n * 0.1)
    assert rate.rate_hz(100.0) == 0.0


@given(st.floats(0.1, 100.0), st.lists(st.floats(0.0, 0.5), max_size=300))
def test_no_more_passes_than_the_rate_and_one_second_at_once(
    rate: float, gaps: list[float]
) -> None:
    bucket, now, passed = TokenBucket(rate), 0.0, 0
    for gap in gaps:
        now += gap
        passed += bucket.consume(now)
    assert passed <= now * rate + max(1.0, rate) + 1e-6


@given(st.floats(0.5, 100.0), st.integers(1, 200))
def test_who_keeps_to_the_rate_is_never_held_back(rate: float, count: int) -> None:
    bucket = TokenBucket(rate)
    assert all(bucket.consume(n / rate * 1.0001) for n in range(count))


def test_a_clock_that_steps_back_gives_nothing_away() -> None:
    bucket = TokenBucket(1.0)
    assert bucket.consume(100.0)
    assert not bucket.consume(0.0)
    assert not bucket.consume(100.5)
    assert bucket.consume(101.1)
