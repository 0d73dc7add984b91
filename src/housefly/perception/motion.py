"""Constant-velocity Kalman filter of a thing in the plane, the same for x and y."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

from housefly.geometry import Vec2

_ACCELERATION_SIGMA = 1.5
"""One-sigma acceleration of people [m/s^2]."""
_POSITION_SIGMA = 0.05
"""One-sigma error of a cluster's centre [m]: the visible side changes as a thing turns."""
_START_SPEED_SIGMA = 1.0
"""One-sigma speed of a new thing [m/s]."""


@dataclass(frozen=True, slots=True)
class MotionState:
    """The filter's state; both axes share the covariance (pp, pv, vv).

    Attributes:
        at: time [s].
        position: [m].
        velocity: [m/s].
        pp, pv, vv: covariance of position and velocity of one axis.
    """

    at: float
    position: Vec2
    velocity: Vec2 = (0.0, 0.0)
    pp: float = _POSITION_SIGMA * _POSITION_SIGMA
    pv: float = 0.0
    vv: float = _START_SPEED_SIGMA * _START_SPEED_SIGMA

    @property
    def std(self) -> float:
        """One-sigma error of the position [m]."""
        return sqrt(self.pp)

    def position_at(self, at: float) -> Vec2:
        """Return the position predicted to a later time [m, s]."""
        dt = max(0.0, at - self.at)
        (x, y), (vx, vy) = self.position, self.velocity
        return x + vx * dt, y + vy * dt

    def predicted(self, at: float) -> MotionState:
        """Return the state predicted to a later time [s]."""
        dt = max(0.0, at - self.at)
        q = _ACCELERATION_SIGMA * _ACCELERATION_SIGMA
        pp = self.pp + dt * (2.0 * self.pv + dt * self.vv) + q * (dt * dt) ** 2 / 4.0
        pv = self.pv + dt * self.vv + q * dt * dt * dt / 2.0
        return MotionState(
            max(at, self.at),
            self.position_at(at),
            self.velocity,
            pp,
            pv,
            self.vv + q * dt * dt,
        )

    def updated(self, place: Vec2) -> MotionState:
        """Return the state updated with a position [m] measured at the state's own time."""
        gain = self.pp / (self.pp + _POSITION_SIGMA * _POSITION_SIGMA)
        gain_v = self.pv / (self.pp + _POSITION_SIGMA * _POSITION_SIGMA)
        off_x, off_y = place[0] - self.position[0], place[1] - self.position[1]
        position = (self.position[0] + gain * off_x, self.position[1] + gain * off_y)
        velocity = (self.velocity[0] + gain_v * off_x, self.velocity[1] + gain_v * off_y)
        return MotionState(
            self.at,
            position,
            velocity,
            (1.0 - gain) * self.pp,
            (1.0 - gain) * self.pv,
            self.vv - gain_v * self.pv,
        )
