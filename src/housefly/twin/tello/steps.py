"""How a simulated Tello flies the steps of its SDK: so far ahead, so far up, so much around.

It reckons by its own speed, as a real one does, and stops where it believes to have arrived.
"""

from __future__ import annotations

from math import copysign, cos, hypot, radians, sin

from housefly.geometry import Vec3, wrap_angle
from housefly.messages import VelocitySetpoint
from housefly.twin.contracts import OnboardState
from housefly.wires.tello.conversions import FullSticks
from housefly.wires.tello.lines import Direction, Go, Step

_GAIN = 1.2
"""Speed per way that is left [1/s]."""
_NEAR, _SLOW, _TURNED = 0.05, 0.12, 0.03
"""Arrived: so near [m], so slow [m/s], turned so far [rad]."""
_TIME_MAX = 20.0
"""A step that takes longer has failed [s]."""
_WAYS: dict[Direction, Vec3] = {
    Direction.FORWARD: (1.0, 0.0, 0.0),
    Direction.BACK: (-1.0, 0.0, 0.0),
    Direction.LEFT: (0.0, 1.0, 0.0),
    Direction.RIGHT: (0.0, -1.0, 0.0),
    Direction.UP: (0.0, 0.0, 1.0),
    Direction.DOWN: (0.0, 0.0, -1.0),
}


class Flown:
    """One step on its way.

    Args:
        step: what was asked.
        speed: of it [m/s].
        full: what the drone can do.
        onboard: where it begins.
    """

    def __init__(
        self, step: Step | Go, speed: float, full: FullSticks, onboard: OnboardState
    ) -> None:
        self._left, self._turn = _way_of(step), _turn_of(step)
        self._speed, self._full = speed, full
        self._began = self._at = onboard.at
        self._psi, self._start = onboard.psi, onboard.psi
        self.has_failed = False

    def velocity(self, onboard: OnboardState) -> VelocitySetpoint | None:
        """Return what to fly now, or None once it has arrived, or has failed."""
        forward, left, climb = onboard.velocity
        dt, self._at = onboard.at - self._at, onboard.at
        self._turn -= wrap_angle(onboard.psi - self._psi)
        self._psi = onboard.psi
        heading = wrap_angle(onboard.psi - self._start)
        c, s = cos(heading), sin(heading)
        x, y, z = self._left
        x, y, z = (
            x - dt * (c * forward - s * left),
            y - dt * (s * forward + c * left),
            z - dt * climb,
        )
        self._left = x, y, z
        self.has_failed = onboard.at - self._began > _TIME_MAX
        is_there = hypot(x, y, z) < _NEAR and abs(self._turn) < _TURNED
        if self.has_failed or (is_there and hypot(forward, left, climb) < _SLOW):
            return None
        vx, vy = _bounded((_GAIN * x, _GAIN * y), self._speed)
        return VelocitySetpoint(
            forward=c * vx + s * vy,
            left=c * vy - s * vx,
            vz=_clipped(_GAIN * z, min(self._speed, self._full.climb)),
            yaw_rate=_clipped(2.0 * self._turn, self._full.turn),
        )


def _way_of(step: Step | Go) -> Vec3:
    """Return forward, left, up [m]."""
    if isinstance(step, Go):
        return step.x / 100.0, step.y / 100.0, step.z / 100.0
    x, y, z = _WAYS.get(step.direction, (0.0, 0.0, 0.0))
    metres = step.amount / 100.0
    return x * metres, y * metres, z * metres


def _turn_of(step: Step | Go) -> float:
    """Return how far it turns, counter-clockwise [rad]."""
    if isinstance(step, Go) or not step.direction.turns:
        return 0.0
    sign = -1.0 if step.direction is Direction.CLOCKWISE else 1.0
    return copysign(radians(step.amount), sign)


def _bounded(vector: tuple[float, float], bound: float) -> tuple[float, float]:
    length = hypot(*vector)
    share = 1.0 if length <= bound else bound / length
    return share * vector[0], share * vector[1]


def _clipped(value: float, bound: float) -> float:
    return max(-bound, min(bound, value))
