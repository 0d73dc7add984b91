"""Tells whoever listens what changed in the room: a few times a second, only what is new."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from dataclasses import asdict

from housefly.hub.answers import occurrence, placed
from housefly.hub.api.answers import News, Occurrence, Placed
from housefly.hub.memory import RoomMemory
from housefly.hub.present import Present
from housefly.messages import Happening, Observation, RoomNews

PERIOD = 0.2
"""Time between two news [s]."""
MOST_EVENTS = 100
"""Events of one period that are told; more are in the store."""


class Newsroom:
    """Notes what is taken and makes news of it; safe from any thread."""

    def __init__(self, memory: RoomMemory, present: Present, clock: Callable[[], float]) -> None:
        self._memory, self._present, self._clock = memory, present, clock
        self._lock = threading.Lock()
        self._touched: set[str] = set()
        self._events: list[Occurrence] = []
        self._told: tuple[object, ...] = ((), ())
        memory.listen(self._noted)

    def news(self) -> RoomNews | None:
        """Return what changed since the last call; None when nothing did."""
        with self._lock:
            touched, self._touched = self._touched, set()
            events, self._events = tuple(self._events), []
        situations, obstacles = self._present.situations(), self._present.obstacles()
        holding = (situations, obstacles)
        if not touched and not events and holding == self._told:
            return None
        self._told = holding
        news = News(self._clock(), self._placed(touched), events, situations, obstacles)
        return RoomNews(json.dumps(asdict(news), allow_nan=False, ensure_ascii=False))

    def _placed(self, touched: set[str]) -> tuple[Placed, ...]:
        now = self._clock()
        with self._memory.lock:
            world = self._memory.world
            inside = {content for thing in touched for content in world.contents(thing)}
            return tuple(
                placed(world, world.thing(thing), now) for thing in sorted(touched | inside)
            )

    def _noted(self, item: Observation | Happening) -> None:
        with self._lock:
            (
                self._touched.add(item.thing)
                if isinstance(item, Observation)
                else self._note_event(item)
            )

    def _note_event(self, item: Happening) -> None:
        if len(self._events) < MOST_EVENTS:
            self._events.append(occurrence(item))
