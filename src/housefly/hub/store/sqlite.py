"""SQLite: one file beside the site, written by one process and read by many.

The file is in write-ahead mode with ``synchronous = FULL``: every commit waits until the log is on
the disk (fsync), so ``kill -9`` of the writer and a power cut alike lose only what was not
committed. Neither damages the file.
"""

from __future__ import annotations

import glob
import os
import sqlite3
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from itertools import chain
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from housefly.errors import StoreError
from housefly.hub.store.database import Dialect, Row
from housefly.hub.store.store import RejectedRowError

_LOCK_TIMEOUT = 1.0
"""How long to wait for another writing process [s]; the writer retries later."""
_PRIMARY_CODE = 0xFF
"""Mask of the primary result code; the rest is detail."""
_REASONS: dict[int, str] = {
    sqlite3.SQLITE_FULL: "disk is full",
    sqlite3.SQLITE_BUSY: "another process holds the database",
    sqlite3.SQLITE_LOCKED: "another process holds the database",
    sqlite3.SQLITE_READONLY: "the database may only be read",
    sqlite3.SQLITE_IOERR: "disk refuses (input/output error)",
    sqlite3.SQLITE_CANTOPEN: "the database file cannot be opened",
}
_DAMAGED = (sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_NOTADB)
_REJECTED = (
    sqlite3.IntegrityError,
    sqlite3.InterfaceError,
    sqlite3.DataError,
    UnicodeError,
    OverflowError,
)
_COMPANIONS = ("", "-wal", "-shm")


class SqliteDatabase:
    """A connection to a file; a damaged file is moved aside, never deleted, and a new one begun."""

    dialect = Dialect(clustered=" WITHOUT ROWID", floor="CAST({} AS INTEGER)", lock_schema="")

    def __init__(self, path: Path) -> None:
        """Open or create a file; raises StoreError if that is impossible."""
        self.path = path
        self.notices: tuple[str, ...] = ()
        try:
            self._open()
        except StoreError:
            if path.exists():  # another problem than damage
                raise
            self._open()
        self.notices = self.notices or self._damaged_before()

    def query(self, sql: str, values: Sequence[object] = ()) -> Iterable[Row]:
        """Run one statement and return its rows."""
        with self._telling():
            return self._connection.execute(sql, values).fetchall()

    def numbers(self, sql: str, values: Sequence[object], columns: int) -> NDArray[np.float64]:
        """Run one statement with numeric columns and return its rows, shape (n, columns)."""
        with self._telling():
            found = chain.from_iterable(self._connection.execute(sql, values))
            return np.fromiter(found, dtype=np.float64).reshape(-1, columns)

    def many(self, sql: str, rows: Sequence[Row]) -> None:
        """Run one statement for each row of values."""
        with self._telling():
            self._connection.executemany(sql, rows)

    @contextmanager
    def transaction(self) -> Iterator[None]:
        """Keep all statements of the block or none; waits a second for another writer."""
        self.query("BEGIN IMMEDIATE")
        try:
            yield
            self.query("COMMIT")
        except BaseException:
            self._roll_back()
            raise

    def scrub(self) -> None:
        """Write the file anew, without the remains of deleted rows."""
        for statement in ("VACUUM", "PRAGMA wal_checkpoint(TRUNCATE)"):
            self.query(statement)

    def close(self) -> None:
        """Close the file."""
        self._connection.close()

    def _open(self) -> None:
        with suppress(OSError):  # sqlite says in words what is wrong
            # It knows who was where; its companions take its mode.
            os.close(os.open(self.path, os.O_RDWR | os.O_CREAT, 0o600))
        with self._telling():
            self._connection = sqlite3.connect(
                self.path,
                timeout=_LOCK_TIMEOUT,
                isolation_level=None,
                check_same_thread=False,
                cached_statements=64,
            )
            self._connection.execute("PRAGMA journal_mode = WAL")
            self._connection.execute("PRAGMA synchronous = FULL")
            self._connection.execute("SELECT count(*) FROM sqlite_schema")

    def _roll_back(self) -> None:
        try:
            if self._connection.in_transaction:  # a full disk ends a transaction by itself
                self._connection.execute("ROLLBACK")
        except sqlite3.Error:
            self._connection.close()  # the next use says so; what was not committed is not there

    @contextmanager
    def _telling(self) -> Iterator[None]:
        try:
            yield
        except sqlite3.ProgrammingError as error:  # used after it was closed
            raise StoreError(str(error)) from error
        except _REJECTED as error:
            raise RejectedRowError(f"the database cannot hold it ({error})") from error
        except sqlite3.Error as error:
            code = getattr(error, "sqlite_errorcode", 0) & _PRIMARY_CODE
            if code in _DAMAGED:
                raise StoreError(self._moved_aside()) from error
            raise StoreError(_REASONS.get(code, str(error)), f"database {self.path}") from error

    def _damaged_before(self) -> tuple[str, ...]:
        """Return a notice of the newest damaged file beside this one, if there is any."""
        with suppress(OSError):
            kept = sorted(self.path.parent.glob(f"{glob.escape(self.path.name)}.damaged-*[0-9]"))
            if kept:
                return (
                    f"{self.path} was damaged before: {kept[-1].name} has what was in it; delete"
                    " that file when it is no longer needed",
                )
        return ()

    def _moved_aside(self) -> str:
        """Move the file and its companions aside; return a message."""
        self._connection.close()
        moment = f"{time.strftime('%Y%m%d-%H%M%S')}-{time.monotonic_ns() % 10**6:06d}"
        kept = self.path.with_name(f"{self.path.name}.damaged-{moment}")
        for ending in _COMPANIONS:
            file = self.path.with_name(self.path.name + ending)
            if file.exists():
                file.rename(kept.with_name(kept.name + ending))
        self.notices = (
            *self.notices,
            f"{self.path} was damaged: it is kept as {kept.name}, a new one was begun",
        )
        return f"database file is damaged, it is kept as {kept.name}"
