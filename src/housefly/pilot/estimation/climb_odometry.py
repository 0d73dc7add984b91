"""How far the drone has climbed by its sonar, over floors that step below it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import isfinite, nan

from housefly.config.airframe import SonarConstants

READING_GAP = 0.2
"""Between readings that are further apart than this [s] nobody can tell a climb from a step."""
STUCK_TIME = 1.0
"""A sonar that tells the same to the last bit for longer than this may be stuck [s]."""


@dataclass(frozen=True, slots=True)
class ClimbOdometry:
    """The changes of the sonar, told apart: those that can be a climb, and steps of the floor.

    Attributes:
        sonar: what it is like; None where there is none, and nothing is ever climbed by it.
        climbed: sum of those that can be a climb, since it began [m].
        stepped: sum of all others since the floor was seen last [m], below zero above a thing; nan
            when readings were missing since, or stood still.
        at: of the last reading [s].
        height: the last reading [m].
        changed_at: when it was read first [s].
    """

    sonar: SonarConstants | None
    climbed: float = 0.0
    stepped: float = nan
    at: float = nan
    height: float = nan
    changed_at: float = nan

    def updated(self, at: float, height: float) -> ClimbOdometry:
        """Return the odometry after a reading [m] of a time [s]."""
        if self.sonar is None:
            return self
        change, gap = height - self.height, at - self.at
        if change == 0.0 and gap <= READING_GAP:
            is_stuck = at - self.changed_at > STUCK_TIME
            stepped = nan if is_stuck else self.stepped
            return ClimbOdometry(
                self.sonar, self.climbed, stepped, at, self.height, self.changed_at
            )
        dt = max(gap, min(at - self.changed_at, self.sonar.ping_time))
        is_climb = abs(change) <= self.sonar.climb_rate_max * dt + self.sonar.noise
        is_lost = not (gap <= READING_GAP and isfinite(change))
        step = nan if is_lost else 0.0 if is_climb else change
        climbed = self.climbed + change if is_climb else self.climbed
        return ClimbOdometry(self.sonar, climbed, self.stepped + step, at, height, at)

    def over_floor(self) -> ClimbOdometry:
        """Return the odometry of a drone with nothing but floor below it."""
        return self if self.stepped == 0.0 else replace(self, stepped=0.0)
