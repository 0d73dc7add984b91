"""Publishes what changed in the room: a few times a second, only what is new."""

from __future__ import annotations

import threading
from collections.abc import Callable

from housefly.hub.api.answers import EventAnswer, News, PlacedThing
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import placed_thing
from housefly.hub.room_status import RoomStatus
from housefly.hub.said import event_answer
from housefly.messages import Observation, RoomEvent

CHANGE_FEED_PERIOD = 0.2
"""Time between two publications [s]."""
MAX_EVENTS = 100
"""At most this many events of one period are published; all are in the store."""


class ChangeFeed:
    """Collects changes of the memory and turns them into news; thread-safe."""

    def __init__(self, memory: RoomMemory, status: RoomStatus, clock: Callable[[], float]) -> None:
        self._memory, self._status, self._clock = memory, status, clock
        self._lock = threading.Lock()
        self._touched: set[str] = set()
        self._events: list[EventAnswer] = []
        self._last_status: tuple[object, ...] = ((), ())
        memory.add_listener(self._record)

    def changes(self) -> News | None:
        """Return what changed since the last call; None if nothing did."""
        with self._lock:
            touched, self._touched = self._touched, set()
            events, self._events = tuple(self._events), []
        situations, obstacles = self._status.situations(), self._status.obstacles()
        holding = (situations, obstacles)
        if not touched and not events and holding == self._last_status:
            return None
        self._last_status = holding
        return News(self._clock(), self._placed(touched), events, situations, obstacles)

    def _placed(self, touched: set[str]) -> tuple[PlacedThing, ...]:
        now = self._clock()
        with self._memory.lock:
            world = self._memory.world
            inside = {content for thing in touched for content in world.contents(thing)}
            return tuple(
                placed_thing(world, world.thing(thing), now) for thing in sorted(touched | inside)
            )

    def _record(self, item: Observation | RoomEvent) -> None:
        with self._lock:
            (
                self._touched.add(item.thing)
                if isinstance(item, Observation)
                else self._record_event(item)
            )

    def _record_event(self, item: RoomEvent) -> None:
        if len(self._events) < MAX_EVENTS:
            self._events.append(event_answer(item))
