"""The Kalman filter as the paper describes it (V-D), compiled: state (x, x', y, y'), input =
commands, measurement on arrival.
"""

from __future__ import annotations

from typing import NamedTuple

from housefly.numeric import compiled
from housefly.pilot.estimation.constant_velocity import ConstantVelocity, cv_predicted, cv_updated
from housefly.pilot.estimation.height_yaw import POSITION_GATE_FLOOR, within_gate

PAPER_INITIAL_VELOCITY_VARIANCE = 0.1
"""Variance of the unknown velocity at the first sighting [m^2/s^2]."""


class PaperFilterState(NamedTuple):
    """Where the filter stands.

    Attributes:
        x, y: states of both axes now.
        ux, uy: commanded acceleration in force [m/s^2].
        at: now [s].
        doubt: variance by which the next sighting is judged [m^2].
    """

    x: ConstantVelocity
    y: ConstantVelocity
    ux: float
    uy: float
    at: float
    doubt: float


@compiled
def paper_filter_initialized(
    p: PaperFilterState, x: float, y: float, now: float, variance: float
) -> PaperFilterState:
    """Return the filter of a drone first seen at rest at (x, y) [m]; the command in force stays."""
    return PaperFilterState(
        ConstantVelocity(x, 0.0, variance, 0.0, PAPER_INITIAL_VELOCITY_VARIANCE),
        ConstantVelocity(y, 0.0, variance, 0.0, PAPER_INITIAL_VELOCITY_VARIANCE),
        p.ux,
        p.uy,
        now,
        p.doubt,
    )


@compiled
def paper_filter_advanced(p: PaperFilterState, noise: float, now: float) -> PaperFilterState:
    """Return the filter now [s]; ``noise`` is the acceleration that the model misses, as a spectral
    density [m/s^1.5].
    """
    dt = now - p.at
    if dt <= 0.0:
        return p
    return PaperFilterState(
        cv_predicted(p.x, p.ux, noise, dt),
        cv_predicted(p.y, p.uy, noise, dt),
        p.ux,
        p.uy,
        now,
        p.doubt,
    )


@compiled
def paper_filter_commanded(
    p: PaperFilterState, ux: float, uy: float, flown: bool
) -> PaperFilterState:
    """Return the filter under a new command: world acceleration [m/s^2], none when the drone flies
    itself.
    """
    return PaperFilterState(p.x, p.y, ux if flown else 0.0, uy if flown else 0.0, p.at, p.doubt)


@compiled
def paper_filter_gated(
    p: PaperFilterState, x: float, y: float, refusing: bool, variance: float
) -> tuple[bool, PaperFilterState]:
    """Return whether the drone can be at (x, y) [m], and the filter with its doubt; while refusing,
    the doubt does not grow.
    """
    doubt = p.doubt if refusing else p.x.xx + variance
    dx, dy = x - p.x.x, y - p.y.x
    return within_gate(dx * dx + dy * dy, doubt, POSITION_GATE_FLOOR), PaperFilterState(
        p.x, p.y, p.ux, p.uy, p.at, doubt
    )


@compiled
def paper_filter_updated(
    p: PaperFilterState, x: float, y: float, variance: float
) -> PaperFilterState:
    """Return the filter after a measurement (x, y) [m] of a variance [m^2], counted as being from
    now.
    """
    return PaperFilterState(
        cv_updated(p.x, x - p.x.x, variance),
        cv_updated(p.y, y - p.y.x, variance),
        p.ux,
        p.uy,
        p.at,
        p.doubt,
    )
