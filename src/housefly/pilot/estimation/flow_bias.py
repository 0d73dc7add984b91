"""Kalman filter of the optical flow's bias while tracking is honest, compiled.

The bias wanders slowly: what the flow was off by in the last seconds tells what it will be off by
in the next ones, with two thirds of the error that its spread over a whole flight would leave, and
around what it is now. A drift of tracking that begins in between is no such thing.
"""

from __future__ import annotations

from math import cos, exp, sin, sqrt
from typing import NamedTuple

from housefly.numeric import compiled
from housefly.pilot.estimation.flow_model import FlowModel


class FlowBias(NamedTuple):
    """What the odometry is off by, along x and y with one covariance.

    Attributes:
        x, y: tracked minus onboard place [m].
        rate_x, rate_y: at which they part, the bias of the flow [m/s].
        variance: of the place [m^2].
        covariance: of place and rate [m^2/s].
        rate_variance: of the rate [m^2/s^2].
    """

    x: float
    y: float
    rate_x: float
    rate_y: float
    variance: float
    covariance: float
    rate_variance: float


@compiled
def first_bias(x: float, y: float, noise: float, flow: FlowModel) -> FlowBias:
    """Return what is known after one look, tracked minus onboard place (x, y) [m]."""
    return FlowBias(x, y, 0.0, 0.0, noise * noise, 0.0, flow.bias * flow.bias)


@compiled
def bias_predicted(
    b: FlowBias, seconds: float, turn: float, white: float, rate_change: float, flow: FlowModel
) -> FlowBias:
    """Return the bias after a time without a look.

    Args:
        b: the bias before.
        seconds: since then [s].
        turn: of the drone in it, which carries the flow's axes along [rad].
        white: variance that the place gained by white noise [m^2].
        rate_change: variance that the rate gained by a change of velocity [m^2/s^2].
        flow: what is known of the reported velocity.
    """
    tau = flow.bias_time
    keep = exp(-seconds / tau)
    reach = tau * (1.0 - keep)
    spread = flow.bias * flow.bias
    # Place and rate after a time, of a rate that is known at its beginning (Ornstein-Uhlenbeck).
    gained = spread * tau * tau * (2.0 * seconds / tau - 3.0 + 4.0 * keep - keep * keep)
    both = spread * tau * (1.0 - keep) * (1.0 - keep)
    ch, sh = cos(0.5 * turn), sin(0.5 * turn)
    mid_x, mid_y = ch * b.rate_x - sh * b.rate_y, sh * b.rate_x + ch * b.rate_y
    return FlowBias(
        x=b.x + reach * mid_x,
        y=b.y + reach * mid_y,
        rate_x=keep * (ch * mid_x - sh * mid_y),
        rate_y=keep * (sh * mid_x + ch * mid_y),
        variance=b.variance
        + 2.0 * reach * b.covariance
        + reach * reach * b.rate_variance
        + max(gained, 0.0)
        + white,
        covariance=keep * (b.covariance + reach * b.rate_variance) + both,
        rate_variance=keep * keep * b.rate_variance + spread * (1.0 - keep * keep) + rate_change,
    )


@compiled
def bias_updated(b: FlowBias, x: float, y: float, noise: float) -> FlowBias:
    """Return the bias after a look: tracked minus onboard place (x, y), one sigma of it [m]."""
    total = b.variance + noise * noise
    gain, rate_gain = b.variance / total, b.covariance / total
    dx, dy = x - b.x, y - b.y
    return FlowBias(
        x=b.x + gain * dx,
        y=b.y + gain * dy,
        rate_x=b.rate_x + rate_gain * dx,
        rate_y=b.rate_y + rate_gain * dy,
        variance=(1.0 - gain) * b.variance,
        covariance=(1.0 - gain) * b.covariance,
        rate_variance=b.rate_variance - rate_gain * b.covariance,
    )


@compiled
def parted_from(b: FlowBias, x: float, y: float) -> float:
    """Return how far a place (x, y) [m] is from where the bias expects it [m]."""
    return sqrt((x - b.x) ** 2 + (y - b.y) ** 2)
