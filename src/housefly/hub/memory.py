"""The world model in memory, and the store behind it."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from math import isfinite

from housefly.errors import StoreError, ThingError
from housefly.hub.recall import recall
from housefly.hub.store.store import Store
from housefly.hub.store.writer import StoreWriter
from housefly.hub.things.beliefs import Beliefs
from housefly.hub.things.surfaces import Surface
from housefly.hub.things.thing import Thing
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Observation, RoomEvent

_Listener = Callable[[Observation | RoomEvent], None]
_MAX_REFUSALS = 20
"""How many refusals are kept in words."""


class RoomMemory:
    """Collects observations and events from any thread; never waits for the store.

    Attributes:
        world: the world model; use it under ``lock``.
        beliefs: how sure its answers are; likewise.
        surfaces: where carried things may be left.
        lock: guards both.
    """

    def __init__(
        self,
        things: Iterable[Thing],
        open_store: Callable[[], Store],
        surfaces: Sequence[Surface] = (),
    ) -> None:
        """Open the store and load what it knew; raises StoreError if it cannot be opened at all."""
        self.lock = threading.Lock()
        self.writer = StoreWriter(open_store)
        self._store = open_store()
        self._store_lock = threading.Lock()
        self._closed = False
        self.refused: deque[str] = deque(maxlen=_MAX_REFUSALS)
        self._listeners: tuple[_Listener, ...] = ()
        known = {thing.id: thing for thing in self._store.things()}
        own = {thing.id: thing for thing in things}
        self.world = WorldModel((known | own).values())
        self.writer.write_all(thing for thing in own.values() if known.get(thing.id) != thing)
        self.surfaces = tuple(surfaces)
        self.beliefs = Beliefs(self.surfaces)
        for sample in self._store.latest():
            self._observe(sample)
        if isfinite(newest := self.newest()):
            recall(self.beliefs, self.world, self._store, newest)

    def newest(self) -> float:
        """Return the Unix time of the newest observation [s]; minus infinity without one."""
        with self.lock:
            return max(
                (
                    sample.captured_at
                    for thing in self.world.things
                    for sample in self.world.latest_observations(thing.id)
                ),
                default=float("-inf"),
            )

    def add_listener(self, listener: _Listener) -> None:
        """Call the listener with every accepted item; it must be quick and must not raise."""
        self._listeners = (*self._listeners, listener)

    def add(self, item: Observation | RoomEvent) -> None:
        """Add what a sensor or a detector reports."""
        if isinstance(item, Observation):
            with self.lock:
                if not self._observe(item):
                    return
        else:
            with self.lock:
                self.beliefs.note(item)
        self.writer.write(item)
        for listener in self._listeners:
            listener(item)

    @contextmanager
    def store(self) -> Iterator[Store]:
        """Lend the store to one thread at a time; raises StoreError after ``close``."""
        if self._closed:
            raise StoreError("the memory is closed")
        with self._store_lock:
            yield self._store

    def flush(self) -> bool:
        """Wait until everything added so far is in the store; return whether it is."""
        return self.writer.flush()

    def close(self) -> None:
        """Write what waits and close, after the question that is being answered.

        SQLite's connection must not be closed while a thread reads from it: the process would crash
        with a segmentation fault.
        """
        self._closed = True
        self.writer.close()
        with self._store_lock:
            self._store.close()

    def _observe(self, sample: Observation) -> bool:
        try:
            self.world.observe(sample)
        except ThingError as error:
            self.refused.append(str(error))
            return False
        self.beliefs.observe(self.world, sample)
        return True
