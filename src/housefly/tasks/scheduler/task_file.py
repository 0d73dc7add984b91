"""Opens the file of the queue for one process, and says what to do where that cannot be."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from housefly.errors import StoreError
from housefly.hub.store.schema import migrate
from housefly.hub.store.sqlite import SqliteDatabase

AFTER_DAMAGE = 1_000_000
"""Ids skipped for each damaged file beside this one: nobody knows which it gave away."""
_MIGRATIONS = (
    (
        "CREATE TABLE tasks (id INTEGER PRIMARY KEY, service TEXT NOT NULL, asked_at REAL NOT NULL,"
        " ended_at REAL, status TEXT NOT NULL, scheduled TEXT)",
        "CREATE INDEX tasks_asked_at ON tasks (asked_at)",
        "CREATE INDEX tasks_ended_at ON tasks (ended_at)",
        "CREATE INDEX tasks_open ON tasks (id) WHERE scheduled IS NOT NULL",
        "CREATE TABLE counters (name TEXT PRIMARY KEY, value INTEGER NOT NULL)",
    ),
    ("CREATE TABLE notices (number INTEGER PRIMARY KEY, notice TEXT NOT NULL)",),
)
COUNT_FROM = (
    "INSERT INTO counters (name, value) VALUES ('next_id', ?)"
    " ON CONFLICT (name) DO UPDATE SET value = max(value, excluded.value)"
)
"""Takes the smallest number that no task may have had."""
_REMEDIES = {
    "another process holds the database": "end the other run of this site, then start again",
    "the database may only be read": "make the file and its folder writable for this user",
    "the database file cannot be opened": "make its folder one that this user may enter",
    "disk is full": "make room on the disk",
}


def open_task_file(path: Path) -> tuple[SqliteDatabase, tuple[str, ...]]:
    """Open or create the file; return it and what was wrong with it, in words.

    A damaged file is moved aside and a new one begun.

    Raises:
        StoreError: it cannot be opened, or a newer version made it.
    """
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as error:
        reason = f"the folder {path.parent} cannot be made ({error.strerror})"
        raise StoreError(reason, "give this site another hub.store") from error
    try:
        database = _read_through(path)
    except StoreError as error:
        if path.exists():  # another problem than damage, which was moved aside
            raise
        return _read_through(path), (f"{path}: {error}; a new one was begun",)
    return database, database.notices


def _read_through(path: Path) -> SqliteDatabase:
    """Open the file for this process alone, migrate it, and read all of it once."""
    database = SqliteDatabase(path)
    try:
        database.query("PRAGMA locking_mode = EXCLUSIVE")
        migrate(database, _MIGRATIONS)
        damaged = len(list(path.parent.glob(f"{path.name}.damaged-*[0-9]")))
        with database.transaction():  # the first write takes the file
            database.query(COUNT_FROM, (1 + AFTER_DAMAGE * damaged,))
        database.query("SELECT sum(length(status)), sum(length(scheduled)) FROM tasks")
    except BaseException:
        database.close()
        raise
    return database


@contextmanager
def with_remedy(path: Path) -> Iterator[None]:
    """Let a StoreError say what to do, as far as that is known."""
    try:
        yield
    except StoreError as error:
        remedy = _REMEDIES.get(error.reason)
        if remedy is None:
            raise
        raise StoreError(f"{path}: {error.reason}", remedy) from error
