"""Whose channels a controller flies by: ours follow, others do not, also where they lie alike."""

from __future__ import annotations

import pytest

from housefly.drones.betaflight.echo import Echo

OURS = (1500, 1500, 1500, 1000, 1000, 1700)
PERIOD, ASKED = 0.02, 10


def watched(seconds: float, others: dict[int, int], own: frozenset[int]) -> Echo:
    """Return what is known after so long [s], with some channels held by others."""
    echo = Echo(own)
    for step in range(round(seconds / PERIOD)):
        now = step * PERIOD
        sent = echo.moved(OURS, now)
        echo.sent(sent, now)
        if step % ASKED == 0:
            echo.asked(now)
            flown = tuple(others.get(number, one) for number, one in enumerate(sent))
            echo.heard(flown, now + 0.01)
    return echo


def test_channels_that_follow_are_ours() -> None:
    assert watched(2.0, {}, frozenset(range(6))).lacking(2.0) == frozenset()


@pytest.mark.parametrize("channel", range(6))
def test_a_channel_that_lies_still_is_not_ours_even_where_ours_lies(channel: int) -> None:
    echo = watched(2.0, {channel: OURS[channel]}, frozenset(range(6)))
    assert echo.lacking(2.0) == {channel}


def test_a_channel_that_need_not_be_ours_is_not_looked_at() -> None:
    assert watched(2.0, {5: 1300}, frozenset(range(5))).lacking(2.0) == frozenset()


def test_before_enough_was_heard_and_once_it_is_old_nobody_knows() -> None:
    assert watched(1.0, {}, frozenset(range(6))).lacking(1.0) is None
    assert watched(2.0, {}, frozenset(range(6))).lacking(6.0) is None


def test_in_the_air_somebody_else_flies_it_once_no_answer_was_ours() -> None:
    assert not watched(2.0, {}, frozenset(range(6))).is_taken()
    assert watched(2.0, {0: 1700}, frozenset(range(6))).is_taken()
