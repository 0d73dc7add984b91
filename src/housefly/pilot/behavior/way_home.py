"""The way home from where the drone is: how long it takes, and the charge that it needs."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2, distance
from housefly.messages.steering import PlanAnswer

ASKING_PERIOD, ASKING_PERIOD_IN_SPACE = 1.0, 5.0
"""How often the planner is asked [s]; a trajectory costs milliseconds, so what the drone has moved
since then is added to the last answer.
"""
DETOUR_FACTOR = 2.0
"""Where there is no way at present, one this much longer than the straight line is counted on."""
LANDING_TIME = 15.0
"""A landing, with what goes before it, takes no longer than this [s]."""
RETURN_RESERVE = 0.02
"""Charge that is left above the floor when a drone that turned home in time stands."""


class WayHome:
    """The way home of one drone.

    Attributes:
        duration: expected flight time [s].
        exists: the planner has a way.
    """

    def __init__(
        self,
        route: Callable[[Vec2, Vec2], PlanAnswer],
        home: Vec2,
        speed: float,
        *,
        in_space: bool = False,
    ) -> None:
        self.duration = self._answered = 0.0
        self.exists = True
        self._period = ASKING_PERIOD_IN_SPACE if in_space else ASKING_PERIOD
        self._in_space, self._asked_from = in_space, home
        self._route = route
        self._home = home
        self._speed = speed
        self._asked_at = -inf

    def update(self, here: Vec2, now: float) -> None:
        """Ask anew from a place [m], when the last answer is old at a time [s]."""
        if now - self._asked_at < self._period:
            if self._in_space:
                self.duration = self._answered + distance(here, self._asked_from) / self._speed
            return
        self._asked_at, self._asked_from = now, here
        answer = self._route(here, self._home)
        self.exists = answer.path is not None
        straight = distance(here, self._home) / self._speed
        self._answered = answer.duration if self.exists else DETOUR_FACTOR * straight
        self.duration = self._answered


def charge_for(seconds: float, drain: float, limits: LimitsConfig) -> float:
    """Return the charge [1] that a flight of so long and a landing need; drain in 1/s."""
    return limits.battery_floor + RETURN_RESERVE + drain * (seconds + LANDING_TIME)


def usable_time(charge: float, seconds: float, limits: LimitsConfig) -> float:
    """Return for how long a drone may fly before it must turn home [s].

    Args:
        charge: of the battery, 0 to 1.
        seconds: expected flight time of the way home [s].
        limits: of the drone.
    """
    drain = 1.0 / limits.flight_time
    return max(0.0, (charge - charge_for(seconds, drain, limits)) / drain)
