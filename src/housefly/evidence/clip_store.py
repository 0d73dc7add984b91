"""The table of clips and snapshots beside their files: SQLite, for this user only."""

from __future__ import annotations

import json
import os
import secrets
import sqlite3
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from housefly.errors import StoreError
from housefly.evidence.clip_clock import BelievedTime
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_writer import CLIP_SUFFIX
from housefly.evidence.snapshots import SNAPSHOT_SUFFIX

_DATABASE = "index.db"
_BUSY_TIMEOUT = 5.0
ADOPTED = "taken up again"
"""What is written down of a clip whose row was lost."""
_SCHEMA = """
CREATE TABLE IF NOT EXISTS clips (
  id TEXT PRIMARY KEY, kind TEXT NOT NULL, task INTEGER NOT NULL, service TEXT NOT NULL,
  place TEXT NOT NULL, thing TEXT NOT NULL, people TEXT NOT NULL, cause TEXT NOT NULL,
  began_at REAL NOT NULL, duration REAL NOT NULL, size INTEGER NOT NULL,
  kept INTEGER NOT NULL, blanked INTEGER NOT NULL, whole INTEGER NOT NULL,
  cut_off INTEGER NOT NULL DEFAULT 0, drone TEXT NOT NULL DEFAULT '');
CREATE INDEX IF NOT EXISTS clips_by_time ON clips (began_at);
CREATE TABLE IF NOT EXISTS views (
  clip TEXT NOT NULL, at REAL NOT NULL, who TEXT NOT NULL, what TEXT NOT NULL);
CREATE INDEX IF NOT EXISTS views_by_clip ON views (clip, at);
CREATE TABLE IF NOT EXISTS clock (
  one INTEGER PRIMARY KEY CHECK (one = 1), believed REAL NOT NULL, doubted REAL);
"""
_ADDED_COLUMNS = {"cut_off": "INTEGER NOT NULL DEFAULT 0", "drone": "TEXT NOT NULL DEFAULT ''"}
"""Columns that an index of an earlier version lacks."""
SUFFIXES = {"clip": CLIP_SUFFIX, "snapshot": SNAPSHOT_SUFFIX}
"""Kinds of evidence and how their files end."""


@dataclass(frozen=True, slots=True)
class ClipRow:
    """One row of the table.

    Attributes:
        id, kind, task, service, place, thing, people, cause: as in ``ClipInfo``.
        began_at, duration: [Unix time, s] and [s].
        size: of the file [bytes].
        kept: whether somebody wants it kept for good.
        blanked: whether part of it was blanked.
        whole: False while it is being written.
        cut_off: whether its end is missing.
        drone: that filmed it.
    """

    id: str
    kind: str
    task: int
    service: str
    place: str
    thing: str
    people: tuple[str, ...]
    cause: str
    began_at: float
    duration: float = 0.0
    size: int = 0
    kept: bool = False
    blanked: bool = False
    whole: bool = False
    cut_off: bool = False
    drone: str = ""

    @property
    def file_name(self) -> str:
        """Name of the whole file in its folder."""
        return self.id + SUFFIXES[self.kind]


def new_clip_row(kind: str, began_at: float, origin: ClipOrigin, drone: str = "") -> ClipRow:
    """Return a row with an id of its own, which begins with the time and tells nothing else."""
    stamp = time.strftime("%Y%m%d-%H%M%S", time.gmtime(began_at))
    return ClipRow(
        id=f"{stamp}-{secrets.token_hex(4)}",
        kind=kind,
        task=origin.task,
        service=origin.service,
        place="",
        thing="",
        people=(),
        cause=origin.cause,
        began_at=began_at,
        drone=drone,
    )


@dataclass(frozen=True, slots=True)
class AuditEntry:
    """Who did what with a clip, and when [Unix time, s]."""

    at: float
    who: str
    what: str


