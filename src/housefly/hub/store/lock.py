"""One run to one memory: two hubs would mix their rooms in silence."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from housefly.config.site import Site
from housefly.config.state import database_file
from housefly.config.text import is_file
from housefly.errors import StoreError


def lock_file(site: Site) -> Path | None:
    """Return the lock file of a site's store; None where a server or nobody keeps it."""
    if not site.hub.enabled or "://" in site.hub.store:
        return None
    database = database_file(site)
    return database.with_name(f"{database.name}.lock")


@contextmanager
def locked_store(site: Site) -> Iterator[None]:
    """Hold the store of a site for this process alone.

    The kernel frees it when the process is gone, however it ended.

    Raises:
        StoreError: another process holds it, or its folder cannot be written.
    """
    path = lock_file(site)
    if path is None:
        yield
        return
    descriptor = _opened(path)
    try:
        _lock(descriptor, path)
        os.ftruncate(descriptor, 0)
        with suppress(OSError):  # a full disk: the number is for the words only
            os.pwrite(descriptor, str(os.getpid()).encode(), 0)
        yield
    finally:
        os.close(descriptor)


def refuse_shared_store(site: Site) -> None:
    """Raise StoreError when another run holds the store of a site."""
    path = lock_file(site)
    if path is None or not is_file(path):
        return
    descriptor = _opened(path)
    try:
        _lock(descriptor, path)
    finally:
        os.close(descriptor)


def _opened(path: Path) -> int:
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        return os.open(path, os.O_RDWR | os.O_CREAT, 0o600)
    except (OSError, ValueError) as error:
        words = getattr(error, "strerror", None) or str(error)
        raise StoreError(f"{path} cannot be written: {words}", _REMEDY) from error


def _lock(descriptor: int, path: Path) -> None:
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        holder = os.pread(descriptor, 20, 0).decode(errors="replace") or "unknown"
        raise StoreError(
            f"another run uses this room's memory (process {holder}, {path.with_suffix('')})",
            f"end that run, or {_REMEDY}",
        ) from error


_REMEDY = "give this site another hub.store, or hub.enabled = false"
