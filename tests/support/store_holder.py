"""Another process that holds the memory of a room, as another run does."""

from __future__ import annotations

import multiprocessing
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from housefly.config.site import Site, changed
from housefly.hub.store.lock import locked_store


def _hold(store: str, held: Any, end: Any) -> None:
    with locked_store(changed(Site(), hub__store=store)):
        held.set()
        end.wait()


@contextmanager
def held_elsewhere(store: str) -> Iterator[int]:
    """Yield the process id of who holds a store until the block ends; then it is killed."""
    context = multiprocessing.get_context("spawn")
    held, end = context.Event(), context.Event()
    other = context.Process(target=_hold, args=(store, held, end))
    other.start()
    try:
        assert held.wait(30)
        assert other.pid is not None
        yield other.pid
    finally:
        other.kill()
        other.join()
