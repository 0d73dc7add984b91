"""The status of the room: health of the sensors, active situations, live obstacles."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from math import isfinite

from housefly.hub.api.answers import ObstacleAnswer, SensorAnswer, SensorsAnswer, SituationAnswer
from housefly.messages.words import literal
from housefly.sensors.contracts import SensorHealth

_HealthSource = Callable[[], tuple[SensorHealth, ...]]


class RoomStatus:
    """Collects the status from its sources; thread-safe."""

    def __init__(self, memory_words: Callable[[], str]) -> None:
        self._memory_words = memory_words
        self._lock = threading.Lock()
        self._healths: tuple[_HealthSource, ...] = ()
        self._situations: dict[str, tuple[SituationAnswer, ...]] = {}
        self._obstacles: dict[str, tuple[ObstacleAnswer, ...]] = {}

    @property
    def is_live(self) -> bool:
        """Whether anything listens to the room, or only its memory answers."""
        return bool(self._healths)

    def add_health_source(self, health: _HealthSource) -> None:
        """Add a source of health; it is called on the asker's thread."""
        self._healths = (*self._healths, health)

    def set_situations(self, situations: Iterable[SituationAnswer], source: str = "") -> None:
        """Replace the active situations of one source."""
        with self._lock:
            self._situations[source] = tuple(situations)

    def set_obstacles(self, obstacles: Iterable[ObstacleAnswer], source: str = "") -> None:
        """Replace the live obstacles of one source."""
        with self._lock:
            self._obstacles[source] = tuple(obstacles)

    def situations(self) -> tuple[SituationAnswer, ...]:
        """Return the active situations."""
        with self._lock:
            return tuple(held for own in self._situations.values() for held in own)

    def obstacles(self) -> tuple[ObstacleAnswer, ...]:
        """Return the live obstacles."""
        with self._lock:
            return tuple(seen for own in self._obstacles.values() for seen in own)

    def offline(self) -> frozenset[str]:
        """Return the ids of the sensors that say themselves that they are gone."""
        found = (sensor for health in self._healths for sensor in health())
        return frozenset(sensor.id for sensor in found if sensor.is_offline)

    def sensors(self) -> SensorsAnswer:
        """Return the health of every sensor."""
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
        literal(health.problem),
        counts,
    )
