"""The time that the slots of an intent mean."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime, timedelta

from housefly.tasks.intents.intent import IntentSlots

AROUND = 1200.0
"""Who asks for three o'clock means from this much before it to this much after it [s]."""
_HALF_DAY = 43200.0
_DAYS = ("monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday")
_PERIODS = {"morning": (5, 12), "afternoon": (12, 18), "evening": (17, 23), "night": (22, 30)}
"""From and to, in hours of the local day; 30 is six o'clock on the next one."""


@dataclass(frozen=True, slots=True)
class TimeSpan:
    """From a time to a time [Unix time, s]."""

    since: float
    until: float


def spans_of(slots: IntentSlots, now: float, otherwise: float) -> tuple[TimeSpan, ...]:
    """Return the spans that may be meant, the likeliest first; all begin in the past.

    Args:
        slots: of an intent.
        now: Unix time [s].
        otherwise: length of the span up to now that is meant when no time was said [s].
    """
    today = _midnight(now)
    if slots.last_minutes is not None:
        return (TimeSpan(max(0.0, now - 60.0 * slots.last_minutes), now),)
    if slots.at is not None:
        return _around(slots, now, today)
    if slots.period is not None:
        return (_period(slots, now, today),)
    if slots.day is not None:
        day = _day(slots.day, today)
        end = now if slots.since else min(now, _later(day, 24))
        return (TimeSpan(day.timestamp(), end),)
    return (TimeSpan(max(0.0, now - otherwise), now),)


def next_time(slots: IntentSlots, now: float) -> float | None:
    """Return the next time that slots mean [Unix time, s], None when they mean none."""
    if slots.in_minutes is not None:
        return now + 60.0 * slots.in_minutes
    if slots.at is None:
        return None
    if slots.day == "tomorrow":
        return _at(slots.at, _midnight(now) + timedelta(days=1))
    at = _at(slots.at, _midnight(now))
    step = _HALF_DAY if slots.either_half else 2 * _HALF_DAY
    while at <= now:
        at += step
    return at


def _around(slots: IntentSlots, now: float, today: datetime) -> tuple[TimeSpan, ...]:
    day = today if slots.day is None else _day(slots.day, today)
    first = _at(slots.at or "00:00", day)
    times = [first, first + _twelve_hours(first)] if slots.either_half else [first]
    if slots.day is None:
        times = [at - 2 * _HALF_DAY if at - AROUND > now else at for at in times]
    past = sorted((at for at in times if at - AROUND <= now), reverse=True) or [min(times)]
    if slots.since:
        return tuple(TimeSpan(min(at, now), now) for at in past)
    return tuple(TimeSpan(min(at - AROUND, now), min(at + AROUND, now)) for at in past)


def _period(slots: IntentSlots, now: float, today: datetime) -> TimeSpan:
    begin, end = _PERIODS[slots.period or "night"]
    day = today if slots.day is None else _day(slots.day, today)
    if slots.period == "night" and slots.day is None:
        day -= timedelta(days=1)
        if _later(day, end) < now and _later(day + timedelta(days=1), begin) <= now:
            day += timedelta(days=1)
    elif slots.day is None and _later(day, begin) > now:
        day -= timedelta(days=1)
    return TimeSpan(min(_later(day, begin), now), min(_later(day, end), now))


def _twelve_hours(at: float) -> float:
    """Return what leads to the other half of the same day: forth before noon, else back [s]."""
    return _HALF_DAY if datetime.fromtimestamp(at).hour < 12 else -_HALF_DAY


def _midnight(now: float) -> datetime:
    return datetime.fromtimestamp(now).replace(hour=0, minute=0, second=0, microsecond=0)


def _later(day: datetime, hours: int) -> float:
    """Return a local hour of a day; more than 24 are on the next one [Unix time, s]."""
    return (day + timedelta(hours=hours)).timestamp()


def _at(clock: str, day: datetime) -> float:
    hour, minute = clock.split(":")
    return day.replace(hour=int(hour), minute=int(minute)).timestamp()


def _day(name: str, today: datetime) -> datetime:
    if name in ("today", "yesterday"):
        return today - timedelta(days=name == "yesterday")
    return today - timedelta(days=(today.weekday() - _DAYS.index(name)) % 7)
