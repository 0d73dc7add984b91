"""The tables, as numbered steps from nothing to now.

A step that was released is never edited: a change is a new step at the end.
"""

from __future__ import annotations

from collections.abc import Sequence

from housefly.errors import StoreError
from housefly.hub.store.database import Database, Dialect

Steps = Sequence[tuple[str, ...]]

POSE = "x {real}, y {real}, z {real}, qw {real}, qx {real}, qy {real}, qz {real}"
SAMPLE = (
    f"received_at {{real}} NOT NULL, {POSE}, covariance TEXT NOT NULL, inside TEXT NOT NULL, facts"
    " TEXT NOT NULL"
)
STEPS: Steps = (
    (
        (
            "CREATE TABLE thing (id TEXT PRIMARY KEY, name TEXT NOT NULL, kind TEXT NOT NULL,"
            f" {POSE}, inside TEXT NOT NULL, facts TEXT NOT NULL)"
        ),
        (
            "CREATE TABLE alias (thing TEXT NOT NULL, number INTEGER NOT NULL, alias TEXT NOT NULL,"
            " PRIMARY KEY (thing, number))"
        ),
        (
            "CREATE TABLE sighting (thing TEXT NOT NULL, source TEXT NOT NULL, captured_at"
            f" {{real}} NOT NULL, until {{real}} NOT NULL, valid SMALLINT NOT NULL, {SAMPLE},"
            " PRIMARY KEY (thing, source, captured_at)){clustered}"
        ),
        (
            "CREATE TABLE latest (thing TEXT NOT NULL, source TEXT NOT NULL, valid SMALLINT NOT"
            f" NULL, captured_at {{real}} NOT NULL, {SAMPLE}, PRIMARY KEY (thing, source,"
            " valid)){clustered}"
        ),
        (
            "CREATE TABLE event (at {real} NOT NULL, kind TEXT NOT NULL, thing TEXT NOT NULL,"
            " source TEXT NOT NULL, cause TEXT NOT NULL, confidence {real} NOT NULL, facts TEXT NOT"
            " NULL, PRIMARY KEY (at, kind, thing, source, cause)){clustered}"
        ),
        "CREATE INDEX event_of_thing ON event (thing, at)",
        "CREATE INDEX event_of_kind ON event (kind, at)",
        "CREATE INDEX event_by_cause ON event (cause, at)",
    ),
    (
        (
            "CREATE TABLE viewpoint (thing TEXT NOT NULL, number INTEGER NOT NULL, name TEXT NOT"
            " NULL, robot TEXT NOT NULL, x {real} NOT NULL, y {real} NOT NULL, z {real} NOT NULL,"
            " yaw {real} NOT NULL, pitch {real} NOT NULL, PRIMARY KEY (thing, number))"
        ),
    ),
    (
        (
            "CREATE TABLE tidied (thing TEXT NOT NULL, source TEXT NOT NULL, done_to {real} NOT"
            " NULL, PRIMARY KEY (thing, source)){clustered}"
        ),
    ),
)
"""Step 1: things, samples, events. Step 2: viewpoints. Step 3: how far old samples are thinned."""


def migrate(database: Database, steps: Steps = STEPS) -> None:
    """Bring an older or empty database up to date, whole or not at all.

    Raises:
        StoreError: a newer version of the program made it.
    """
    if version_of(database) == len(steps):
        return
    with database.transaction():
        if database.dialect.lock_schema:
            database.query(database.dialect.lock_schema)
        version = version_of(database)  # another process may have been faster
        if version > len(steps):
            raise StoreError(
                f"the database is of version {version}, this program knows versions up to"
                f" {len(steps)}",
                "install the newer Housefly, or choose another database",
            )
        for number, step in enumerate(steps[version:], version + 1):
            for statement in step:
                database.query(_in(database.dialect, statement))
            database.query("INSERT INTO schema (version) VALUES (?)", (number,))


def version_of(database: Database) -> int:
    """Return how many steps a database has taken; 0 for an empty one."""
    database.query("CREATE TABLE IF NOT EXISTS schema (version INTEGER PRIMARY KEY)")
    return int(next(iter(database.query("SELECT coalesce(max(version), 0) FROM schema")))[0])


def _in(dialect: Dialect, statement: str) -> str:
    return statement.format(real="DOUBLE PRECISION", clustered=dialect.clustered)
