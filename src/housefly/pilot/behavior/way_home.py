"""How long the way home takes from where the drone is, asked of the planner now and then."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from housefly.geometry import Vec2, distance
from housefly.messages.steering import PlanAnswer

ASKING_PERIOD = 1.0
"""How often the planner is asked [s]."""
DETOUR_FACTOR = 2.0
"""Where there is no way at present, one this much longer than the straight line is counted on."""


class WayHome:
    """The way home of one drone.

    Attributes:
        duration: expected flight time [s].
        exists: the planner has a way.
    """

    def __init__(self, route: Callable[[Vec2, Vec2], PlanAnswer], home: Vec2, speed: float) -> None:
        self.duration = 0.0
        self.exists = True
        self._route = route
        self._home = home
        self._speed = speed
        self._asked_at = -inf

    def update(self, here: Vec2, now: float) -> None:
        """Ask anew from a place [m], when the last answer is old at a time [s]."""
        if now - self._asked_at < ASKING_PERIOD:
            return
        self._asked_at = now
        answer = self._route(here, self._home)
        self.exists = answer.path is not None
        straight = distance(here, self._home) / self._speed
        self.duration = answer.duration if self.exists else DETOUR_FACTOR * straight
