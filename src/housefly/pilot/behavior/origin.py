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
PAD_DISTANCE_AGAIN = 0.15
"""After tracking was found lying: no farther from where it was seen on its pad before [m]."""
_POSE_AGE_MAX = 0.25
"""An older pose shows nothing [s]."""


class OriginMonitor:
    """Remembers that the drone was seen on its pad, until tracking is found lying.

    Args:
        pad: where it is [m].
        heading: of a drone on it [rad].

    Attributes:
        confirmed: whether tracking has shown the drone on its pad, or was known to agree with the
            map before this pilot began.
        revoked: whether tracking was found lying, and has not shown the drone on its pad since.
    """

    def __init__(self, pad: Vec2, heading: float) -> None:
        self._pad, self._heading = pad, heading
        self._seen_at = pad
        self.confirmed = self.revoked = False

    @property
    def distance_max(self) -> float:
        """How far from its place on the pad the drone may be tracked [m]."""
        return PAD_DISTANCE_AGAIN if self.revoked else PAD_DISTANCE_MAX

    def step(self, vehicle: VehicleStatus) -> None:
        """Look at the drone once more."""
        if vehicle.tracking_disproved:
            self.confirmed, self.revoked = False, True
        elif not self.confirmed and self._is_on_pad(vehicle):
            self._seen_at = vehicle.place or self._pad
            self.confirmed, self.revoked = True, False
        else:
            self.confirmed |= vehicle.origin_known and not self.revoked

    def _is_on_pad(self, vehicle: VehicleStatus) -> bool:
        return (
            vehicle.status is DroneStatus.LANDED
            and vehicle.pose_age <= _POSE_AGE_MAX
            and self.distance(vehicle) <= self.distance_max
            and self.turn(vehicle) <= PAD_HEADING_MAX
        )

    def distance(self, vehicle: VehicleStatus) -> float:
        """Return how far tracking has the drone from its place on its pad [m]; 0 when unknown."""
        place = self._seen_at if self.revoked else self._pad
        return 0.0 if vehicle.place is None else distance(vehicle.place, place)

    def turn(self, vehicle: VehicleStatus) -> float:
        """Return how far tracking has the drone turned against its pad [rad]; 0 when unknown."""
        seen = vehicle.estimate
        return 0.0 if seen is None else abs(wrapped(seen.yaw - self._heading))
