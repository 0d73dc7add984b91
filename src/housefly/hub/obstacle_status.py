"""The live obstacles, until they are too old."""

from __future__ import annotations

import threading
from math import hypot

from housefly.clock import Clock
from housefly.hub.api.answers import ObstacleAnswer
from housefly.hub.room_status import RoomStatus
from housefly.messages import Obstacle

_OBSTACLE_TIMEOUT = 2.0
"""An obstacle without an update for this long is gone [s]."""
_MAX_OBSTACLES = 256


class ObstacleStatus:
    """Keeps the newest update of each obstacle; thread-safe."""

    def __init__(self, status: RoomStatus, clock: Clock) -> None:
        self._status, self._clock = status, clock
        self._lock = threading.Lock()
        self._seen: dict[tuple[str, str], Obstacle] = {}

    def update(self, obstacle: Obstacle) -> None:
        """Update an obstacle; a confidence of 0 removes it."""
        key = obstacle.source, obstacle.id
        with self._lock:
            if obstacle.confidence <= 0.0:
                self._seen.pop(key, None)
            elif key in self._seen or len(self._seen) < _MAX_OBSTACLES:
                self._seen[key] = obstacle

    def refresh(self) -> None:
        """Drop old obstacles and publish the others in the room's status."""
        now = self._clock.now()
        with self._lock:
            self._seen = {
                key: seen
                for key, seen in self._seen.items()
                if now - seen.seen_at < _OBSTACLE_TIMEOUT
            }
            found = tuple(self._seen.values())
        self._status.set_obstacles((_hindrance(obstacle, now) for obstacle in found), "bus")


def _hindrance(obstacle: Obstacle, now: float) -> ObstacleAnswer:
    (x, y), (length, width), (vx, vy) = obstacle.position, obstacle.size, obstacle.velocity
    radius, age = obstacle.radius + 0.5 * hypot(length, width), now - obstacle.seen_at
    grown = (
        (length + 2.0 * obstacle.radius, width + 2.0 * obstacle.radius)
        if length and width
        else (0.0, 0.0)
    )
    name = f"{obstacle.source}/{obstacle.id}"
    return ObstacleAnswer(
        name, x, y, radius, vx, vy, obstacle.confidence, age, obstacle.source, *grown, obstacle.yaw
    )
