"""When the times of a rule come, by the local clock: once a day, also where the clock changes."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import date, datetime, time, timedelta, tzinfo

from housefly.tasks.rules.rule import WEEKDAYS, TimePattern

_REACH = 8
"""A rule with at least one weekday has a time within so many days."""


def last_slot(pattern: TimePattern, now: float, zone: tzinfo | None) -> float | None:
    """Return the latest time of a rule that is not after now [Unix time, s]."""
    at = now // pattern.every * pattern.every if pattern.every else now
    if pattern.every and _is_on(pattern, at, zone):
        return at
    today = datetime.fromtimestamp(now, zone).date()
    for back in range(_REACH + 1):
        times = [at for at in _slots_of(pattern, today - timedelta(days=back), zone) if at <= now]
        if times:
            return max(times)
    return None


def next_slot(pattern: TimePattern, after: float, zone: tzinfo | None) -> float | None:
    """Return the first time of a rule after a time [Unix time, s]."""
    at = (after // pattern.every + 1.0) * pattern.every if pattern.every else after
    if pattern.every and at > after and _is_on(pattern, at, zone):
        return at
    today = datetime.fromtimestamp(after, zone).date()
    # A time that the change of the clock moves may belong to the day before.
    for ahead in range(-1, _REACH + 1):
        times = [at for at in _slots_of(pattern, today + timedelta(days=ahead), zone) if at > after]
        if times:
            return min(times)
    return None


def _is_on(pattern: TimePattern, at: float, zone: tzinfo | None) -> bool:
    return WEEKDAYS[datetime.fromtimestamp(at, zone).weekday()] in pattern.days


def local_time(at: float, zone: tzinfo | None) -> time:
    """Return the local time of day of a time [Unix time, s]."""
    return datetime.fromtimestamp(at, zone).time()


def _slots_of(pattern: TimePattern, day: date, zone: tzinfo | None) -> Iterator[float]:
    """Yield the times of one local day [Unix time, s].

    A time that the day skips counts as that long after the gap; one that comes twice, once.
    """
    if WEEKDAYS[day.weekday()] not in pattern.days:
        return
    for at in pattern.at:
        yield datetime.combine(day, at, zone).timestamp()
    if pattern.every:
        begin = datetime.combine(day, time(), zone).timestamp()
        end = datetime.combine(day + timedelta(days=1), time(), zone).timestamp()
        slot = -(-begin // pattern.every) * pattern.every
        while slot < end:
            yield slot
            slot += pattern.every
