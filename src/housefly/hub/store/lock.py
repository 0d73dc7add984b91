"""One run to one memory: two hubs would mix their rooms in silence."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext, suppress
from pathlib import Path

from housefly.config.site import Site
from housefly.config.state import database_file
from housefly.config.text import is_file
from housefly.errors import MissingPartError, SharedStoreError, StoreError
from housefly.hub.store.open import SERVER_SCHEMES


def lock_file(site: Site) -> Path | None:
    """Return the lock file of a site's store; None where a server or nobody keeps it."""
    if not site.hub.enabled or "://" in site.hub.store:
        return None
    database = database_file(site)
    return database.with_name(f"{database.name}.lock")


@contextmanager
def locked_store(site: Site) -> Iterator[None]:
    """Hold the store of a site for this process alone.

    The kernel frees it when the process is gone, however it ended; a server, when the connection
    is: it is held by one of its own.

    Raises:
        SharedStoreError: another process holds it.
        StoreError: its folder cannot be written, or the server does not answer.
        MissingPartError: a server is asked for, and its driver is not installed.
    """
    path = lock_file(site)
    if path is None:
        with _server_lock(site):
            yield
        return
    with _held(path):
        yield


@contextmanager
def reserved_store(site: Site) -> Iterator[None]:
    """Keep the store of a site for one run, from before its hub opens it until the block ends.

    Two runs that begin at once would both find it free otherwise. A server is asked only whether
    another run holds it; what else is wrong with a store is for the hub to tell.

    Raises:
        SharedStoreError: another run holds it, or is about to.
    """
    path = lock_file(site)
    with ExitStack() as stack:
        if path is not None:
            try:
                stack.enter_context(_held(path.with_suffix(".run")))
            except SharedStoreError:
                raise
            except StoreError:
                pass  # it cannot be written: the hub says so, and the room flies without a memory
        refuse_shared_store(site)
        yield


def refuse_shared_store(site: Site) -> None:
    """Raise SharedStoreError when another run holds the store of a site.

    Whether a server answers at all is for the hub to tell.
    """
    path = lock_file(site)
    if path is None:
        _refuse_shared_server(site)
        return
    if not is_file(path):
        return
    descriptor = _opened(path)
    try:
        _lock(descriptor, path)
    finally:
        os.close(descriptor)


@contextmanager
def _held(path: Path) -> Iterator[None]:
    """Hold a lock file for this process; it holds the number of the process, for others' words."""
    descriptor = _opened(path)
    try:
        _lock(descriptor, path)
        os.ftruncate(descriptor, 0)
        with suppress(OSError):  # a full disk: the number is for the words only
            os.pwrite(descriptor, str(os.getpid()).encode(), 0)
        yield
    finally:
        os.close(descriptor)


def _server_lock(site: Site) -> AbstractContextManager[None]:
    if not site.hub.enabled or not site.hub.store.startswith(SERVER_SCHEMES):
        return nullcontext()
    from housefly.hub.store.postgres import locked_database  # an optional part

    return locked_database(site.hub.store, _REMEDY)


def _refuse_shared_server(site: Site) -> None:
    try:
        with _server_lock(site):
            pass
    except MissingPartError:
        return
    except SharedStoreError:
        raise
    except StoreError:
        return


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
        raise SharedStoreError(
            f"another run uses this room's memory (process {holder}, {path.with_suffix('')})",
            f"end that run, or {_REMEDY}",
        ) from error


_REMEDY = "give this site another hub.store, or hub.enabled = false"
