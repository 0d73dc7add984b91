"""Whether somebody moves a drone that stands: its attitude and accelerations stir."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf

from housefly.geometry import Vec3
from housefly.messages.sensing import Telemetry
from housefly.numeric import wrapped

SETTLING_TIME = 1.0
"""After touchdown, and after the first report, the sensors settle this long [s]."""
REST_TIME = 2.0
"""Time constant of what counts as rest [s]."""
TILT_STIRRED, TURN_STIRRED = 0.03, 0.05
"""Changes of attitude that no drone at rest shows [rad]."""
ACCELERATION_STIRRED = 0.8
"""Change of an acceleration that no drone at rest shows [m/s^2]: eight times its noise."""
MEMORY = 2.0
"""Motion counts for poses that were believed up to this long before it ended [s]."""


@dataclass(frozen=True, slots=True)
class CarryDetector:
    """What rest looks like, and when the drone last stirred.

    Attributes:
        at: of the last report [s], None before the first.
        settled_at: when stirring begins to count [s].
        attitude: phi, theta, psi at rest [rad].
        acceleration: at rest [m/s^2], None where it is not told.
        stirred_at: when the drone moved last [s].
        told: the drone tells its attitude; one that does not may be carried unnoticed.
    """

    at: float | None = None
    settled_at: float = 0.0
    attitude: Vec3 = (0.0, 0.0, 0.0)
    acceleration: Vec3 | None = None
    stirred_at: float = -inf
    told: bool = False

    def updated(self, telemetry: Telemetry, airborne: bool) -> CarryDetector:
        """Return the detector after a report."""
        at = telemetry.received_at
        attitude = (telemetry.phi, telemetry.theta, telemetry.psi)
        told = self.told or any(attitude)
        if airborne or self.at is None or at < self.settled_at:
            settled_at = self.settled_at
            if airborne or self.at is None:
                settled_at = at + SETTLING_TIME
            return CarryDetector(
                at, settled_at, attitude, telemetry.acceleration, self.stirred_at, told
            )
        stirred = self._is_stirred(attitude, telemetry.acceleration)
        share = min((at - self.at) / REST_TIME, 1.0)
        return replace(
            self,
            at=at,
            attitude=_towards(self.attitude, attitude, share),
            acceleration=_slowly(self.acceleration, telemetry.acceleration, share),
            stirred_at=at if stirred else self.stirred_at,
            told=told,
        )

    def _is_stirred(self, attitude: Vec3, acceleration: Vec3 | None) -> bool:
        phi, theta, psi = (
            abs(wrapped(a - b)) for a, b in zip(attitude, self.attitude, strict=True)
        )
        if max(phi, theta) > TILT_STIRRED or psi > TURN_STIRRED:
            return True
        if acceleration is None or self.acceleration is None:
            return False
        changes = (abs(a - b) for a, b in zip(acceleration, self.acceleration, strict=True))
        return max(changes) > ACCELERATION_STIRRED

    def stirred_since(self, at: float) -> bool:
        """Return whether the drone may have been moved since a time [s], or cannot tell."""
        return not self.told or self.stirred_at >= at - MEMORY


def _towards(rest: Vec3, now: Vec3, share: float) -> Vec3:
    x, y, z = (a + share * wrapped(b - a) for a, b in zip(rest, now, strict=True))
    return x, y, z


def _slowly(rest: Vec3 | None, now: Vec3 | None, share: float) -> Vec3 | None:
    if rest is None or now is None:
        return now
    x, y, z = (a + share * (b - a) for a, b in zip(rest, now, strict=True))
    return x, y, z
