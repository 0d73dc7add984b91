"""One horizontal axis of mode default's Kalman filter, compiled.

    x' = v,  v' = a + d - drag v,  a' = lambda (gain u - a) + noise,  d' = noise

``a`` is what the tilt accelerates by: the lag state of paper eqs. (22)-(23), without which the
estimate is biased by the lag. ``d`` is whatever pushes steadily: wind, a bent frame, a floor that
is not level. Both axes see the same times and noises, so they share one transition and one
covariance, kept as the ten numbers of its upper triangle.
"""

from __future__ import annotations

from math import exp
from typing import NamedTuple

from housefly.numeric import clipped, compiled

HOVER_VARIANCE_FACTOR = 4.0
"""Variance of the unmodelled acceleration while the drone flies itself, as a multiple of that under
our command.
"""
DISTURBANCE_LIMIT = 1.0
"""Largest disturbance believed [m/s^2]."""
INITIAL_VELOCITY_VARIANCE = 0.05
"""Variance of the velocity before anything was seen [m^2/s^2]."""
INITIAL_DISTURBANCE = 0.2
"""One-sigma disturbance before anything was seen [m/s^2]."""


class AxisState(NamedTuple):
    """One world axis: position [m], velocity [m/s], tilt acceleration and disturbance [m/s^2]."""

    x: float
    v: float
    a: float
    d: float


class AxisCovariance(NamedTuple):
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
        wander: how fast the disturbance may change [m/s^2 per sqrt(s)]; 0 knows of none.
    """

    lag: float
    gain: float
    drag: float
    hover_drag: float
    noise: float
    wander: float


class Transition(NamedTuple):
    """What one step does to an axis: x += xv v + xa a + xd d + xu u, and so on.

    Attributes:
        xv, xa, xd, vv, va, vd, aa: entries of the transition matrix; xx and dd are 1, the others 0.
        xu, vu, au: what a commanded acceleration adds.
        noise_aa, noise_dd: variance that the step adds.
    """

    xv: float
    xa: float
    xd: float
    vv: float
    va: float
    vd: float
    aa: float
    xu: float
    vu: float
    au: float
    noise_aa: float
    noise_dd: float


@compiled
def transition(model: AxisModel, flown: bool, dt: float) -> Transition:
    """Return one step of dt [s]: midpoint rule in v, trapezoid in x, exact in a.

    When not ``flown`` (the drone hovers, lands or stands by itself) a command does not count, the
    drone brakes, and its own loops hold against disturbances.
    """
    drag = model.drag if flown else model.hover_drag
    heeded = 1.0 if flown else 0.0
    half = 0.5 * dt
    decay = exp(-model.lag * dt)
    reach = dt * (1.0 - half * drag)
    vv = 1.0 - drag * reach
    va = 0.5 * (1.0 + decay) * reach
    vd = heeded * reach
    au = heeded * model.gain * (1.0 - decay)
    vu = half * (1.0 - half * drag) * au
    variance = model.noise * model.noise * (1.0 if flown else HOVER_VARIANCE_FACTOR)
    return Transition(
        xv=half * (1.0 + vv),
        xa=half * va,
        xd=half * vd,
        vv=vv,
        va=va,
        vd=vd,
        aa=decay,
        xu=half * vu,
        vu=vu,
        au=au,
        noise_aa=variance * (1.0 - decay * decay),
        noise_dd=heeded * model.wander * model.wander * dt,
    )


@compiled
def initial_covariance(variance: float, noise: float, wander: float = 1.0) -> AxisCovariance:
    """Return the covariance at the first sighting, of its variance [m^2] and the model's noise.

    A disturbance that cannot wander is none.
    """
    disturbance = INITIAL_DISTURBANCE * INITIAL_DISTURBANCE if wander > 0.0 else 0.0
    return AxisCovariance(
        variance,
        0.0,
        0.0,
        0.0,
        INITIAL_VELOCITY_VARIANCE,
        0.0,
        0.0,
        noise * noise,
        0.0,
        disturbance,
    )


@compiled
def predicted_axis(axis: AxisState, u: float, step: Transition) -> AxisState:
    """Return the axis after one step with the commanded acceleration u [m/s^2] in force."""
    return AxisState(
        axis.x + step.xv * axis.v + step.xa * axis.a + step.xd * axis.d + step.xu * u,
        step.vv * axis.v + step.va * axis.a + step.vd * axis.d + step.vu * u,
        step.aa * axis.a + step.au * u,
        axis.d,
    )


@compiled
def predicted_covariance(p: AxisCovariance, step: Transition) -> AxisCovariance:
    """Return the covariance after one step: F P F' + Q."""
    fxx = p.xx + step.xv * p.xv + step.xa * p.xa + step.xd * p.xd
    fxv = p.xv + step.xv * p.vv + step.xa * p.va + step.xd * p.vd
    fxa = p.xa + step.xv * p.va + step.xa * p.aa + step.xd * p.ad
    fxd = p.xd + step.xv * p.vd + step.xa * p.ad + step.xd * p.dd
    fvv = step.vv * p.vv + step.va * p.va + step.vd * p.vd
    fva = step.vv * p.va + step.va * p.aa + step.vd * p.ad
    fvd = step.vv * p.vd + step.va * p.ad + step.vd * p.dd
    return AxisCovariance(
        fxx + step.xv * fxv + step.xa * fxa + step.xd * fxd,
        step.vv * fxv + step.va * fxa + step.vd * fxd,
        step.aa * fxa,
        fxd,
        step.vv * fvv + step.va * fva + step.vd * fvd,
        step.aa * fva,
        fvd,
        step.aa * step.aa * p.aa + step.noise_aa,
        step.aa * p.ad,
        p.dd + step.noise_dd,
    )


@compiled
def updated_axis(axis: AxisState, p: AxisCovariance, seen: float, r: float) -> AxisState:
    """Return the axis after a position measurement ``seen`` [m] of variance r [m^2]."""
    innovation = (seen - axis.x) / (p.xx + r)
    return AxisState(
        axis.x + p.xx * innovation,
        axis.v + p.xv * innovation,
        axis.a + p.xa * innovation,
        clipped(axis.d + p.xd * innovation, DISTURBANCE_LIMIT),
    )


@compiled
def updated_covariance(p: AxisCovariance, r: float) -> AxisCovariance:
    """Return the covariance after a position measurement of variance r [m^2]."""
    shrink = 1.0 / (p.xx + r)
    kx, kv, ka, kd = p.xx * shrink, p.xv * shrink, p.xa * shrink, p.xd * shrink
    return AxisCovariance(
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
