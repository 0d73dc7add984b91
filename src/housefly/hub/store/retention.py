"""Thins old samples, then deletes them, in small steps so that the writer never waits long."""

from __future__ import annotations

from math import floor

from housefly.hub.store.database import Database
from housefly.hub.store.store import DEFAULT_KEEP_DAYS, FULL_RATE_AGE, THINNED_RATE

DAY = 86_400.0
"""In seconds."""
_MAX_ROWS = 5000
"""At most about this many rows are handled in one step."""
_MIN_BACKLOG = 60.0
"""A source is handled again once this much more of its samples is old [s]."""

_SELECT_DUE = """SELECT l.thing, l.source, coalesce(t.done_to, 0) FROM latest l
    LEFT JOIN tidied t ON t.thing = l.thing AND t.source = l.source
    WHERE coalesce(t.done_to, 0) < ? ORDER BY 3 LIMIT 1"""
_SELECT_NEXT = """SELECT captured_at FROM sighting
    WHERE thing = ? AND source = ? AND captured_at >= ? AND captured_at < ?
    ORDER BY captured_at LIMIT 1 OFFSET ?"""
_DELETE_THINNED = """DELETE FROM sighting
    WHERE thing = ? AND source = ? AND captured_at >= ? AND captured_at < ?
        AND until - captured_at < ?
    AND captured_at NOT IN (SELECT max(captured_at) FROM sighting
        WHERE thing = ? AND source = ? AND captured_at >= ? AND captured_at < ? GROUP BY {})"""
_DELETE_EXPIRED = (
    "DELETE FROM sighting WHERE thing = ? AND source = ? AND captured_at < ? AND until < ?"
)
_UPSERT_DONE = """INSERT INTO tidied (thing, source, done_to) VALUES (?, ?, ?)
    ON CONFLICT (thing, source) DO UPDATE SET done_to = excluded.done_to"""


def prune_step(database: Database, now: float, *, keep_days: float = DEFAULT_KEEP_DAYS) -> bool:
    """Handle the source whose samples have waited longest; return whether there was one."""
    horizon = _aligned(now - FULL_RATE_AGE)
    due = next(iter(database.query(_SELECT_DUE, (horizon - _MIN_BACKLOG,))), None)
    if due is None:
        return False
    thing, source, start = due
    with database.transaction():
        end = _end(database, (thing, source), start, horizon)
        _thin(database, (thing, source), start, end)
        _remove(database, (thing, source), now - keep_days * DAY)
        database.query(_UPSERT_DONE, (thing, source, end))
    return True


def delete_old_events(database: Database, oldest: float) -> None:
    """Delete what happened before a time [Unix time, s]."""
    database.query("DELETE FROM event WHERE at < ?", (oldest,))


def _thin(database: Database, pair: tuple[str, str], start: float, end: float) -> None:
    """Keep the last sample of each bucket: it is where the source left the thing."""
    bucket = database.dialect.floor.format(f"captured_at * {THINNED_RATE}")
    database.query(
        _DELETE_THINNED.format(bucket), (*pair, start, end, 1.0 / THINNED_RATE, *pair, start, end)
    )


def _remove(database: Database, pair: tuple[str, str], oldest: float) -> None:
    end = next(iter(database.query(_SELECT_NEXT, (*pair, 0.0, oldest, _MAX_ROWS))), (oldest,))[0]
    database.query(_DELETE_EXPIRED, (*pair, end, oldest))


def _end(database: Database, pair: tuple[str, str], start: float, horizon: float) -> float:
    beyond = next(iter(database.query(_SELECT_NEXT, (*pair, start, horizon, _MAX_ROWS))), None)
    end = horizon if beyond is None else _aligned(float(beyond[0]))
    return end if end > start else horizon


def _aligned(at: float) -> float:
    """Return the start of a time's bucket, so that no bucket is split."""
    return floor(at * THINNED_RATE) / THINNED_RATE
