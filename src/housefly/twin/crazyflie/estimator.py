"""What a Crazyflie without decks knows of its place: its accelerometer, and what it is told.

As the firmware's, it takes a pose as of now, however long that was on its way. Without poses it
goes on by the accelerometer alone, along an attitude that is a little off, and drifts.
"""

from __future__ import annotations

from math import exp

from housefly.geometry import GRAVITY, Vec3, quaternion_from_euler, rotate, wrap_angle
from housefly.twin.simulated_body import CONTROL_PERIOD, SensorReading

_BANDWIDTH = 15.0
"""How quickly it follows what it is told [rad/s]; critically damped."""
_HEADING_SHARE = 0.1
"""Share of what a told heading differs by that it takes over."""
_TOLD_ERROR, _UNTOLD_ERROR, _ATTITUDE_ERROR = 0.005, 1.0, 0.004
"""How far off it may be: told just now, and never [m]; its attitude [rad]."""
_GAP_MAX = 0.5
"""After a longer silence, what it is told is believed at once [s]."""


class PlaceEstimator:
    """Place, velocity and heading.

    Attributes:
        position: world [m]; zeros before it was told.
        velocity: world [m/s].
        yaw: heading [rad].
        is_told: whether it ever heard where it is.
    """

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Forget everything, as the parameter ``kalman.resetEstimation`` does."""
        self.position: Vec3 = (0.0, 0.0, 0.0)
        self.velocity: Vec3 = (0.0, 0.0, 0.0)
        self.yaw, self._offset = 0.0, 0.0
        self.is_told, self._told_at = False, 0.0

    def deviation(self, now: float) -> float:
        """Return by how much its place may be off now, one sigma [m]."""
        silent_for = max(0.0, now - self._told_at)
        drift = 0.5 * _ATTITUDE_ERROR * GRAVITY * silent_for * silent_for
        return _TOLD_ERROR + drift if self.is_told else _UNTOLD_ERROR

    def predict(self, measured: SensorReading) -> None:
        """Go on for a control period by the accelerometer."""
        self.yaw = wrap_angle(measured.psi + self._offset)
        if not self.is_told:
            return
        turned = quaternion_from_euler(measured.phi, measured.theta, self.yaw)
        ax, ay, az = rotate(turned, measured.acceleration)
        vx, vy, vz = self.velocity
        self.velocity = (
            vx + CONTROL_PERIOD * ax,
            vy + CONTROL_PERIOD * ay,
            vz + CONTROL_PERIOD * (az - GRAVITY),
        )
        self.position = _ahead(self.position, self.velocity, CONTROL_PERIOD)

    def tell(self, position: Vec3, yaw: float | None, psi: float, now: float) -> None:
        """Take in where it is.

        Args:
            position: world [m].
            yaw: heading [rad]; None where only the place is told.
            psi: heading by its gyros then [rad].
            now: [s].
        """
        dt, is_first = now - self._told_at, not self.is_told
        self.is_told, self._told_at = True, now
        if yaw is not None:
            share = 1.0 if is_first else _HEADING_SHARE
            self._offset = wrap_angle(self._offset + share * wrap_angle(yaw - psi - self._offset))
        if is_first or dt > _GAP_MAX:
            self.position = position
            self.velocity = (0.0, 0.0, 0.0) if is_first else self.velocity
            return
        if dt <= 0.0:
            return
        keep = exp(-_BANDWIDTH * dt)
        off = _minus(position, self.position)
        self.position = _ahead(self.position, off, 1.0 - keep * keep)
        self.velocity = _ahead(self.velocity, off, (1.0 - keep) * (1.0 - keep) / dt)


def _ahead(start: Vec3, way: Vec3, share: float) -> Vec3:
    x, y, z = (a + share * b for a, b in zip(start, way, strict=True))
    return x, y, z


def _minus(one: Vec3, other: Vec3) -> Vec3:
    x, y, z = (a - b for a, b in zip(one, other, strict=True))
    return x, y, z
