"""Whether tracking and map agree on where the pad is: seen once, before the first take-off.

A map that is shifted, turned or mirrored shows in no motion before the drone strikes something. It
shows on the pad: the drone stands there, by the word of whoever put it there, and tracking has it
elsewhere.
"""

from __future__ import annotations

from math import radians

from housefly.geometry import Vec2, distance
from housefly.messages.sensing import DroneStatus
from housefly.numeric import wrapped
from housefly.pilot.behavior.mission import VehicleStatus

PAD_DISTANCE_MAX = 0.3
"""A drone on its pad is tracked no farther from it than this [m] ..."""
PAD_HEADING_MAX = radians(20.0)
"""... and turned against the pad by no more than this [rad]."""
_POSE_AGE_MAX = 0.25
"""An older pose shows nothing [s]."""


class OriginMonitor:
    """Remembers that the drone was seen on its pad.

    Args:
        pad: where it is [m].
        heading: of a drone on it [rad].

    Attributes:
        confirmed: whether tracking has shown the drone on its pad, or was known to agree with the
            map before this pilot began.
    """

    def __init__(self, pad: Vec2, heading: float) -> None:
        self._pad, self._heading, self.confirmed = pad, heading, False

    def step(self, vehicle: VehicleStatus) -> None:
        """Look at the drone once more."""
        self.confirmed |= vehicle.origin_known or (
            vehicle.status is DroneStatus.LANDED
            and vehicle.pose_age <= _POSE_AGE_MAX
            and self.distance(vehicle) <= PAD_DISTANCE_MAX
            and self.turn(vehicle) <= PAD_HEADING_MAX
        )

    def distance(self, vehicle: VehicleStatus) -> float:
        """Return how far tracking has the drone from its pad [m]; 0 when unknown."""
        return 0.0 if vehicle.place is None else distance(vehicle.place, self._pad)

    def turn(self, vehicle: VehicleStatus) -> float:
        """Return how far tracking has the drone turned against its pad [rad]; 0 when unknown."""
        seen = vehicle.estimate
        return 0.0 if seen is None else abs(wrapped(seen.yaw - self._heading))
