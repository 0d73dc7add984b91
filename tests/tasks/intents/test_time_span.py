"""Which time people mean."""

from __future__ import annotations

from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.tasks.intents.intent import IntentSlots
from housefly.tasks.intents.time_span import AROUND, next_time, spans_of

DAY = 86400.0


def at(day: int, clock: str) -> float:
    """Return a local time of November 2026; the 18th is a Wednesday."""
    hour, minute = clock.split(":")
    return datetime(2026, 11, day, int(hour), int(minute)).timestamp()


def spans(now: float, **slots: object) -> list[tuple[float, float]]:
    said = IntentSlots(**slots)  # type: ignore[arg-type]
    return [(one.since, one.until) for one in spans_of(said, now, DAY)]


def test_three_o_clock_is_the_last_one_or_the_one_before() -> None:
    now = at(18, "16:00")
    first, second = spans(now, at="03:00", either_half=True)
    assert first == (at(18, "15:00") - AROUND, at(18, "15:00") + AROUND)
    assert second == (at(18, "03:00") - AROUND, at(18, "03:00") + AROUND)
    first, second = spans(at(18, "10:00"), at="03:00", either_half=True)
    assert first[0] == at(18, "03:00") - AROUND
    assert second[0] == at(17, "15:00") - AROUND
    assert spans(now, at="17:00")[0][0] == at(17, "17:00") - AROUND
    assert spans(now, at="03:00", day="yesterday") == [
        (at(17, "03:00") - AROUND, at(17, "03:00") + AROUND)
    ]


def test_both_halves_are_of_the_day_that_was_said() -> None:
    found = spans(at(18, "16:00"), at="12:30", either_half=True, day="yesterday")
    assert [begin + AROUND for begin, _ in found] == [at(17, "12:30"), at(17, "00:30")]


def test_since_goes_up_to_now() -> None:
    now = at(18, "16:00")
    assert spans(now, at="14:00", since=True) == [(at(18, "14:00"), now)]
    assert spans(now, day="monday", since=True) == [(at(16, "00:00"), now)]


@pytest.mark.parametrize(
    ("now", "begin", "end"),
    [
        (at(18, "09:00"), at(17, "22:00"), at(18, "06:00")),
        (at(18, "03:00"), at(17, "22:00"), at(18, "03:00")),
        (at(18, "21:00"), at(17, "22:00"), at(18, "06:00")),
        (at(18, "23:00"), at(18, "22:00"), at(18, "23:00")),
    ],
)
def test_the_night_is_the_last_one_or_the_one_that_goes_on(
    now: float, begin: float, end: float
) -> None:
    assert spans(now, period="night") == [(begin, end)]


def test_parts_of_a_day_and_whole_days() -> None:
    now = at(18, "16:00")
    assert spans(now, period="morning") == [(at(18, "05:00"), at(18, "12:00"))]
    assert spans(now, period="evening") == [(at(17, "17:00"), at(17, "23:00"))]
    assert spans(now, period="evening", day="monday") == [(at(16, "17:00"), at(16, "23:00"))]
    assert spans(now, day="yesterday") == [(at(17, "00:00"), at(18, "00:00"))]
    assert spans(now, day="wednesday") == [(at(18, "00:00"), now)]
    assert spans(now, last_minutes=90.0) == [(now - 5400.0, now)]
    assert spans(now) == [(now - DAY, now)]


def test_a_time_to_be_told_is_in_the_future() -> None:
    now = at(18, "16:00")

    def told(**slots: object) -> float | None:
        return next_time(IntentSlots(**slots), now)  # type: ignore[arg-type]

    assert told(at="03:00", either_half=True) == at(19, "03:00")
    assert told(at="04:30", either_half=True) == at(18, "16:30")
    assert told(at="15:00") == at(19, "15:00")
    assert told(in_minutes=10.0) == now + 600.0
    assert told() is None


@given(
    now=st.floats(1.5e9, 2.0e9),
    clock=st.one_of(st.none(), st.times().map(lambda one: f"{one:%H:%M}")),
    day=st.sampled_from([None, "today", "yesterday", "monday", "sunday"]),
    period=st.sampled_from([None, "morning", "afternoon", "evening", "night"]),
    either=st.sampled_from([None, True]),
    since=st.sampled_from([None, True]),
)
def test_no_span_ends_before_it_begins_or_after_now(
    now: float, clock: str | None, day: str | None, period: str | None,
    either: bool | None, since: bool | None,
) -> None:  # fmt: skip
    said = {"at": clock, "day": day, "period": period, "either_half": either, "since": since}
    for begin, end in spans(now, **said):
        assert begin <= end <= now
