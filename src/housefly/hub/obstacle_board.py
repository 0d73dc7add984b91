"""The live obstacles as they were last told, until they are too old to be there."""

from __future__ import annotations

import threading
from math import hypot

from housefly.clock import Clock
from housefly.hub.api.answers import Hindrance
from housefly.hub.present import Present
from housefly.messages import Obstacle

FORGOTTEN = 2.0
"""An obstacle that nobody told of for so long is gone [s]."""
MOST = 256


class ObstacleBoard:
    """Keeps the newest word on each obstacle; safe from any thread."""

    def __init__(self, present: Present, clock: Clock) -> None:
        self._present, self._clock = present, clock
        self._lock = threading.Lock()
        self._seen: dict[tuple[str, str], Obstacle] = {}

    def heard(self, obstacle: Obstacle) -> None:
        """Take what a source says; a confidence of 0 takes the obstacle away."""
        key = obstacle.source, obstacle.id
        with self._lock:
            if obstacle.confidence <= 0.0:
                self._seen.pop(key, None)
            elif key in self._seen or len(self._seen) < MOST:
                self._seen[key] = obstacle

    def step(self) -> None:
        """Show what is still there."""
        now = self._clock.now()
        with self._lock:
            self._seen = {
                key: seen for key, seen in self._seen.items() if now - seen.seen_at < FORGOTTEN
            }
            found = tuple(self._seen.values())
        self._present.block((_hindrance(obstacle, now) for obstacle in found), "bus")


def _hindrance(obstacle: Obstacle, now: float) -> Hindrance:
    (x, y), (length, width), (vx, vy) = obstacle.position, obstacle.size, obstacle.velocity
    radius, age = obstacle.radius + 0.5 * hypot(length, width), now - obstacle.seen_at
    grown = (
        (length + 2.0 * obstacle.radius, width + 2.0 * obstacle.radius)
        if length and width
        else (0.0, 0.0)
    )
    name = f"{obstacle.source}/{obstacle.id}"
    return Hindrance(
        name, x, y, radius, vx, vy, obstacle.confidence, age, obstacle.source, *grown, obstacle.yaw
    )
