"""Opens a store by its address: a file path or ``postgresql://user@host/database``."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from housefly.config.site import Site
from housefly.config.state import database_file
from housefly.errors import StoreError
from housefly.hub.store.database import Database
from housefly.hub.store.foreign import refuse_foreign_file
from housefly.hub.store.sql_store import SqlStore
from housefly.hub.store.sqlite import SqliteDatabase
from housefly.hub.store.store import DEFAULT_KEEP_DAYS

SERVER_SCHEMES = ("postgresql://", "postgres://")


def open_store(
    address: str | Path, *, keep_days: float = DEFAULT_KEEP_DAYS, keep_events_days: float = 0.0
) -> SqlStore:
    """Open a store, create it if missing, migrate an older one.

    Args:
        address: the path of an SQLite file, or the URL of a PostgreSQL database.
        keep_days: how long samples are kept [days].
        keep_events_days: how long events are kept [days]; 0 keeps them for good.

    Raises:
        StoreError: it cannot be opened, it is another program's, or a newer version made it.
        MissingPartError: PostgreSQL is asked for and its driver is not installed.
    """
    if not str(address).startswith(SERVER_SCHEMES):
        refuse_foreign_file(Path(address))
    kept = partial(SqlStore, keep_days=keep_days, keep_events_days=keep_events_days)
    try:
        return kept(_database(address))
    except StoreError:
        if str(address).startswith(SERVER_SCHEMES) or Path(address).exists():
            raise
        return kept(_database(address))  # the damaged one is kept aside


def open_site_store(site: Site) -> SqlStore:
    """Open the store of a site; raises as ``open_store`` does."""
    hub = site.hub
    return open_store(
        store_address(site), keep_days=hub.keep_days, keep_events_days=hub.keep_events_days
    )


def store_address(site: Site) -> str:
    """Return the address of a site's store: its setting, or a file in the user's state folder.

    The folder is created.
    """
    if site.hub.store.startswith(SERVER_SCHEMES):
        return site.hub.store
    path = database_file(site)
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    return str(path)


def _database(address: str | Path) -> Database:
    if not str(address).startswith(SERVER_SCHEMES):
        return SqliteDatabase(Path(address))
    from housefly.hub.store.postgres import PostgresDatabase  # an optional part

    return PostgresDatabase(str(address))
