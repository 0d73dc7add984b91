"""The vertical axis with what pushes it: a Kalman filter of height, climb rate and lift, compiled.

    z' = w,  w' = p (u - w) + d + noise,  d' = noise

``u`` is the commanded climb rate, ``p`` the pole of the drone's answer and ``d`` the lift that
nobody commanded: a load, a light battery pack, an updraught. At rest the drone climbs at d / p
beside its command. Derivation: ``docs/flight.md``.
"""

from __future__ import annotations

from math import exp
from typing import NamedTuple

from housefly.numeric import clipped, compiled

LIFT_LIMIT = 1.5
"""Largest lift believed [m/s^2]: 15 % of the weight."""
INITIAL_LIFT = 0.2
"""One-sigma lift before anything was seen [m/s^2]."""
INITIAL_CLIMB_VARIANCE = 0.1
"""Variance of the climb rate before anything was seen [m^2/s^2]."""
HOVER_CLIMB_NOISE = 1.0
"""Unmodelled vertical acceleration while the drone flies itself [m/s^1.5]."""


class ClimbModel(NamedTuple):
    """Constants of the prediction.

    Attributes:
        pole: of the climb rate response [1/s].
        sink_gain: what the drone makes of a commanded sinking, over what was commanded.
        noise: unmodelled vertical acceleration under our command [m/s^1.5].
        wander: how fast the lift may change [m/s^2 per sqrt(s)]; 0 switches the filter off.
    """

    pole: float
    sink_gain: float
    noise: float
    wander: float


class ClimbAxis(NamedTuple):
    """Height [m], climb rate [m/s], lift [m/s^2]."""

    z: float
    w: float
    d: float


class ClimbCovariance(NamedTuple):
    """Upper triangle of the covariance, rows and columns in the order of ``ClimbAxis``."""

    zz: float
    zw: float
    zd: float
    ww: float
    wd: float
    dd: float


class ClimbStep(NamedTuple):
    """What one step does: z += zw w + zd d + zu u, w = ww w + wd d + wu u, d = d.

    Attributes:
        zw, zd, ww, wd: entries of the transition matrix; zz and dd are 1, the others 0.
        zu, wu: what a commanded climb rate adds.
        noise_zz, noise_zw, noise_ww, noise_dd: covariance that the step adds.
    """

    zw: float
    zd: float
    ww: float
    wd: float
    zu: float
    wu: float
    noise_zz: float
    noise_zw: float
    noise_ww: float
    noise_dd: float


@compiled
def first_climb_covariance(variance: float) -> ClimbCovariance:
    """Return the covariance at the first sighting, of its variance [m^2]."""
    lift = INITIAL_LIFT * INITIAL_LIFT
    return ClimbCovariance(variance, 0.0, 0.0, INITIAL_CLIMB_VARIANCE, 0.0, lift)


@compiled
def climb_step(model: ClimbModel, flown: bool, dt: float) -> ClimbStep:
    """Return one step of dt [s], exact for a steady command and lift.

    When not ``flown`` the drone's own loops hold the height: the rate is unknown, the lift stays.
    """
    noise = model.noise if flown else HOVER_CLIMB_NOISE
    q = noise * noise
    zz, zw, ww = q * dt * dt * dt / 3.0, 0.5 * q * dt * dt, q * dt
    if not flown:
        return ClimbStep(dt, 0.0, 1.0, 0.0, 0.0, 0.0, zz, zw, ww, 0.0)
    decay = exp(-model.pole * dt)
    gone = 1.0 - decay
    reach = gone / model.pole
    return ClimbStep(
        zw=reach,
        zd=(dt - reach) / model.pole,
        ww=decay,
        wd=reach,
        zu=dt - reach,
        wu=gone,
        noise_zz=zz,
        noise_zw=zw,
        noise_ww=ww,
        noise_dd=model.wander * model.wander * dt,
    )


@compiled
def climb_answer(model: ClimbModel, commanded: float) -> float:
    """Return the climb rate that the drone makes of a commanded one [m/s]."""
    return commanded if commanded >= 0.0 else model.sink_gain * commanded


@compiled
def predicted_climb(axis: ClimbAxis, u: float, step: ClimbStep) -> ClimbAxis:
    """Return the axis after one step with the climb rate u [m/s] in force."""
    return ClimbAxis(
        axis.z + step.zw * axis.w + step.zd * axis.d + step.zu * u,
        step.ww * axis.w + step.wd * axis.d + step.wu * u,
        axis.d,
    )


@compiled
def predicted_climb_covariance(p: ClimbCovariance, step: ClimbStep) -> ClimbCovariance:
    """Return the covariance after one step: F P F' + Q."""
    fzz = p.zz + step.zw * p.zw + step.zd * p.zd
    fzw = p.zw + step.zw * p.ww + step.zd * p.wd
    fzd = p.zd + step.zw * p.wd + step.zd * p.dd
    fww = step.ww * p.ww + step.wd * p.wd
    fwd = step.ww * p.wd + step.wd * p.dd
    return ClimbCovariance(
        fzz + step.zw * fzw + step.zd * fzd + step.noise_zz,
        step.ww * fzw + step.wd * fzd + step.noise_zw,
        fzd,
        step.ww * fww + step.wd * fwd + step.noise_ww,
        fwd,
        p.dd + step.noise_dd,
    )


@compiled
def updated_climb(axis: ClimbAxis, p: ClimbCovariance, seen: float, r: float) -> ClimbAxis:
    """Return the axis after a height ``seen`` [m] of variance r [m^2]."""
    innovation = (seen - axis.z) / (p.zz + r)
    return ClimbAxis(
        axis.z + p.zz * innovation,
        axis.w + p.zw * innovation,
        clipped(axis.d + p.zd * innovation, LIFT_LIMIT),
    )


@compiled
def updated_climb_covariance(p: ClimbCovariance, r: float) -> ClimbCovariance:
    """Return the covariance after a height of variance r [m^2]."""
    shrink = 1.0 / (p.zz + r)
    kz, kw, kd = p.zz * shrink, p.zw * shrink, p.zd * shrink
    return ClimbCovariance(
        r * kz, r * kw, r * kd, p.ww - kw * p.zw, p.wd - kw * p.zd, p.dd - kd * p.zd
    )
