"""A bounded queue of rows to write: a failing disk never fills the memory."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass
from threading import Lock

from housefly.hub.things.thing import Thing
from housefly.messages import Observation, RoomEvent

MAX_BATCH = 5000
"""At most this many samples, and this many events, go into one transaction."""


@dataclass(frozen=True, slots=True)
class Batch:
    """What is written in one transaction; things go in one before it."""

    samples: tuple[Observation, ...] = ()
    events: tuple[RoomEvent, ...] = ()
    things: tuple[Thing, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.samples or self.events or self.things)


@dataclass(frozen=True, slots=True)
class Dropped:
    """How many rows were dropped."""

    poses: int = 0
    events: int = 0

    def __bool__(self) -> bool:
        return bool(self.poses or self.events)


class Backlog:
    """A thread-safe queue that never blocks: when full it drops the oldest samples, then events."""

    def __init__(self, capacity: int) -> None:
        self._capacity = capacity
        self._samples: deque[Observation] = deque()
        self._events: deque[RoomEvent] = deque()
        self._things: dict[str, Thing] = {}
        self._lock = Lock()

    def __len__(self) -> int:
        return len(self._samples) + len(self._events) + len(self._things)

    def put(self, values: Iterable[Observation | RoomEvent | Thing]) -> Dropped:
        """Add values; return what was dropped for them."""
        with self._lock:
            for value in values:
                match value:
                    case Observation():
                        self._samples.append(value)
                    case RoomEvent():
                        self._events.append(value)
                    case Thing():
                        self._things[value.id] = value
            return self._shrink()

    def pop_batch(self) -> Batch:
        """Remove and return the next batch, the oldest first."""
        with self._lock:
            samples = [self._samples.popleft() for _ in range(min(MAX_BATCH, len(self._samples)))]
            events = [self._events.popleft() for _ in range(min(MAX_BATCH, len(self._events)))]
            things = tuple(self._things.values())
            self._things.clear()
            return Batch(tuple(samples), tuple(events), things)

    def _shrink(self) -> Dropped:
        too_many = max(0, len(self._samples) + len(self._events) - self._capacity)
        poses = min(too_many, len(self._samples))
        for _ in range(poses):
            self._samples.popleft()
        for _ in range(too_many - poses):
            self._events.popleft()
        return Dropped(poses, too_many - poses)
