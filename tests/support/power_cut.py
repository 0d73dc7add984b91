"""What a power cut leaves of a folder: what the disk was asked for, and of the rest some."""

from __future__ import annotations

import json
import os
import random
import stat
import struct
from contextlib import suppress
from pathlib import Path

_LOG_HEADER, _FRAME_HEADER = 32, 24
CHECKPOINT = 1000 * 4096
"""A longer log is about to go into the file, or goes just now: all of it is on the disk [bytes]."""
_ENDINGS = ("", "-wal")
"""Of the files of an SQLite database that count; the program asks the disk for them in C."""


def tear_log(log: Path, chance: random.Random) -> None:
    """Lose, of what the disk was not asked for yet, some: the last commit, or a part of it."""
    data = log.read_bytes()
    ends = log_commits(data)
    if len(ends) > 1 and ends[-1] < CHECKPOINT and chance.random() < 0.7:
        data = data[: chance.randrange(ends[-2], len(data) + 1)]
        data += chance.randbytes(chance.randrange(5000)) if chance.random() < 0.5 else b""
        log.write_bytes(data)


def log_commits(log: bytes) -> list[int]:
    """Return where in a write-ahead log its commits end (https://sqlite.org/fileformat2.html)."""
    if len(log) < _LOG_HEADER:
        return []
    (page_size,), salts = struct.unpack_from(">8xI", log), log[16:24]
    ends, at = [], _LOG_HEADER
    while at + _FRAME_HEADER + page_size <= len(log) and log[at + 8 : at + 16] == salts:
        is_commit = struct.unpack_from(">4xI", log, at)[0] > 0
        at += _FRAME_HEADER + page_size
        ends += [at] if is_commit else []
    return ends


class DiskWitness:
    """Stands in this process between a program and ``os.fsync``, and notes what the disk has.

    Args:
        disk: the folder that the program writes to.
        notes: of what was asked for, and links that keep what is renamed over or removed.
    """

    def __init__(self, disk: Path, notes: Path) -> None:
        self._disk, self._notes = disk, notes
        self._sizes: dict[int, int] = {}
        self._names: dict[str, int] = {}
        self._fsync = os.fsync
        notes.mkdir(parents=True)

    def begin(self) -> None:
        """Hear of all that is asked for from now on."""
        os.fsync = os.fdatasync = self._asked

    def _asked(self, descriptor: int) -> None:
        self._fsync(descriptor)
        found = os.fstat(descriptor)
        now = names_in(self._disk)
        if stat.S_ISDIR(found.st_mode):
            folder = next(
                path
                for path in (self._disk, *self._disk.rglob("*"))
                if path.is_dir() and path.stat().st_ino == found.st_ino
            )
            here = {name: one for name, one in now.items() if (self._disk / name).parent == folder}
            gone = [name for name in self._names if (self._disk / name).parent == folder]
            self._names = {k: v for k, v in self._names.items() if k not in gone} | here
        else:
            self._sizes[found.st_ino] = found.st_size
            self._names |= {name: one for name, one in now.items() if one == found.st_ino}
        for name, number in self._names.items():
            with suppress(FileExistsError, FileNotFoundError):
                os.link(self._disk / name, self._notes / str(number))
        fresh = self._notes / "fresh"
        fresh.write_text(json.dumps({"sizes": self._sizes, "names": self._names}))
        fresh.replace(self._notes / "durable.json")


def names_in(disk: Path) -> dict[str, int]:
    """Return the files of a folder by their names in it, each with the number of its inode."""
    found = {}
    for path in disk.rglob("*"):
        with suppress(FileNotFoundError):
            if path.is_file():
                found[str(path.relative_to(disk))] = path.stat().st_ino
    return found


def power_cut(disk: Path, notes: Path, to: Path, chance: random.Random) -> None:
    """Copy what a power cut would leave at this instant, in which nobody writes.

    Args:
        disk: the folder that is written to.
        notes: of the witness.
        to: where the copy goes.
        chance: decides over what the disk was not asked for.
    """
    try:
        durable = json.loads((notes / "durable.json").read_text())
    except FileNotFoundError:
        durable = {"sizes": {}, "names": {}}
    now = names_in(disk)
    databases = [name for name in now if name.endswith(".db")]
    by_sqlite = {name + ending for name in databases for ending in ("", "-wal", "-shm")}
    # Names reach the disk in one order, all up to a moment; here the last asked for, or all.
    names = now if chance.random() < 0.5 else durable["names"]
    names = {name: number for name, number in names.items() if name not in by_sqlite}
    for name, number in names.items():
        kept = notes / str(number)
        data = (kept if kept.exists() else disk / name).read_bytes()
        _put(to / name, _cut_off(data, durable["sizes"].get(str(number), 0), chance))
    for name in databases:
        for ending in _ENDINGS:
            if (source := disk / f"{name}{ending}").exists():
                _put(to / f"{name}{ending}", source.read_bytes())
        if (log := to / f"{name}-wal").exists():
            tear_log(log, chance)


def _cut_off(data: bytes, durable: int, chance: random.Random) -> bytes:
    """Return what is left: some file systems know the length before they have what is there."""
    left = data[: chance.randint(min(durable, len(data)), len(data))]
    return left + bytes(len(data) - len(left)) if chance.random() < 0.3 else left


def _put(path: Path, data: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
