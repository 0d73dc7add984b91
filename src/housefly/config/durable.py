"""Brings to the disk what must outlive a power cut; a killed process loses no more than that.

What a program has written waits in the memory of the machine, on many for half a minute.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterable
from pathlib import Path

SYNC_PERIOD = 0.5
"""How often what is written all the time is brought to the disk [s]."""


class SyncPace:
    """Says when a file that grows all the time is due to be brought to the disk.

    Args:
        clock: monotonic [s].
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._last = clock()

    def is_due(self) -> bool:
        """Return whether the time has come; the next comes a period later."""
        now = self._clock()
        if now - self._last < SYNC_PERIOD:
            return False
        self._last = now
        return True


def sync_file(path: Path) -> None:
    """Wait until the disk has all that anybody wrote to a file; may raise OSError."""
    _synced(os.open(path, os.O_RDONLY))


def sync_folder(folder: Path) -> None:
    """Wait until the disk has the names in a folder; may raise OSError.

    Until then a power cut may take a new name back, and bring an old file back under it.
    """
    _synced(os.open(folder, os.O_RDONLY | os.O_DIRECTORY))


def write_whole(file: Path, content: bytes) -> None:
    """Write a file for this user only, whole or not at all; may raise OSError.

    Args:
        file: its folder is made if missing, mode 0700.
        content: takes the place of what was there.
    """
    file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    new = file.with_suffix(".new")
    descriptor = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(descriptor, "wb") as target:
        target.write(content)
        target.flush()
        os.fsync(target.fileno())
    new.replace(file)
    sync_folder(file.parent)


def append_lines(file: Path, lines: Iterable[str], *, sync: bool = True) -> int:
    """Append lines to a file for this user only, and return its size [bytes]; may raise OSError.

    What a crash or a full disk cut off before stays a line of its own.

    Args:
        file: made if missing, mode 0600; its folder must exist, and it is no link.
        lines: without their ends.
        sync: whether the disk has them on return.
    """
    flags = os.O_RDWR | os.O_APPEND | os.O_CREAT | os.O_NOFOLLOW
    with os.fdopen(os.open(file, flags, 0o600), "r+b", buffering=0) as target:
        descriptor = target.fileno()
        os.fchmod(descriptor, 0o600)
        size = os.fstat(descriptor).st_size
        is_torn = size > 0 and os.pread(descriptor, 1, size - 1) != b"\n"
        text = "\n" * is_torn + "".join(f"{line}\n" for line in lines)
        left = memoryview(text.encode())
        while left:
            left = left[os.write(descriptor, left) :]
        if sync:
            os.fsync(descriptor)
        after = os.fstat(descriptor).st_size
    if sync and not size:
        sync_folder(file.parent)
    return after


def _synced(descriptor: int) -> None:
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
