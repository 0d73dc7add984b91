"""The paper's Kalman filter (V-D), compiled: (x, x', y, y'), measurements as of their arrival."""

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
        innovation_variance: by which the next sighting is judged [m^2].
    """

    x: ConstantVelocity
    y: ConstantVelocity
    ux: float
    uy: float
    at: float
    innovation_variance: float


@compiled
def paper_filter_initialized(
    p: PaperFilterState, x: float, y: float, now: float, variance: float
) -> PaperFilterState:
    """Return the filter of a drone first seen at rest at (x, y) [m]; the command stays."""
    return PaperFilterState(
        x=ConstantVelocity(x, 0.0, variance, 0.0, PAPER_INITIAL_VELOCITY_VARIANCE),
        y=ConstantVelocity(y, 0.0, variance, 0.0, PAPER_INITIAL_VELOCITY_VARIANCE),
        ux=p.ux,
        uy=p.uy,
        at=now,
        innovation_variance=p.innovation_variance,
    )


@compiled
def paper_filter_advanced(p: PaperFilterState, noise: float, now: float) -> PaperFilterState:
    """Return the filter now [s]; noise is the spectral density of what it misses [m/s^1.5]."""
    dt = now - p.at
    if dt <= 0.0:
        return p
    return PaperFilterState(
        x=cv_predicted(p.x, p.ux, noise, dt),
        y=cv_predicted(p.y, p.uy, noise, dt),
        ux=p.ux,
        uy=p.uy,
        at=now,
        innovation_variance=p.innovation_variance,
    )


@compiled
def paper_filter_commanded(
    p: PaperFilterState, ux: float, uy: float, flown: bool
) -> PaperFilterState:
    """Return the filter under a world acceleration [m/s^2]; none when the drone flies itself."""
    return PaperFilterState(
        x=p.x,
        y=p.y,
        ux=ux if flown else 0.0,
        uy=uy if flown else 0.0,
        at=p.at,
        innovation_variance=p.innovation_variance,
    )


@compiled
def paper_filter_gated(
    p: PaperFilterState, x: float, y: float, rejecting: bool, variance: float
) -> tuple[bool, PaperFilterState]:
    """Return whether the drone can be at (x, y) [m], and the filter that judged so.

    While sightings are rejected the variance does not grow: any jump would pass in the end.
    """
    innovation_variance = p.innovation_variance if rejecting else p.x.xx + variance
    dx, dy = x - p.x.x, y - p.y.x
    is_near = within_gate(dx * dx + dy * dy, innovation_variance, POSITION_GATE_FLOOR)
    return is_near, PaperFilterState(
        x=p.x, y=p.y, ux=p.ux, uy=p.uy, at=p.at, innovation_variance=innovation_variance
    )


@compiled
def paper_filter_updated(
    p: PaperFilterState, x: float, y: float, variance: float
) -> PaperFilterState:
    """Return the filter after a measurement (x, y) [m] of a variance [m^2], taken as from now."""
    return PaperFilterState(
        x=cv_updated(p.x, x - p.x.x, variance),
        y=cv_updated(p.y, y - p.y.x, variance),
        ux=p.ux,
        uy=p.uy,
        at=p.at,
        innovation_variance=p.innovation_variance,
    )
