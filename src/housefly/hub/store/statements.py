"""The longer statements of the store, with ``?`` for values."""

from __future__ import annotations

from housefly.hub.store.rows import EVENT, SAMPLE, THING


def insert(table: str, columns: str, after: str = "") -> str:
    """Return the statement that inserts a row of these columns."""
    return (
        f"INSERT INTO {table} ({columns}) VALUES ({', '.join('?' for _ in columns.split(','))})"
        f" {after}"
    )


def _overwrite(columns: str) -> str:
    return ", ".join(f"{name} = excluded.{name}" for name in columns.replace(" ", "").split(","))


BEGIN = insert(
    "sighting", f"thing, source, captured_at, until, valid, {SAMPLE}", "ON CONFLICT DO NOTHING"
)
STRETCH = (
    "UPDATE sighting SET until = ? WHERE thing = ? AND source = ? AND captured_at = ? AND until < ?"
)
LATEST = insert(
    "latest",
    f"thing, source, valid, captured_at, {SAMPLE}",
    f"ON CONFLICT (thing, source, valid) DO UPDATE SET {_overwrite(f'captured_at, {SAMPLE}')} "
    "WHERE excluded.captured_at >= latest.captured_at",
)
HAPPENED = insert("event", EVENT, "ON CONFLICT DO NOTHING")
KNOWN = insert("thing", THING, f"ON CONFLICT (id) DO UPDATE SET {_overwrite(THING)}")
SEEN = f"""SELECT s.thing, s.source, CASE WHEN s.until < ? THEN s.until ELSE ? END, s.valid,
        {", ".join(f"s.{column}" for column in SAMPLE.split(", "))}
    FROM latest l CROSS JOIN sighting s
    WHERE l.valid = 1 AND s.thing = l.thing AND s.source = l.source AND s.captured_at = (
        SELECT captured_at FROM sighting WHERE thing = l.thing AND source = l.source AND valid = 1 AND captured_at <= ?
        ORDER BY captured_at DESC LIMIT 1)"""
"""CROSS JOIN, because SQLite then asks ``latest`` first; the other way round it would read all
samples there are.
"""
PATH = """SELECT captured_at, until, x, y, z FROM sighting
    WHERE thing = ? AND source = ? AND captured_at > ? AND captured_at <= ? AND valid = 1 AND x IS NOT NULL"""
THINNED = """ AND captured_at IN (SELECT max(captured_at) FROM sighting
    WHERE thing = ? AND source = ? AND captured_at > ? AND captured_at <= ? AND valid = 1 AND x IS NOT NULL GROUP BY {})"""
