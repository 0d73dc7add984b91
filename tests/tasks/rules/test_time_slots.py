from __future__ import annotations

from datetime import UTC, datetime
from zoneinfo import ZoneInfo

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rule_bench import make_rule

from housefly.tasks.rules.rule import TimePattern
from housefly.tasks.rules.time_slots import last_slot, next_slot

BERLIN = ZoneInfo("Europe/Berlin")
ZONES = st.sampled_from(
    [BERLIN, UTC, ZoneInfo("Asia/Tokyo"), ZoneInfo("Australia/Lord_Howe"), ZoneInfo("Asia/Kolkata")]
)
TIMES = st.floats(0.0, 4e9)
PATTERNS = st.sampled_from(
    [
        "{at: 02:30}",
        "{at: 00:00}",
        "{at: 23:59, days: [sun]}",
        "{at: [07:00, 19:30], days: [mon, fri]}",
        "{every: 90 min}",
        "{every: 1 d, days: [wed]}",
        "{every: 7 h}",
    ]
)


def pattern(text: str) -> TimePattern:
    found = make_rule(when=text).when
    assert isinstance(found, TimePattern)
    return found


def unix(text: str, zone: ZoneInfo = BERLIN) -> float:
    return datetime.fromisoformat(text).replace(tzinfo=zone).timestamp()


@given(PATTERNS, TIMES, ZONES)
def test_the_last_time_and_the_next_enclose_now(text: str, now: float, zone: ZoneInfo) -> None:
    times = pattern(text)
    last, coming = last_slot(times, now, zone), next_slot(times, now, zone)
    assert last is not None and coming is not None
    assert last <= now < coming
    assert last_slot(times, coming, zone) == coming
    assert next_slot(times, last, zone) == coming


@pytest.mark.parametrize(
    ("day", "comes_at"),
    [
        ("2026-03-28", "2026-03-28T01:30:00+00:00"),
        ("2026-03-29", "2026-03-29T01:30:00+00:00"),  # 02:30 is skipped: 03:30 summer time
        ("2026-10-24", "2026-10-24T00:30:00+00:00"),
        ("2026-10-25", "2026-10-25T00:30:00+00:00"),  # 02:30 comes twice: the first
        ("2026-10-26", "2026-10-26T01:30:00+00:00"),
    ],
)
def test_where_the_clock_changes_a_time_comes_once(day: str, comes_at: str) -> None:
    times, begin = pattern("{at: 02:30}"), unix(f"{day}T00:00:00")
    found, at = [], begin
    while (at := next_slot(times, at, BERLIN) or 0.0) < begin + 22 * 3600.0:
        found.append(at)
    assert found == [datetime.fromisoformat(comes_at).timestamp()]


def test_weekdays_are_those_of_the_local_day() -> None:
    times = pattern("{at: 00:10, days: [mon]}")
    coming = next_slot(times, unix("2026-11-20T12:00:00"), BERLIN)
    assert coming == unix("2026-11-23T00:10:00")
    assert datetime.fromtimestamp(coming or 0.0, UTC).strftime("%a") == "Sun"
