"""Obstacles that other processes report to the pilot: checked, bounded, the newest of each."""

from __future__ import annotations

from math import inf
from threading import Lock

from housefly.clock import Clock
from housefly.messages import Obstacle
from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.planning.obstacles import OBSTACLES_MAX, MapExtent, obstacle_fault

REFUSED_OBSTACLE_SHOWN_FOR = 5.0
"""A refusal is shown for this long [s]."""


class ObstacleInbox:
    """Collects obstacles between two steps of the pilot; the bus may carry anything.

    May be added to from any thread: waking the pilot's loop for each costs more than taking it in.

    Args:
        extent: x_min, y_min, x_max, y_max of the map [m].
        clock: the pilot's.

    Attributes:
        refused: how many were wrong or too many.
    """

    def __init__(self, extent: MapExtent, clock: Clock) -> None:
        self.refused = 0
        self._extent, self._clock, self._lock = extent, clock, Lock()
        self._waiting: dict[tuple[str, str], Obstacle] = {}
        self._problem, self._problem_at = UNSAID, -inf

    @property
    def problem(self) -> Words:
        """What was refused in the last seconds, in words, or UNSAID."""
        with self._lock:
            is_shown = self._clock.now() - self._problem_at < REFUSED_OBSTACLE_SHOWN_FOR
            return self._problem if is_shown else UNSAID

    def add(self, obstacle: Obstacle) -> None:
        """Add an obstacle, or refuse it."""
        with self._lock:
            self._take(obstacle, self._clock.now())

    def drain(self) -> tuple[Obstacle, ...]:
        """Return what came since the last call."""
        with self._lock:
            taken = tuple(self._waiting.values())
            self._waiting.clear()
        return taken

    def _take(self, obstacle: Obstacle, now: float) -> None:
        name = obstacle.source, obstacle.id
        fault = obstacle_fault(obstacle, now, self._extent)
        if not fault and name not in self._waiting and len(self._waiting) >= OBSTACLES_MAX:
            fault = Words("there are more than {n} at once", n=figure(OBSTACLES_MAX))
        if fault:
            self.refused += 1
            self._problem, self._problem_at = (
                Words(
                    "an obstacle of {who} is refused: {why}",
                    who=repr(obstacle.source[:40]),
                    why=fault,
                ),
                now,
            )
            return
        known = self._waiting.get(name)
        if known is None or known.seen_at <= obstacle.seen_at:
            self._waiting[name] = obstacle
