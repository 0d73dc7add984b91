"""PostgreSQL, for a room that outgrows one machine.

A commit waits for the server's disk (``synchronous_commit``, the server's default), which ten
batches a second can afford: what is committed survives a crash of the server, too.
"""

from __future__ import annotations

import os
import socket
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing, contextmanager
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from housefly.errors import MissingPartError, SharedStoreError, StoreError
from housefly.hub.store.database import Dialect, Row
from housefly.hub.store.store import RejectedRowError

try:
    import psycopg
except ImportError as error:
    raise MissingPartError("psycopg (PostgreSQL)", "pip install 'housefly[postgres]'") from error

_SETTINGS = "-c lock_timeout=1000"
_CONNECT_TIMEOUT = 3
_RELEASE_TIME = 1.0
"""A server lets go of what a killed process held within this [s]."""
_REASONS: dict[str, str] = {
    "53100": "disk is full",
    "55P03": "another process holds the database",
    "40P01": "another process holds the database",
    "40001": "another process holds the database",
    "25006": "the database may only be read",
    "42501": "the database refuses this user",
    "3D000": "there is no such database",
    "53300": "the database server has too many connections",
}
_LOST = "the database server does not answer"
_REFUSED = "the database server refuses"
_SCHEMA_LOCK = 7_220_110
"""Number of the advisory lock under which the version table is created."""
_RUN_LOCK = 7_220_111
"""Number of the advisory lock that a run holds on its database."""
_HOLDER = """
SELECT a.application_name FROM pg_locks l JOIN pg_stat_activity a USING (pid)
WHERE l.locktype = 'advisory' AND l.granted AND l.classid = 0 AND l.objid = %s
AND l.database = (SELECT oid FROM pg_database WHERE datname = current_database())
"""


class PostgresDatabase:
    """A connection to a server."""

    dialect = Dialect(
        clustered="", floor="floor({})", lock_schema="LOCK TABLE schema IN EXCLUSIVE MODE"
    )
    notices: tuple[str, ...] = ()

    def __init__(self, url: str) -> None:
        """Connect; raises StoreError if the server does not answer or refuses."""
        with _telling():
            self._connection = psycopg.connect(
                url, autocommit=True, connect_timeout=_CONNECT_TIMEOUT, options=_SETTINGS
            )
            self._connection.execute("SELECT pg_advisory_lock(%s)", (_SCHEMA_LOCK,))
            self._connection.execute(
                "CREATE TABLE IF NOT EXISTS schema (version INTEGER PRIMARY KEY)"
            )
            self._connection.execute("SELECT pg_advisory_unlock(%s)", (_SCHEMA_LOCK,))

    def query(self, sql: str, values: Sequence[object] = ()) -> Iterable[Row]:
        """Run one statement and return its rows."""
        with _telling():
            cursor = self._connection.execute(_placed(sql), values or None)
            return cursor.fetchall() if cursor.description else ()

    def numbers(self, sql: str, values: Sequence[object], columns: int) -> NDArray[np.float64]:
        """Run one statement with numeric columns and return its rows, shape (n, columns)."""
        return np.fromiter(chain.from_iterable(self.query(sql, values)), dtype=np.float64).reshape(
            -1, columns
        )

    def many(self, sql: str, rows: Sequence[Row]) -> None:
        """Run one statement for each row of values."""
        with _telling(), self._connection.cursor() as cursor:
            if rows:
                cursor.executemany(_placed(sql), rows)

    @contextmanager
    def transaction(self) -> Iterator[None]:
        """Keep all statements of the block or none."""
        with _telling(), self._connection.transaction():
            yield

    def scrub(self) -> None:
        """Do nothing: the server gives the room of deleted rows to others by itself."""

    def close(self) -> None:
        """Close the connection."""
        self._connection.close()


@contextmanager
def locked_database(url: str, remedy: str) -> Iterator[None]:
    """Hold a database for this process alone; the server frees it with the connection.

    Raises:
        StoreError: another run holds it, or the server does not answer or refuses.
    """
    me = f"process {os.getpid()} on {socket.gethostname()}"
    with _telling():
        connection = psycopg.connect(
            url,
            autocommit=True,
            connect_timeout=_CONNECT_TIMEOUT,
            options=_SETTINGS,
            application_name=f"housefly, {me}"[:63],
        )
    with closing(connection):
        with _telling():
            is_mine = _lock_of_run(connection)
            holder = None if is_mine else connection.execute(_HOLDER, (_RUN_LOCK,)).fetchone()
        if not is_mine:
            who = (holder and holder[0]) or "who is unknown"
            raise SharedStoreError(
                f"another run uses this room's memory ({who}, database {connection.info.dbname})",
                f"end that run, or {remedy}",
            )
        yield


def _lock_of_run(connection: psycopg.Connection[Row]) -> bool:
    """Take the lock of a run; a run that was killed a moment ago may still seem to hold it."""
    give_up_at = time.monotonic() + _RELEASE_TIME
    while True:
        found = connection.execute("SELECT pg_try_advisory_lock(%s)", (_RUN_LOCK,)).fetchone()
        if found is not None and found[0]:
            return True
        if time.monotonic() > give_up_at:
            return False
        time.sleep(_RELEASE_TIME / 20)


def _placed(sql: str) -> bytes:
    return sql.replace("?", "%s").encode()


@contextmanager
def _telling() -> Iterator[None]:
    try:
        yield
    except (
        psycopg.DataError,
        psycopg.IntegrityError,
        psycopg.ProgrammingError,
        UnicodeError,
    ) as error:
        reason = _REASONS.get(error.sqlstate or "") if isinstance(error, psycopg.Error) else None
        if reason:
            raise StoreError(reason) from error
        raise RejectedRowError(f"the database cannot hold it ({_first_line(error)})") from error
    except psycopg.Error as error:
        if error.sqlstate:
            raise StoreError(_REASONS.get(error.sqlstate, _first_line(error))) from error
        raise StoreError(
            _REFUSED if "FATAL" in str(error) else _LOST, _first_line(error)
        ) from error


def _first_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0]
