"""What waits to be written: bounded, so that a disk that refuses never fills the memory."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass
from threading import Lock

from housefly.hub.things.thing import Thing
from housefly.messages import Happening, Observation

MOST_AT_ONCE = 5000
"""At most so many samples, and so many events, in one transaction."""


@dataclass(frozen=True, slots=True)
class Batch:
    """What is written in one transaction, things in one before it."""

    samples: tuple[Observation, ...] = ()
    happenings: tuple[Happening, ...] = ()
    things: tuple[Thing, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.samples or self.happenings or self.things)


@dataclass(frozen=True, slots=True)
class Dropped:
    """How many rows had to go."""

    poses: int = 0
    events: int = 0

    def __bool__(self) -> bool:
        return bool(self.poses or self.events)


class Backlog:
    """A queue for many threads that never blocks: when it is full the oldest samples go, events
    only when no sample is left.
    """

    def __init__(self, capacity: int) -> None:
        self._capacity = capacity
        self._samples: deque[Observation] = deque()
        self._happenings: deque[Happening] = deque()
        self._things: dict[str, Thing] = {}
        self._lock = Lock()

    def __len__(self) -> int:
        return len(self._samples) + len(self._happenings) + len(self._things)

    def put(self, said: Iterable[Observation | Happening | Thing]) -> Dropped:
        """Let values wait; return what had to go for them."""
        with self._lock:
            for value in said:
                match value:
                    case Observation():
                        self._samples.append(value)
                    case Happening():
                        self._happenings.append(value)
                    case Thing():
                        self._things[value.id] = value
            return self._shrink()

    def take(self) -> Batch:
        """Return and forget what is written next, the oldest first."""
        with self._lock:
            samples = [
                self._samples.popleft() for _ in range(min(MOST_AT_ONCE, len(self._samples)))
            ]
            happenings = [
                self._happenings.popleft() for _ in range(min(MOST_AT_ONCE, len(self._happenings)))
            ]
            things = tuple(self._things.values())
            self._things.clear()
            return Batch(tuple(samples), tuple(happenings), things)

    def _shrink(self) -> Dropped:
        too_many = max(0, len(self._samples) + len(self._happenings) - self._capacity)
        poses = min(too_many, len(self._samples))
        for _ in range(poses):
            self._samples.popleft()
        for _ in range(too_many - poses):
            self._happenings.popleft()
        return Dropped(poses, too_many - poses)
