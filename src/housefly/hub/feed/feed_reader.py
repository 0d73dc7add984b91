"""Answers what happened lately from the memory, by as little of it as makes the entries."""

from __future__ import annotations

from collections.abc import Callable
from math import hypot

from housefly.hub.api.feed_answers import FeedAnswer
from housefly.hub.api.questions import FeedQuestion
from housefly.hub.feed.grouping import grouped
from housefly.hub.memory import RoomMemory
from housefly.hub.said import event_answer
from housefly.hub.things.thing import ThingKind

_WINDOWS = (3600.0, 6 * 3600.0, 86400.0)
"""How far it looks back [s]: farther only while there is too little."""
_REACH = {ThingKind.FURNITURE: 1.0, ThingKind.PLACE: 1.5}
"""Whoever stands this near to one is at it [m]; furniture counts first."""


class FeedReader:
    """Reads the feed; thread-safe.

    Args:
        memory: of the room.
        clock: Unix time [s].
    """

    def __init__(self, memory: RoomMemory, clock: Callable[[], float]) -> None:
        self._memory, self._clock = memory, clock

    def answer(self, question: FeedQuestion) -> FeedAnswer:
        """Return what happened in the last day, grouped, the newest first."""
        until = self._clock() if question.until is None else question.until
        topic = None if question.of == "all" else question.of
        names = _Names(self._memory)
        self._memory.flush()
        for window in _WINDOWS:
            with self._memory.store() as store:
                events = store.events(max(0.0, until - window), until)
            entries = grouped([event_answer(one) for one in events], names, topic)
            # The oldest entry may have begun before the window.
            if len(entries) > question.limit:
                break
        return FeedAnswer(entries[: question.limit])


class _Names:
    """Names and spots of a room, as of now."""

    def __init__(self, memory: RoomMemory) -> None:
        with memory.lock:
            world = memory.world
            self._names = {thing.id: thing.name for thing in world.things}
            self._spots = [
                (place[:2], thing.name, reach)
                for kind, reach in _REACH.items()
                for thing in world.of_kind(kind)
                if (place := world.where(thing.id).position) is not None
            ]

    def name(self, thing: str) -> str:
        """Return what people call a thing."""
        return self._names.get(thing) or thing.replace("-", " ")

    def spot(self, x: float, y: float) -> str:
        """Return beside what a place [m] is, "" for nothing."""
        near = (
            (kind, distance, name)
            for (px, py), name, kind in self._spots
            if (distance := hypot(px - x, py - y)) < kind
        )
        return min(near, default=(0.0, 0.0, ""))[2]
