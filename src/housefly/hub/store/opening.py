"""Opens a store by its address: the path of a file, or ``postgresql://user@host/database``."""

from __future__ import annotations

from pathlib import Path

from housefly.hub.store.contract import KEPT_DAYS
from housefly.hub.store.database import Database
from housefly.hub.store.sql_store import SqlStore
from housefly.hub.store.sqlite import SqliteDatabase

SERVERS = ("postgresql://", "postgres://")


def open_store(address: str | Path, *, keep_days: float = KEPT_DAYS) -> SqlStore:
    """Open a store, make it where there is none, bring an older one up to date.

    Args:
        address: the path of an SQLite file, or the URL of a PostgreSQL database.
        keep_days: how long samples are kept [days].

    Raises:
        StoreError: it cannot be opened, or a newer program made it.
        MissingPartError: PostgreSQL is asked for and its driver is not installed.
    """
    return SqlStore(_database(address), keep_days=keep_days)


def _database(address: str | Path) -> Database:
    if not str(address).startswith(SERVERS):
        return SqliteDatabase(Path(address))
    from housefly.hub.store.postgres import PostgresDatabase  # an optional part

    return PostgresDatabase(str(address))
