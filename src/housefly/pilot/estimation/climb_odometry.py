"""How far the drone has climbed by its sonar, over floors that step below it."""

from __future__ import annotations

from dataclasses import dataclass
from math import nan

CLIMB_MAX = 1.5
"""No drone climbs or sinks faster [m/s]: what changes faster is the floor below."""
SONAR_NOISE = 0.03
"""A reading may be off by this [m]."""


@dataclass(frozen=True, slots=True)
class ClimbOdometry:
    """The sum of all changes of the sonar that can be a climb.

    Attributes:
        climbed: since it began [m].
        at: of the last reading [s].
        height: the last reading [m].
    """

    climbed: float = 0.0
    at: float = nan
    height: float = nan

    def updated(self, at: float, height: float) -> ClimbOdometry:
        """Return the odometry after a reading [m] of a time [s]."""
        change, dt = height - self.height, at - self.at
        is_climb = abs(change) <= CLIMB_MAX * dt + SONAR_NOISE
        return ClimbOdometry(self.climbed + change if is_climb else self.climbed, at, height)
