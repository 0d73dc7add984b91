"""What the hub holds: the world model in memory, the writer of the store beside it, and the last
things that happened.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from housefly.errors import StoreError, ThingError
from housefly.hub.store.contract import Store
from housefly.hub.store.writer import Writer
from housefly.hub.things.thing import Thing
from housefly.hub.things.world import World
from housefly.messages import Happening, Observation

Listener = Callable[[Observation | Happening], None]
COMPLAINTS = 20
"""So many refusals are kept in words."""


class RoomMemory:
    """Takes what sensors tell from any thread; never waits for the store.

    Attributes:
        world: what is where, now; use it under ``lock``.
        lock: guards the world.
    """

    def __init__(self, things: Iterable[Thing], open_store: Callable[[], Store]) -> None:
        """Open the store, and remember what it last knew; raises StoreError when it cannot be
        opened at all.
        """
        self.lock = threading.Lock()
        self.writer = Writer(open_store)
        self._store = open_store()
        self._store_lock = threading.Lock()
        self._closed = False
        self.refused: deque[str] = deque(maxlen=COMPLAINTS)
        self._listeners: tuple[Listener, ...] = ()
        known = {thing.id: thing for thing in self._store.things()}
        own = {thing.id: thing for thing in things}
        self.world = World((known | own).values())
        self.writer.write_all(thing for thing in own.values() if known.get(thing.id) != thing)
        for sample in self._store.latest():
            self._tell(sample)

    def listen(self, listener: Listener) -> None:
        """Call the listener with everything that is taken; it must be quick and must not raise."""
        self._listeners = (*self._listeners, listener)

    def take(self, item: Observation | Happening) -> None:
        """Take what a sensor or a detector tells."""
        with self.lock:
            if isinstance(item, Happening):
                self.world.happened(item)
            elif not self._tell(item):
                return
        self.writer.write(item)
        for listener in self._listeners:
            listener(item)

    def know(self, *things: Thing) -> None:
        """Add things to the catalogue, or replace them; raises ThingError when one would be inside
        itself.
        """
        with self.lock:
            for thing in things:
                self.world.know(thing)
        self.writer.write_all(things)

    @contextmanager
    def past(self) -> Iterator[Store]:
        """Lend the store for a question about the past, to one thread at a time; raises StoreError
        after ``close``.
        """
        if self._closed:
            raise StoreError("the memory is closed")
        with self._store_lock:
            yield self._store

    def flush(self) -> bool:
        """Wait until everything taken so far is in the store; tell whether it is."""
        return self.writer.flush()

    def close(self) -> None:
        """Write what is left and let go, after the question that is just being answered.

        SQLite's connection must not be closed under a thread that reads from it: the process would
        end with a segmentation fault.
        """
        self._closed = True
        self.writer.close()
        with self._store_lock:
            self._store.close()

    def _tell(self, sample: Observation) -> bool:
        try:
            self.world.told(sample)
        except ThingError as error:
            self.refused.append(str(error))
            return False
        return True
