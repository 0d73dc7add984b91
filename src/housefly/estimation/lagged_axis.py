"""One horizontal axis of the Kalman filter as compiled scalar functions: position, velocity, tilt acceleration, disturbance.

    x' = v,  v' = a + d - drag v,  a' = lambda (gain u - a) + noise,  d' = noise

``a`` is what the tilt accelerates by: the lag state of paper eqs. (22)-(23), without which the estimate is biased by the lag.
``d`` is whatever pushes steadily: wind, a bent frame, a floor that is not level. Both axes see the same times and noises, so they
share one covariance, kept as the ten numbers of its upper triangle.
"""

from __future__ import annotations

from math import exp
from typing import NamedTuple

from housefly.numeric import clipped, compiled

HOVER_DOUBT = 4.0
"""Variance of the unmodelled acceleration while the drone flies itself, as a multiple of that under our command."""
DISTURBANCE_MAX = 1.0
"""Largest disturbance believed [m/s^2]."""


class Axis(NamedTuple):
    """State of one world axis: position [m], velocity [m/s], tilt acceleration [m/s^2], disturbance [m/s^2]."""

    x: float
    v: float
    a: float
    d: float


class Spread(NamedTuple):
    """Upper triangle of the covariance, rows and columns in the order of ``Axis``."""

    xx: float
    xv: float
    xa: float
    xd: float
    vv: float
    va: float
    vd: float
    aa: float
    ad: float
    dd: float


class AxisModel(NamedTuple):
    """Constants of the prediction.

    Attributes:
        lag: lambda [1/s].
        gain: c / lambda.
        drag: linear drag over mass [1/s].
        hover_drag: how quickly the drone's own hover brakes, in place of drag [1/s].
        noise: one-sigma acceleration that the model misses, correlated over 1 / lambda [m/s^2].
        wander: how fast the disturbance may change [m/s^2 per sqrt(s)].
    """

    lag: float
    gain: float
    drag: float
    hover_drag: float
    noise: float
    wander: float


@compiled
def _coefficients(model: AxisModel, flown: bool, dt: float) -> tuple[float, float, float, float, float, float, float]:
    """Return (decay, vv, va, vd, xv, xa, xd) of the transition matrix: midpoint rule in v, trapezoid in x, exact in a."""
    drag = model.drag if flown else model.hover_drag
    decay = exp(-model.lag * dt)
    reach = dt * (1.0 - 0.5 * drag * dt)
    vv = 1.0 - drag * reach
    va = 0.5 * (1.0 + decay) * reach
    vd = reach if flown else 0.0
    return decay, vv, va, vd, 0.5 * dt * (1.0 + vv), 0.5 * dt * va, 0.5 * dt * vd


@compiled
def predicted(axis: Axis, u: float, flown: bool, model: AxisModel, dt: float) -> Axis:
    """Return the axis after dt [s] with the commanded acceleration u [m/s^2] in force.

    When not ``flown`` (the drone hovers, lands or stands by itself) u does not count, the drone brakes, and its own loops hold
    against disturbances.
    """
    decay, vv, va, vd, xv, xa, xd = _coefficients(model, flown, dt)
    push = model.gain * u * (1.0 - decay) if flown else 0.0
    pushed_v = 0.5 * dt * (1.0 - 0.5 * model.drag * dt) * push
    return Axis(
        axis.x + xv * axis.v + xa * axis.a + xd * axis.d + 0.5 * dt * pushed_v,
        vv * axis.v + va * axis.a + vd * axis.d + pushed_v,
        decay * axis.a + push,
        axis.d,
    )


@compiled
def spread_out(p: Spread, flown: bool, model: AxisModel, dt: float) -> Spread:
    """Return the covariance after dt [s]: F P F' + Q."""
    decay, vv, va, vd, xv, xa, xd = _coefficients(model, flown, dt)
    fxx = p.xx + xv * p.xv + xa * p.xa + xd * p.xd
    fxv = p.xv + xv * p.vv + xa * p.va + xd * p.vd
    fxa = p.xa + xv * p.va + xa * p.aa + xd * p.ad
    fxd = p.xd + xv * p.vd + xa * p.ad + xd * p.dd
    fvv = vv * p.vv + va * p.va + vd * p.vd
    fva = vv * p.va + va * p.aa + vd * p.ad
    fvd = vv * p.vd + va * p.ad + vd * p.dd
    variance = model.noise * model.noise * (1.0 if flown else HOVER_DOUBT)
    return Spread(
        fxx + xv * fxv + xa * fxa + xd * fxd,
        vv * fxv + va * fxa + vd * fxd,
        decay * fxa,
        fxd,
        vv * fvv + va * fva + vd * fvd,
        decay * fva,
        fvd,
        decay * decay * p.aa + variance * (1.0 - decay * decay),
        decay * p.ad,
        p.dd + (model.wander * model.wander * dt if flown else 0.0),
    )


@compiled
def corrected(axis: Axis, p: Spread, seen: float, r: float) -> Axis:
    """Return the axis after a position measurement ``seen`` [m] of variance r [m^2]."""
    innovation = (seen - axis.x) / (p.xx + r)
    return Axis(
        axis.x + p.xx * innovation,
        axis.v + p.xv * innovation,
        axis.a + p.xa * innovation,
        clipped(axis.d + p.xd * innovation, DISTURBANCE_MAX),
    )


@compiled
def narrowed(p: Spread, r: float) -> Spread:
    """Return the covariance after a position measurement of variance r [m^2]."""
    s = p.xx + r
    kx, kv, ka, kd = p.xx / s, p.xv / s, p.xa / s, p.xd / s
    return Spread(
        r * kx,
        r * kv,
        r * ka,
        r * kd,
        p.vv - kv * p.xv,
        p.va - kv * p.xa,
        p.vd - kv * p.xd,
        p.aa - ka * p.xa,
        p.ad - ka * p.xd,
        p.dd - kd * p.xd,
    )
