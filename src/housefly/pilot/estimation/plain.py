"""The Kalman filter as the paper describes it (V-D), compiled: state (x, x', y, y'), input =
commands, measurement on arrival.
"""

from __future__ import annotations

from typing import NamedTuple

from housefly.numeric import compiled
from housefly.pilot.estimation.drift_axis import Drift, drifted, seen
from housefly.pilot.estimation.height_yaw import GATE_FLOOR, plausible

FIRST_VELOCITY_VARIANCE = 0.1
"""Variance of the unknown velocity at the first sighting [m^2/s^2]."""


class Plain(NamedTuple):
    """Where the filter stands.

    Attributes:
        x, y: states of both axes now.
        ux, uy: commanded acceleration in force [m/s^2].
        at: now [s].
        doubt: variance by which the next sighting is judged [m^2].
    """

    x: Drift
    y: Drift
    ux: float
    uy: float
    at: float
    doubt: float


@compiled
def plain_begun(p: Plain, x: float, y: float, now: float, variance: float) -> Plain:
    """Return the filter of a drone first seen at rest at (x, y) [m]; the command in force stays."""
    return Plain(
        Drift(x, 0.0, variance, 0.0, FIRST_VELOCITY_VARIANCE),
        Drift(y, 0.0, variance, 0.0, FIRST_VELOCITY_VARIANCE),
        p.ux,
        p.uy,
        now,
        p.doubt,
    )


@compiled
def plain_advanced(p: Plain, noise: float, now: float) -> Plain:
    """Return the filter now [s]; ``noise`` is the acceleration that the model misses, as a spectral
    density [m/s^1.5].
    """
    dt = now - p.at
    if dt <= 0.0:
        return p
    return Plain(
        drifted(p.x, p.ux, noise, dt), drifted(p.y, p.uy, noise, dt), p.ux, p.uy, now, p.doubt
    )


@compiled
def plain_commanded(p: Plain, ux: float, uy: float, flown: bool) -> Plain:
    """Return the filter under a new command: world acceleration [m/s^2], none when the drone flies
    itself.
    """
    return Plain(p.x, p.y, ux if flown else 0.0, uy if flown else 0.0, p.at, p.doubt)


@compiled
def plain_judged(
    p: Plain, x: float, y: float, refusing: bool, variance: float
) -> tuple[bool, Plain]:
    """Return whether the drone can be at (x, y) [m], and the filter with its doubt; while refusing,
    the doubt does not grow.
    """
    doubt = p.doubt if refusing else p.x.xx + variance
    dx, dy = x - p.x.x, y - p.y.x
    return plausible(dx * dx + dy * dy, doubt, GATE_FLOOR), Plain(p.x, p.y, p.ux, p.uy, p.at, doubt)


@compiled
def plain_measured(p: Plain, x: float, y: float, variance: float) -> Plain:
    """Return the filter after a measurement (x, y) [m] of a variance [m^2], counted as being from
    now.
    """
    return Plain(
        seen(p.x, x - p.x.x, variance), seen(p.y, y - p.y.x, variance), p.ux, p.uy, p.at, p.doubt
    )
