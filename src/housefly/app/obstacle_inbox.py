"""Obstacles that other processes report to the pilot: checked, bounded, the newest of each."""

from __future__ import annotations

from math import inf

from housefly.clock import Clock
from housefly.messages import Obstacle
from housefly.pilot.planning.obstacles import OBSTACLES_MAX, MapExtent, obstacle_fault

REFUSED_OBSTACLE_SHOWN_FOR = 5.0
"""A refusal is shown for this long [s]."""


class ObstacleInbox:
    """Collects obstacles between two steps of the pilot; the bus may carry anything.

    Args:
        extent: x_min, y_min, x_max, y_max of the map [m].
        clock: the pilot's.

    Attributes:
        refused: how many were wrong or too many.
    """

    def __init__(self, extent: MapExtent, clock: Clock) -> None:
        self.refused = 0
        self._extent, self._clock = extent, clock
        self._waiting: dict[tuple[str, str], Obstacle] = {}
        self._problem, self._problem_at = "", -inf

    @property
    def problem(self) -> str:
        """What was refused in the last seconds, in words, or ""."""
        return (
            self._problem
            if self._clock.now() - self._problem_at < REFUSED_OBSTACLE_SHOWN_FOR
            else ""
        )

    def add(self, obstacle: Obstacle) -> None:
        """Add an obstacle, or refuse it."""
        now = self._clock.now()
        name = obstacle.source, obstacle.id
        fault = obstacle_fault(obstacle, now, self._extent)
        if not fault and name not in self._waiting and len(self._waiting) >= OBSTACLES_MAX:
            fault = f"there are more than {OBSTACLES_MAX} at once"
        if fault:
            self.refused += 1
            self._problem, self._problem_at = (
                f"an obstacle of {obstacle.source[:40]!r} is refused: {fault}",
                now,
            )
            return
        known = self._waiting.get(name)
        if known is None or known.seen_at <= obstacle.seen_at:
            self._waiting[name] = obstacle

    def drain(self) -> tuple[Obstacle, ...]:
        """Return what came since the last call."""
        taken = tuple(self._waiting.values())
        self._waiting.clear()
        return taken
