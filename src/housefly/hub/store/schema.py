"""The tables, as numbered migrations.

A released migration is never edited: a change is a new one at the end.
"""

from __future__ import annotations

from collections.abc import Sequence

from housefly.errors import StoreError
from housefly.hub.store.database import Database, Dialect

Migrations = Sequence[tuple[str, ...]]

_POSE = "x {real}, y {real}, z {real}, qw {real}, qx {real}, qy {real}, qz {real}"
_SAMPLE = (
    f"received_at {{real}} NOT NULL, {_POSE}, covariance TEXT NOT NULL, inside TEXT NOT NULL, facts"
    " TEXT NOT NULL"
)
MIGRATIONS: Migrations = (
    (
        (
            "CREATE TABLE thing (id TEXT PRIMARY KEY, name TEXT NOT NULL, kind TEXT NOT NULL,"
            f" {_POSE}, inside TEXT NOT NULL, facts TEXT NOT NULL)"
        ),
        (
            "CREATE TABLE alias (thing TEXT NOT NULL, number INTEGER NOT NULL, alias TEXT NOT NULL,"
            " PRIMARY KEY (thing, number))"
        ),
        (
            "CREATE TABLE sighting (thing TEXT NOT NULL, source TEXT NOT NULL, captured_at"
            f" {{real}} NOT NULL, until {{real}} NOT NULL, valid SMALLINT NOT NULL, {_SAMPLE},"
            " PRIMARY KEY (thing, source, captured_at)){clustered}"
        ),
        (
            "CREATE TABLE latest (thing TEXT NOT NULL, source TEXT NOT NULL, valid SMALLINT NOT"
            f" NULL, captured_at {{real}} NOT NULL, {_SAMPLE}, PRIMARY KEY (thing, source,"
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


def migrate(database: Database, steps: Migrations = MIGRATIONS) -> None:
    """Migrate an older or empty database, completely or not at all.

    Raises:
        StoreError: a newer version made it.
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
    """Return how many migrations a database has had; 0 for an empty one."""
    database.query("CREATE TABLE IF NOT EXISTS schema (version INTEGER PRIMARY KEY)")
    return int(next(iter(database.query("SELECT coalesce(max(version), 0) FROM schema")))[0])


def _in(dialect: Dialect, statement: str) -> str:
    return statement.format(real="DOUBLE PRECISION", clustered=dialect.clustered)
