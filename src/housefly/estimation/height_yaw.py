"""Height and yaw: two small constant-rate filters, the same in both modes, with the innovation gate for the whole pose."""

from __future__ import annotations

from housefly.estimation.drift_axis import Drift, drifted, seen
from housefly.messages import Pose
from housefly.numeric import wrapped

CLIMB_NOISE = 1.0
"""Unmodelled vertical acceleration [m/s^1.5]."""
TURN_NOISE = 2.0
"""Unmodelled yaw acceleration [rad/s^1.5]."""
YAW_PER_METRE = 3.0
"""Yaw noise over position noise [rad/m]: markers sit a third of a metre apart."""
BLIND_REACH = 0.3
"""Longest time that height and yaw are extrapolated [s]; the drone's own loops stop both soon."""
GATE_SIGMAS = 6.0
"""A sighting further off than this many standard deviations is a spike, unless it is closer than the floors below."""
GATE_FLOOR = 0.15
"""Never refuse a position closer than this [m]."""
GATE_FLOOR_YAW = 0.35
"""Never refuse a yaw closer than this [rad]."""


def plausible(distance_squared: float, variance: float, floor: float) -> bool:
    """Return whether an innovation is small enough to be believed."""
    return distance_squared <= max(GATE_SIGMAS * GATE_SIGMAS * variance, floor * floor)


class HeightAndYaw:
    """Height z [m] and heading psi [rad] with their rates."""

    def __init__(self, pose: Pose, at: float, position_noise: float) -> None:
        self._z_variance = position_noise**2
        self._yaw_variance = (YAW_PER_METRE * position_noise) ** 2
        self._z = Drift(pose.position[2], 0.0, self._z_variance, 0.0, 0.1)
        self._yaw = Drift(pose.yaw, 0.0, self._yaw_variance, 0.0, 0.1)
        self._doubts = self._z_variance, self._yaw_variance
        self._at = at

    def at(self, now: float) -> tuple[float, float, float]:
        """Return height [m], climb rate [m/s] and yaw [rad] now [s], extrapolated no further than ``BLIND_REACH``."""
        ahead = min(max(now - self._at, 0.0), BLIND_REACH)
        return self._z.x + ahead * self._z.v, self._z.v, wrapped(self._yaw.x + ahead * self._yaw.v)

    def believes(self, pose: Pose, captured_at: float, refusing: bool) -> bool:
        """Return whether height and yaw of a pose are where they can be; while refusing, the doubt does not grow."""
        z, yaw = self._predicted(captured_at)
        if not refusing:
            self._doubts = z.xx + self._z_variance, yaw.xx + self._yaw_variance
        rise, turn = pose.position[2] - z.x, wrapped(pose.yaw - yaw.x)
        return plausible(rise * rise, self._doubts[0], GATE_FLOOR) and plausible(turn * turn, self._doubts[1], GATE_FLOOR_YAW)

    def take(self, pose: Pose, captured_at: float) -> None:
        """Take in a pose captured at a time [s]."""
        z, yaw = self._predicted(captured_at)
        self._z = Drift(*seen(z, pose.position[2] - z.x, self._z_variance))
        self._yaw = Drift(*seen(yaw, wrapped(pose.yaw - yaw.x), self._yaw_variance))
        self._at = captured_at

    def _predicted(self, at: float) -> tuple[Drift, Drift]:
        dt = at - self._at
        return Drift(*drifted(self._z, 0.0, CLIMB_NOISE, dt)), Drift(*drifted(self._yaw, 0.0, TURN_NOISE, dt))
