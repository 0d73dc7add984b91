"""What the last gate looks at: ages, status, place. Nothing of plans or purposes."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3
from housefly.messages import DroneStatus

AIRBORNE_STATUSES = frozenset({DroneStatus.TAKING_OFF, DroneStatus.FLYING, DroneStatus.LANDING})
"""States in which the propellers carry the drone."""


@dataclass(frozen=True, slots=True)
class GateInputs:
    """What is known at one step.

    Attributes:
        now: time [s].
        status: the drone's last word about itself.
        battery: charge, 0 to 1; NaN counts as empty.
        pose_age, telemetry_age: [s]; infinite before the first.
        position: estimated place [m], None before the first sighting.
        stopped: STOP is latched.
        cutting: the motors are to be cut.
    """

    now: float
    status: DroneStatus
    battery: float
    pose_age: float
    telemetry_age: float
    position: Vec3 | None
    stopped: bool
    cutting: bool

    @property
    def airborne(self) -> bool:
        """Whether the propellers carry the drone, by its last word."""
        return self.status in AIRBORNE_STATUSES


@dataclass(frozen=True, slots=True)
class Geofence:
    """The box that the drone must stay in: map bounds x_min, y_min, x_max, y_max, and the ceiling
    above the floor [m].
    """

    bounds: tuple[float, float, float, float]
    ceiling: float

    def outside(self, position: Vec3) -> float:
        """Return how far a point lies outside the bounds in the plane [m], 0 inside; infinite when
        it is not a number.
        """
        x, y, _ = position
        x_min, y_min, x_max, y_max = self.bounds
        gaps = (x_min - x, x - x_max, y_min - y, y - y_max)
        return max(0.0, *gaps) if x == x and y == y else float("inf")
