"""Whether a drone stands where it stood before, or on something."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.behavior.mission import VehicleStatus

STANDS_HIGH = 0.15
"""A drone that stands this much higher than before the flight stands on something [m]."""
POSE_AGE_MAX = 0.5
"""An older pose says nothing about what the drone stands on [s]."""


def raised(vehicle: VehicleStatus) -> float:
    """Return how much higher the drone is than it stood before [m]; 0 where that is unknown."""
    if vehicle.estimate is None or not vehicle.pose_age <= POSE_AGE_MAX:
        return 0.0
    return vehicle.estimate.position[2] - vehicle.standing_height


@dataclass(frozen=True, slots=True)
class StandingHeight:
    """Where a drone stood before a flight, for those who only hear of the pilot.

    Attributes:
        height: tracked height at which it stood last [m]; infinite before it was seen.
    """

    height: float = inf

    def stood_at(self, height: float, pose_age: float) -> StandingHeight:
        """Return the height of a drone that stands, seen so high [m], so long ago [s]."""
        return StandingHeight(height) if pose_age <= POSE_AGE_MAX else self

    def fault(self, height: float, pose_age: float) -> Words:
        """Return what is wrong with where it stands now, seen so high [m], in words, or UNSAID."""
        above = height - self.height
        if not (pose_age <= POSE_AGE_MAX and above > STANDS_HIGH):
            return UNSAID
        by = figure(above, ".2f")
        return Words("stands {d} m above where it took off: on something", d=by)


NEVER_STOOD = StandingHeight()
"""Of a drone that nobody saw standing yet."""
