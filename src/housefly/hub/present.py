"""What holds now besides where things are: how the sensors do, which situations hold, what is in
the way.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from math import isfinite

from housefly.hub.api.answers import Hindrance, Holding, SensorAnswer, SensorsAnswer
from housefly.sensors.contracts import SensorHealth

Health = Callable[[], tuple[SensorHealth, ...]]


class Present:
    """Gathers from whoever knows; safe from any thread."""

    def __init__(self, memory_words: Callable[[], str]) -> None:
        self._memory_words = memory_words
        self._lock = threading.Lock()
        self._healths: tuple[Health, ...] = ()
        self._situations: dict[str, tuple[Holding, ...]] = {}
        self._obstacles: dict[str, tuple[Hindrance, ...]] = {}

    def watch(self, health: Health) -> None:
        """Ask this source of health from now on; it is called on the asker's thread."""
        self._healths = (*self._healths, health)

    def hold(self, situations: Iterable[Holding], teller: str = "") -> None:
        """Replace the situations that hold by the word of one teller."""
        with self._lock:
            self._situations[teller] = tuple(situations)

    def block(self, obstacles: Iterable[Hindrance], teller: str = "") -> None:
        """Replace the live obstacles that one teller knows of."""
        with self._lock:
            self._obstacles[teller] = tuple(obstacles)

    def situations(self) -> tuple[Holding, ...]:
        """Return the situations that hold."""
        with self._lock:
            return tuple(held for own in self._situations.values() for held in own)

    def obstacles(self) -> tuple[Hindrance, ...]:
        """Return the live obstacles."""
        with self._lock:
            return tuple(seen for own in self._obstacles.values() for seen in own)

    def sensors(self) -> SensorsAnswer:
        """Return how every sensor does."""
        found = [sensor for health in self._healths for sensor in health()]
        return SensorsAnswer(tuple(_sensor(sensor) for sensor in found), self._memory_words())


def _sensor(health: SensorHealth) -> SensorAnswer:
    age = health.age if isfinite(health.age) else None
    counts = dict(health.counts)
    return SensorAnswer(
        health.id,
        health.kind,
        health.title,
        health.connected,
        health.rate_hz,
        age,
        health.problem,
        counts,
    )
