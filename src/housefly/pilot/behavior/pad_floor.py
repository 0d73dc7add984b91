"""What lies on the pad: the sonar's height above it now, against that of the take-off.

A box of a decimetre is less than tracking and sonar may differ by anywhere in a room. Above the pad
both were compared a minute ago.
"""

from __future__ import annotations

from math import exp, inf, isfinite

from housefly.geometry import Vec2, distance
from housefly.messages.sensing import REPORT_AGE_MAX, DroneStatus
from housefly.pilot.behavior.mission import VehicleStatus

FLAT_HEIGHT_MIN = 0.06
"""Something lies on the pad when its floor seems higher than at the take-off by this [m]."""
PAD_RADIUS = 0.3
"""Nearer than this to where it took off the pad is below the drone [m]."""
HEIGHT_MIN = 0.4
"""Lower than this the two heights are not compared [m]."""
SONAR_LAG = 0.06
"""The sonar tells of so long ago: its delay, and half the time between two pings [s]."""
SMOOTHING_TIME = 0.3
"""Time constant of the comparison [s]: the sonar is noisy."""
LEARNED_TIME = 0.5
"""The pad's floor is known after so long above it [s] ..."""
STANDING_OFF_MAX = 0.15
"""... unless the drone stood higher or lower than that says by more than this [m]: a sonar that
tells nothing of the floor.
"""
_STEP_MAX = 0.1


class PadFloor:
    """Remembers the floor that the drone took off from."""

    def __init__(self) -> None:
        self._pad: Vec2 | None = None
        self._offset = self._stood = self._learned_for = 0.0
        self._has_left = False
        self._seems, self._now = 0.0, inf

    @property
    def is_known(self) -> bool:
        """Whether the drone has seen it for long enough."""
        is_plausible = abs(self._offset - self._stood) < STANDING_OFF_MAX
        return self._learned_for >= LEARNED_TIME and is_plausible

    @property
    def height(self) -> float:
        """How high what lies on the pad is [m]; 0 where nothing does, or the pad is not below."""
        return self._seems if self._seems > FLAT_HEIGHT_MIN else 0.0

    def offset_at(self, place: Vec2) -> float:
        """Return how much higher than the sonar tracking has the drone above bare floor [m]."""
        return self._offset if self.is_known and self._is_at(place) else 0.0

    def step(self, vehicle: VehicleStatus) -> None:
        """Compare once more."""
        dt = min(max(vehicle.now - self._now, 0.0), _STEP_MAX)
        self._now = vehicle.now
        if vehicle.status is DroneStatus.LANDED:
            self._pad, self._learned_for, self._seems = None, 0.0, 0.0
            self._has_left = False
            return
        self._stood = vehicle.standing_height
        gap, place = _gap(vehicle), vehicle.place
        if self._pad is None and vehicle.status is DroneStatus.TAKING_OFF:
            self._pad = place
        if gap is None or place is None:
            return
        if not self._is_at(place):
            self._has_left, self._seems = True, 0.0
        elif not (self._has_left or (self.is_known and gap - self._offset > FLAT_HEIGHT_MIN)):
            self._learn(gap, dt)
        elif self.is_known:
            self._has_left = True
            share = 1.0 - exp(-dt / SMOOTHING_TIME)
            self._seems += share * (gap - self._offset - self._seems)

    def _learn(self, gap: float, dt: float) -> None:
        self._learned_for += dt
        if dt > 0.0:
            self._offset += dt / self._learned_for * (gap - self._offset)

    def _is_at(self, place: Vec2) -> bool:
        return self._pad is not None and distance(place, self._pad) < PAD_RADIUS


def _gap(vehicle: VehicleStatus) -> float | None:
    """Return tracked minus onboard height [m]; None where they cannot be compared."""
    report, estimate = vehicle.telemetry, vehicle.estimate
    if report is None or estimate is None or vehicle.held or vehicle.reckoned is not None:
        return None
    is_told = vehicle.telemetry_age <= REPORT_AGE_MAX and isfinite(report.height)
    lag = SONAR_LAG + vehicle.telemetry_age
    z = estimate.position[2] - lag * estimate.velocity[2]
    return z - report.height if is_told and z > HEIGHT_MIN else None
