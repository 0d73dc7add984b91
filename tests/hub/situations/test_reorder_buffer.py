"""Order of time out of disorder."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.reorder_buffer import LATE_EVENT, MAX_AHEAD, MAX_WAITING, ReorderBuffer
from housefly.messages import Observation, RoomEvent

NOW = 1_800_000_000.0
TIMES = st.lists(st.integers(0, 40).map(lambda n: NOW + n / 10), max_size=30)


def state(at: float, source: str = "floor") -> Observation:
    return Observation("ann", source, at, at, (1.0, 1.0, 0.0))


def bell(at: float) -> RoomEvent:
    return RoomEvent("bell pressed", "bell", at, "bell")


@given(TIMES, st.randoms())
def test_whatever_the_order_of_arrival_the_order_of_release_is_one(
    times: list[float], chance: random.Random
) -> None:
    items = [item for at in times for item in (state(at), state(at, "laser"), bell(at))]
    shuffled = chance.sample(items, len(items))
    released = []
    for rows in (items, shuffled):
        stream = ReorderBuffer()
        for item in rows:
            stream.add(item, NOW - 1.0, NOW + 4.0)
        released.append([item for n in range(9) for item in stream.until(NOW + n / 2)])
    assert released[0] == released[1]
    assert len(released[0]) == len(set(released[0])) == len(set(items))


def test_a_report_comes_before_the_state_of_the_same_time() -> None:
    stream = ReorderBuffer()
    cabinet = state(NOW, "a-cabinet")
    stream.add(cabinet, NOW - 1.0, NOW)
    stream.add(bell(NOW), NOW - 1.0, NOW)
    assert stream.until(NOW) == (bell(NOW), cabinet)


def test_an_item_heard_twice_is_one_however_late_the_second_comes() -> None:
    stream = ReorderBuffer()
    stream.add(state(NOW), NOW - 1.0, NOW)
    stream.add(replace(state(NOW), received_at=NOW + 0.1), NOW - 1.0, NOW)
    stream.add(bell(NOW), NOW - 1.0, NOW)
    assert len(stream.until(NOW)) == 2
    stream.add(bell(NOW), NOW, NOW + 3.0)
    assert stream.until(NOW + 9.0) == ()
    assert stream.counts == {("doubled", "floor"): 1, ("doubled", "bell"): 1}


def test_a_bell_that_is_heard_late_rings_once_and_says_how_late() -> None:
    stream = ReorderBuffer()
    stream.until(NOW)
    for _ in range(2):
        stream.add(bell(NOW - 5.0), NOW, NOW + 0.5)
    (rung,) = stream.until(NOW + 1.0)
    assert (
        isinstance(rung, RoomEvent)
        and NOW < rung.at < NOW + 0.001
        and dict(rung.facts)["late"] == 5.5
    )


@pytest.mark.parametrize(
    ("item", "reason"),
    [
        (state(NOW - 0.1), "late"),
        (bell(NOW - LATE_EVENT - 1.0), "late"),
        (state(NOW + MAX_AHEAD + 0.6), "from the future"),
        (state(float("nan")), "not a number"),
        (replace(state(NOW + 0.1), position=(float("inf"), 0.0, 0.0)), "not a number"),
    ],
)
def test_what_cannot_be_used_is_counted_by_reason_and_source(
    item: Observation | RoomEvent, reason: str
) -> None:
    stream = ReorderBuffer()
    stream.add(item, NOW, NOW + 0.5)
    assert stream.until(NOW + 100.0) == () and stream.counts == {(reason, item.source): 1}


def test_a_flood_does_not_fill_the_memory() -> None:
    stream = ReorderBuffer()
    for n in range(MAX_WAITING + 5):
        stream.add(bell(NOW + n * 1e-5), NOW - 1.0, NOW)
    assert (
        stream.counts == {("too many", "bell"): 5} and len(stream.until(NOW + 9.0)) == MAX_WAITING
    )
