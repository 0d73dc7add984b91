"""How the drone leans when the attitude that it reports stands still: tracking sees that.

A drone whose attitude hangs turns at a rate as large as what it is asked for differs from what it
tells. Asked for so much more as it leans less than it tells, it leans as it should again.
"""

from __future__ import annotations

from math import inf, isfinite, nan

from housefly.geometry import Quaternion, Vec2, euler_from_quaternion
from housefly.pilot.estimation.onboard_odometry import OnboardReport

STUCK_AFTER = 0.15
"""An attitude that is the same to the last bit for so long, while the speed changes, hangs [s]."""
SEEN_MAX = 0.15
"""An older sighting does not tell how the drone leans now [s]."""
LEARNED_TIME = 2.0
"""Time constant with which it is learned by what tracking and report differ anyway [s]."""
_STEP_MAX = 0.1

Attitude = tuple[float, float, float]


class LeanWatch:
    """Watches the attitude that one drone reports.

    Attributes:
        is_stuck: it stands still in the air.
    """

    def __init__(self) -> None:
        self._told: Attitude = (nan, nan, nan)
        self._speed: Vec2 = (nan, nan)
        self._told_since = inf
        self._changes = 0
        self._seen: Vec2 | None = None
        self._seen_at = -inf
        self._usual: Vec2 = (0.0, 0.0)
        self.is_stuck = False

    def feel(self, report: OnboardReport) -> None:
        """Take in a report."""
        told, speed = (report.theta, report.phi, report.psi), (report.forward, report.left)
        if told != self._told:
            self._told_since, self._changes = report.at, 0
        elif speed != self._speed:
            self._changes += 1
        self._told, self._speed = told, speed
        hangs = self._changes > 1 and report.at - self._told_since >= STUCK_AFTER
        self.is_stuck = report.airborne and hangs and any(told[:2])

    def see(self, at: float, orientation: Quaternion) -> None:
        """Take in how tracking saw it lean at a time [s]."""
        phi, theta, _ = euler_from_quaternion(orientation)
        if not self.is_stuck and isfinite(self._told[0]):
            share = min(max(at - self._seen_at, 0.0), _STEP_MAX) / LEARNED_TIME
            off = self._told[0] - theta - self._usual[0], self._told[1] - phi - self._usual[1]
            self._usual = self._usual[0] + share * off[0], self._usual[1] + share * off[1]
        self._seen, self._seen_at = (theta, phi), at

    def missing(self, now: float) -> Vec2 | None:
        """Return by how much more the drone has to be asked to lean, theta and phi [rad].

        None where its attitude is told, or nobody has seen it of late [s].
        """
        if not self.is_stuck or self._seen is None or now - self._seen_at > SEEN_MAX:
            return None
        theta, phi = self._seen
        return self._told[0] - theta - self._usual[0], self._told[1] - phi - self._usual[1]
