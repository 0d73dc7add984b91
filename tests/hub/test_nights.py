"""How often somebody was up at night, by what was kept of bed and person."""

from __future__ import annotations

from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.nights import SHORTEST_TIME_UP, NightWindow, night_of, stays_of
from housefly.hub.situations.hysteresis import NOT_KNOWN, UNKNOWN
from housefly.messages import RoomEvent

EVENING = datetime(2026, 11, 20, 22, 0).timestamp()
HOUR, MINUTE = 3600.0, 60.0
WINDOW = (EVENING, EVENING + 8 * HOUR)
MORNING = WINDOW[1] + 2 * HOUR


def begin(at: float, thing: str = "bed", kind: str = "bed occupied", on: str = "") -> RoomEvent:
    facts = (("on", on),) if on else ()
    return RoomEvent(kind, thing, EVENING + at, "situations/beds", facts=facts)


def end(
    at: float, thing: str = "bed", kind: str = "bed occupied", because: str = "load 0 kg"
) -> RoomEvent:
    facts = (("because", because), *((UNKNOWN,) if because == NOT_KNOWN else ()))
    return RoomEvent(kind + " ended", thing, EVENING + at, "situations/beds", facts=facts)


def night(*events: RoomEvent, thing: str = "bed"):  # type: ignore[no-untyped-def]
    return night_of(thing, WINDOW, stays_of(thing, events, MORNING), MORNING)


def test_who_left_twice_and_came_back_was_up_twice_and_rising_is_none() -> None:
    found = night(
        begin(HOUR), end(3 * HOUR), begin(3 * HOUR + 6 * MINUTE), end(5 * HOUR),
        begin(5 * HOUR + 3 * MINUTE), end(7.5 * HOUR),
    )  # fmt: skip
    assert [(up.left - EVENING, (up.back or 0.0) - up.left) for up in found.times_up] == [
        (3 * HOUR, 6 * MINUTE),
        (5 * HOUR, 3 * MINUTE),
    ]
    assert found.rose == EVENING + 7.5 * HOUR
    assert found.in_bed == pytest.approx(6.5 * HOUR - 9 * MINUTE)
    assert found.words == (
        "2026-11-20 22:00 to 06:00: up 2 times (01:00 for 6 min, 03:00 for 3 min),"
        " in bed for 6 h, rose at 05:30"
    )


def test_a_bed_that_fell_silent_is_not_known_and_nobody_was_up() -> None:
    found = night(begin(HOUR), end(3 * HOUR, because=NOT_KNOWN), begin(4 * HOUR), end(9 * HOUR))
    assert (found.times_up, found.unknown, found.rose) == ((), HOUR, None)
    assert "up 0 times" in found.words and "not known for 60 min" in found.words


def test_a_memory_that_was_started_anew_does_not_know_either() -> None:
    started = RoomEvent("memory started", "hub", EVENING + 3 * HOUR, "hub")
    found = night(begin(HOUR), started, begin(3.5 * HOUR), end(9 * HOUR))
    assert (found.times_up, found.unknown) == ((), HOUR / 2)


def test_who_turns_over_or_sits_up_was_not_up() -> None:
    found = night(
        begin(HOUR, "ann", "person lying", "bed"),
        end(3 * HOUR, "ann", "person lying"),
        begin(3 * HOUR, "ann", "person sitting", "bed"),
        end(3 * HOUR + MINUTE, "ann", "person sitting"),
        begin(3 * HOUR + MINUTE + 20.0, "ann", "person lying", "bed"),
        thing="ann",
    )
    assert found.times_up == ()


@pytest.mark.parametrize("on", ["floor", "sofa seat 1"])
def test_who_lies_on_sofa_or_floor_is_not_in_bed(on: str) -> None:
    found = night(begin(HOUR, "ann", "person lying", on), thing="ann")
    assert found.in_bed == 0.0 and "nobody was in bed" in found.words


def test_in_bed_before_the_night_begins_and_after_it_ends() -> None:
    found = night(begin(-HOUR), end(9 * HOUR))
    assert (found.times_up, found.rose, found.in_bed) == ((), None, 8 * HOUR)


@given(st.lists(st.floats(SHORTEST_TIME_UP + 1.0, HOUR), max_size=5))
def test_every_time_up_is_counted_once(breaks: list[float]) -> None:
    events, at = [begin(0.0)], 0.0
    for pause in breaks:
        events += [end(at + 10 * MINUTE), begin(at + 10 * MINUTE + pause)]
        at += 10 * MINUTE + pause
    found = night(*events, end(at + 10 * MINUTE))
    assert len(found.times_up) == len(breaks)
    ups = sum((up.back or up.left) - up.left for up in found.times_up)
    assert ups == pytest.approx(sum(breaks))
    assert found.in_bed + ups == pytest.approx(at + 10 * MINUTE)


def test_nights_begin_in_the_evening_and_end_the_next_morning_or_the_same_day() -> None:
    nights = list(NightWindow(22.0, 6.0).nights(EVENING - HOUR, EVENING + 25 * HOUR))
    assert nights == [WINDOW, (WINDOW[0] + 24 * HOUR, WINDOW[1] + 24 * HOUR)]
    naps = list(NightWindow(13.0, 15.5).nights(EVENING, EVENING + 24 * HOUR))
    assert naps == [(EVENING + 15 * HOUR, EVENING + 17.5 * HOUR)]
    assert list(NightWindow().nights(EVENING + 1.0, EVENING + 2.0)) == []