class ClipTable:
    """The rows of a folder of clips; safe for several threads and processes.

    Args:
        folder: made if missing, mode 0700.

    Raises:
        StoreError: the file cannot be opened.
    """

    def __init__(self, folder: Path) -> None:
        self._lock = threading.RLock()
        file = folder / _DATABASE
        try:
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            folder.chmod(0o700)
            os.close(os.open(file, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o600))
            file.chmod(0o600)
            self._database = _opened(file)
        except (OSError, sqlite3.Error) as error:
            raise StoreError(f"the clips' index {file} cannot be opened: {error}") from error

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._database.close()

    def put(self, row: ClipRow) -> None:
        """Write a row, new or changed; raises StoreError."""
        values = (
            *(row.id, row.kind, row.task, row.service, row.place, row.thing),
            *(json.dumps(row.people), row.cause, row.began_at, row.duration, row.size),
            *(row.kept, row.blanked, row.whole, row.cut_off, row.drone),
        )
        with self._transaction() as database:
            database.execute(f"REPLACE INTO clips VALUES ({','.join('?' * 16)})", values)

    def remove(self, name: str) -> None:
        """Forget a row; who watched it is remembered; raises StoreError."""
        with self._transaction() as database:
            database.execute("DELETE FROM clips WHERE id = ?", (name,))

    def rows(self, where: str = "1", *values: object, limit: int = -1) -> list[ClipRow]:
        """Return rows by an SQL condition, the newest first; raises StoreError."""
        order = "ORDER BY began_at DESC, id DESC LIMIT ?"
        with self._connection() as database:
            found = database.execute(
                f"SELECT * FROM clips WHERE {where} {order}", (*values, limit)
            ).fetchall()
        return [_row(columns) for columns in found]

    def believed_time(self) -> BelievedTime | None:
        """Return the time that was believed last, None before the first; raises StoreError."""
        with self._connection() as database:
            found = database.execute("SELECT believed, doubted FROM clock").fetchone()
        return None if found is None else BelievedTime(*found)

    def believe(self, time: BelievedTime) -> None:
        """Remember which time is believed; raises StoreError."""
        with self._transaction() as database:
            values = time.believed, time.doubted
            database.execute("REPLACE INTO clock VALUES (1, ?, ?)", values)

    def log(self, name: str, entry: AuditEntry) -> None:
        """Write down who did what with a clip; raises StoreError."""
        with self._transaction() as database:
            database.execute(
                "INSERT INTO views VALUES (?, ?, ?, ?)", (name, entry.at, entry.who, entry.what)
            )

    def audit_log(self, name: str) -> tuple[AuditEntry, ...]:
        """Return what was done with a clip, by time; raises StoreError."""
        with self._connection() as database:
            found = database.execute(
                "SELECT at, who, what FROM views WHERE clip = ? ORDER BY at", (name,)
            )
            return tuple(AuditEntry(*columns) for columns in found.fetchall())

    def adopted_at(self, name: str) -> float:
        """Return when a clip was last taken up again [Unix time, s], 0 if never.

        Raises StoreError.
        """
        with self._connection() as database:
            found = database.execute(
                "SELECT max(at) FROM views WHERE clip = ? AND what = ?", (name, ADOPTED)
            ).fetchone()
        return float(found[0] or 0.0)

    @contextmanager
    def _connection(self) -> Iterator[sqlite3.Connection]:
        try:
            with self._lock:
                yield self._database
        except sqlite3.Error as error:
            raise StoreError(f"the clips' index does not answer: {error}") from error

    @contextmanager
    def _transaction(self) -> Iterator[sqlite3.Connection]:
        with self._connection() as database, database:
            yield database


def _opened(file: Path) -> sqlite3.Connection:
    try:
        return _connected(file)
    except sqlite3.DatabaseError as error:
        if isinstance(error, sqlite3.OperationalError):
            raise
        # The files of the clips are still there and are taken up again.
        file.replace(file.with_suffix(".broken"))
        for suffix in ("-wal", "-shm"):  # a journal of the old one would break the new one
            file.with_name(file.name + suffix).unlink(missing_ok=True)
        os.close(os.open(file, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o600))
        return _connected(file)


def _connected(file: Path) -> sqlite3.Connection:
    database = sqlite3.connect(file, timeout=_BUSY_TIMEOUT, check_same_thread=False)
    database.row_factory = sqlite3.Row
    try:
        database.execute("PRAGMA journal_mode = WAL")
        database.executescript(_SCHEMA)
        columns = database.execute("SELECT name FROM pragma_table_info('clips')").fetchall()
        has = {column["name"] for column in columns}
        for name, kind in _ADDED_COLUMNS.items():
            if name not in has:
                database.execute(f"ALTER TABLE clips ADD COLUMN {name} {kind}")
        _check_every_row(database)
    except sqlite3.Error:
        database.close()
        raise
    return database


def _check_every_row(database: sqlite3.Connection) -> None:
    """Read every page and row; raises sqlite3.DatabaseError for what cannot be read."""
    (found,) = database.execute("PRAGMA quick_check(1)").fetchone()
    if found != "ok":
        raise sqlite3.DatabaseError(found)
    try:
        for columns in database.execute("SELECT * FROM clips"):
            _row(columns)
    except (TypeError, ValueError) as error:
        raise sqlite3.DatabaseError(f"a row cannot be read: {error}") from error


_FLAGS = ("kept", "blanked", "whole", "cut_off")


def _row(columns: sqlite3.Row) -> ClipRow:
    fields = dict(columns)
    flags = {name: bool(fields[name]) for name in _FLAGS}
    return ClipRow(**{**fields, **flags, "people": tuple(json.loads(fields["people"]))})
