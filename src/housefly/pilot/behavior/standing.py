"""Whether a drone stands where it stood before, or on something."""

from __future__ import annotations

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
