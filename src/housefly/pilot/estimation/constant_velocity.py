"""A constant-velocity Kalman filter, compiled: a value and its rate, and a known acceleration.

Serves height and yaw in both modes, and x and y in mode paper (state x, x', input = command, as in
paper V-D).
"""

from __future__ import annotations

from typing import NamedTuple

from housefly.numeric import compiled


class ConstantVelocity(NamedTuple):
    """A value and its rate, with the upper triangle of their covariance."""

    x: float
    v: float
    xx: float
    xv: float
    vv: float


@compiled
def cv_predicted(s: ConstantVelocity, a: float, noise: float, dt: float) -> ConstantVelocity:
    """Return the state after dt [s].

    Args:
        s: state before.
        a: known acceleration.
        noise: spectral density of the unknown acceleration, as its square root [unit / s^1.5].
        dt: step [s].
    """
    q = noise * noise
    return ConstantVelocity(
        s.x + dt * s.v + 0.5 * dt * dt * a,
        s.v + dt * a,
        s.xx + 2.0 * dt * s.xv + dt * dt * s.vv + q * dt * dt * dt / 3.0,
        s.xv + dt * s.vv + 0.5 * q * dt * dt,
        s.vv + q * dt,
    )


@compiled
def cv_updated(s: ConstantVelocity, innovation: float, r: float) -> ConstantVelocity:
    """Return the state after a measurement that differs by ``innovation`` and has variance r."""
    total = s.xx + r
    kx, kv = s.xx / total, s.xv / total
    return ConstantVelocity(
        s.x + kx * innovation, s.v + kv * innovation, r * kx, r * kv, s.vv - kv * s.xv
    )
