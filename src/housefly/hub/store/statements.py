"""The longer SQL statements of the store, with ``?`` for values."""

from __future__ import annotations

from housefly.hub.store.rows import EVENT_COLUMNS, SAMPLE_COLUMNS, THING_COLUMNS


def insert_into(table: str, columns: str, after: str = "") -> str:
    """Return the statement that inserts a row with these columns."""
    return (
        f"INSERT INTO {table} ({columns}) VALUES ({', '.join('?' for _ in columns.split(','))})"
        f" {after}"
    )


def _overwrite(columns: str) -> str:
    return ", ".join(f"{name} = excluded.{name}" for name in columns.replace(" ", "").split(","))


INSERT_SAMPLE = insert_into(
    "sighting",
    f"thing, source, captured_at, until, valid, {SAMPLE_COLUMNS}",
    "ON CONFLICT DO NOTHING",
)
EXTEND_SAMPLE = (
    "UPDATE sighting SET until = ? WHERE thing = ? AND source = ? AND captured_at = ? AND until < ?"
)
UPSERT_LATEST = insert_into(
    "latest",
    f"thing, source, valid, captured_at, {SAMPLE_COLUMNS}",
    "ON CONFLICT (thing, source, valid) DO UPDATE "
    f"SET {_overwrite(f'captured_at, {SAMPLE_COLUMNS}')} "
    "WHERE excluded.captured_at >= latest.captured_at",
)
INSERT_EVENT = insert_into("event", EVENT_COLUMNS, "ON CONFLICT DO NOTHING")
UPSERT_THING = insert_into(
    "thing", THING_COLUMNS, f"ON CONFLICT (id) DO UPDATE SET {_overwrite(THING_COLUMNS)}"
)
SELECT_SEEN = f"""SELECT s.thing, s.source, CASE WHEN s.until < ? THEN s.until ELSE ? END, s.valid,
        {", ".join(f"s.{column}" for column in SAMPLE_COLUMNS.split(", "))}
    FROM latest l CROSS JOIN sighting s
    WHERE l.valid = 1 AND s.thing = l.thing AND s.source = l.source AND s.captured_at = (
        SELECT captured_at FROM sighting
        WHERE thing = l.thing AND source = l.source AND valid = 1 AND captured_at <= ?
        ORDER BY captured_at DESC LIMIT 1)"""
"""CROSS JOIN makes SQLite read ``latest`` first; otherwise it would scan all samples."""
_FROM_PATH = """FROM sighting
    WHERE thing = ? AND source = ? AND captured_at > ? AND captured_at <= ?
        AND valid = 1 AND x IS NOT NULL"""
SELECT_PATH = f"SELECT captured_at, until, x, y, z {_FROM_PATH}"
THINNED_PATH = f" AND captured_at IN (SELECT max(captured_at) {_FROM_PATH} GROUP BY {{}})"
