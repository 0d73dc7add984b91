"""Old samples are thinned, then removed, a little at a time so that the writer never waits long."""

from __future__ import annotations

from math import floor

from housefly.hub.store.contract import FULL_RATE, KEPT_DAYS, THIN_RATE
from housefly.hub.store.database import Database

DAY = 86_400.0
CHUNK = 5000
"""At most about so many rows are looked at in one step."""
PATIENCE = 60.0
"""A source's samples are looked at again when this much more of them is old [s]."""

DUE = """SELECT l.thing, l.source, coalesce(t.done_to, 0) FROM latest l
    LEFT JOIN tidied t ON t.thing = l.thing AND t.source = l.source
    WHERE coalesce(t.done_to, 0) < ? ORDER BY 3 LIMIT 1"""
NEXT = """SELECT captured_at FROM sighting WHERE thing = ? AND source = ? AND captured_at >= ? AND captured_at < ?
    ORDER BY captured_at LIMIT 1 OFFSET ?"""
THIN = """DELETE FROM sighting WHERE thing = ? AND source = ? AND captured_at >= ? AND captured_at < ? AND until - captured_at < ?
    AND captured_at NOT IN (SELECT max(captured_at) FROM sighting
        WHERE thing = ? AND source = ? AND captured_at >= ? AND captured_at < ? GROUP BY {})"""
REMOVE = "DELETE FROM sighting WHERE thing = ? AND source = ? AND captured_at < ? AND until < ?"
DONE = """INSERT INTO tidied (thing, source, done_to) VALUES (?, ?, ?)
    ON CONFLICT (thing, source) DO UPDATE SET done_to = excluded.done_to"""


def tidy_step(database: Database, now: float, *, keep_days: float = KEPT_DAYS) -> bool:
    """Look at the source whose samples wait longest; tell whether there was one."""
    horizon = _aligned(now - FULL_RATE)
    due = next(iter(database.query(DUE, (horizon - PATIENCE,))), None)
    if due is None:
        return False
    thing, source, start = due
    with database.transaction():
        end = _end(database, (thing, source), start, horizon)
        _thin(database, (thing, source), start, end)
        _remove(database, (thing, source), now - keep_days * DAY)
        database.query(DONE, (thing, source, end))
    return True


def _thin(database: Database, pair: tuple[str, str], start: float, end: float) -> None:
    """Keep the last sample of each bucket: it is what the source left standing."""
    bucket = database.dialect.floor.format(f"captured_at * {THIN_RATE}")
    database.query(THIN.format(bucket), (*pair, start, end, 1.0 / THIN_RATE, *pair, start, end))


def _remove(database: Database, pair: tuple[str, str], oldest: float) -> None:
    end = next(iter(database.query(NEXT, (*pair, 0.0, oldest, CHUNK))), (oldest,))[0]
    database.query(REMOVE, (*pair, end, oldest))


def _end(database: Database, pair: tuple[str, str], start: float, horizon: float) -> float:
    beyond = next(iter(database.query(NEXT, (*pair, start, horizon, CHUNK))), None)
    end = horizon if beyond is None else _aligned(float(beyond[0]))
    return end if end > start else horizon


def _aligned(at: float) -> float:
    """Return the begin of the bucket in which a time lies, so that no bucket is cut in two."""
    return floor(at * THIN_RATE) / THIN_RATE
