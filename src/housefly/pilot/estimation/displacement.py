"""Tracked displacement against the onboard one between two rows, compiled.

What the odometry may be off by is known: white noise, a wandering bias, and a share of the way.
"""

from __future__ import annotations

from math import exp, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled
from housefly.pilot.estimation.flow_bias import FlowBias, bias_predicted, first_bias, parted_from
from housefly.pilot.estimation.flow_model import FlowModel, flow_bias_variance

SIGMAS = 5.25
"""Displacements further apart than this many standard deviations disagree."""
AGREE_AGAIN = 0.6
"""Displacements closer than this share of the bound agree again."""
TIMING_ERROR = 0.01
"""Stamps and reports may be apart by this [s]: it counts while the velocity changes."""
BIAS_TURN_MAX = 1.0
"""A bias predicts nothing over a greater turn [rad]."""
LEARNING_TIME = 1.5
"""Time constant by which the bias of the flow is learned [s]."""
MANOEUVRE_ROWS = 10
"""Whether the velocity changes is seen over so many rows."""
MANOEUVRE_MIN, MANOEUVRE_USUAL = 0.085, 0.5
"""Velocities that differ by less are the flow's noise; usually they change by so much [m/s]."""

ROW_PERIOD = 0.05
"""Time between two rows [s]."""

WINDOW_RING_SIZE = 512
"""Rows kept: 25 s; a power of two."""
TRACK_ROW = np.dtype(
    [
        (name, "f8")
        for name in (
            *("at", "px", "py", "ox", "oy", "vx", "vy", "way", "variance", "yaw", "psi"),
            *("mean_vx", "mean_vy"),
            *("bx", "by", "rate_x", "rate_y", "b_variance", "b_covariance", "b_rate_variance"),
        )
    ]
)
"""Time of capture [s], tracked place and odometry [m], its velocity [m/s], way [m] and variance
[m^2], tracked and onboard heading, unwrapped [rad], the mean velocity of late [m/s], and the bias
that is known after this row (``FlowBias``).
"""
TrackRing = NDArray[Any]


class OdometryTolerance(NamedTuple):
    """What tracking and odometry may be off by.

    Attributes:
        position_noise: one sigma of a sighting [m].
        way_error: share of the way by which flow scale and heading may misjudge it.
        flow: what is known of the reported velocity.
    """

    position_noise: float
    way_error: float
    flow: FlowModel


@compiled
def speed_change(new: Any, row: Any) -> float:
    """Return how much the velocity differs between two rows [m/s]."""
    return float(sqrt((new.vx - row.vx) ** 2 + (new.vy - row.vy) ** 2))


@compiled
def displacement_bound(
    seconds: float, white: float, way: float, speed_change: float, tolerance: OdometryTolerance
) -> float:
    """Return how far tracked and onboard displacement may be apart [m].

    Args:
        seconds: between the two looks [s].
        white: variance of the odometry by white noise [m^2].
        way: flown in between [m].
        speed_change: between the two looks [m/s].
        tolerance: of tracking and odometry.
    """
    noise = tolerance.position_noise
    variance = white + flow_bias_variance(tolerance.flow, seconds) + 2.0 * noise * noise
    return SIGMAS * sqrt(variance) + tolerance.way_error * way + TIMING_ERROR * speed_change


@compiled
def parted(new: Any, row: Any, tolerance: OdometryTolerance, share: float) -> bool:
    """Return whether the two displacements since a row differ by this share of their bound."""
    dx = (new.px - new.ox) - (row.px - row.ox)
    dy = (new.py - new.oy) - (row.py - row.oy)
    change = speed_change(new, row)
    bound = displacement_bound(
        new.at - row.at, new.variance - row.variance, new.way - row.way, change, tolerance
    )
    return bool(dx * dx + dy * dy > (share * bound) ** 2)


@compiled
def learned_velocity(before: Any, new: Any) -> tuple[float, float]:
    """Return the velocity at which the bias after a new row was learned [m/s]."""
    keep = exp(-(new.at - before.at) / LEARNING_TIME)
    return new.vx + keep * (before.mean_vx - new.vx), new.vy + keep * (before.mean_vy - new.vy)


@compiled
def _unlearned_way(new: Any, row: Any, flow: FlowModel) -> float:
    """Return the way that the bias of a row knows nothing of [m].

    A bias that was learned at a constant velocity holds its share of the way already, less what it
    forgets: it is learned with a lag, and expected to fade.
    """
    seconds = new.at - row.at
    bend_x = new.ox - row.ox - seconds * row.mean_vx
    bend_y = new.oy - row.oy - seconds * row.mean_vy
    learning = sqrt((row.vx - row.mean_vx) ** 2 + (row.vy - row.mean_vy) ** 2)
    mean = sqrt(row.mean_vx * row.mean_vx + row.mean_vy * row.mean_vy)
    forgotten = (0.5 * seconds + LEARNING_TIME) / flow.bias_time
    way = sqrt(bend_x * bend_x + bend_y * bend_y)
    return float(way + seconds * (learning + forgotten * mean))


@compiled
def next_bias(earlier: Any, before: Any, new: Any, tolerance: OdometryTolerance) -> FlowBias:
    """Return the bias that the row before predicts for a new one, by one that is ten rows older.

    Timing errors and the share of the way come in one piece with a change of velocity, which is
    spread over its rows.
    """
    change = speed_change(new, earlier)
    share = (new.at - before.at) / (new.at - earlier.at)
    manoeuvre = MANOEUVRE_USUAL * share * max(change - MANOEUVRE_MIN, 0.0)
    return bias_predicted(
        known_bias(before),
        new.at - before.at,
        new.psi - before.psi,
        new.variance - before.variance + TIMING_ERROR * TIMING_ERROR * manoeuvre,
        tolerance.way_error * tolerance.way_error * manoeuvre,
        tolerance.flow,
    )


@compiled
def predicted_bias(row: Any, new: Any, flow: FlowModel) -> FlowBias:
    """Return the bias that a row predicts for a much newer one."""
    white = new.variance - row.variance
    return bias_predicted(known_bias(row), new.at - row.at, new.psi - row.psi, white, 0.0, flow)


@compiled
def predicted_bias_since(
    row: Any, new: Any, learned: bool, tolerance: OdometryTolerance
) -> FlowBias:
    """Return what a row predicts, by what was learned until then or by nothing."""
    if learned:
        return predicted_bias(row, new, tolerance.flow)
    noise, flow = tolerance.position_noise, tolerance.flow
    start = first_bias(row.px - row.ox, row.py - row.oy, noise, flow)
    return bias_predicted(start, new.at - row.at, 0.0, new.variance - row.variance, 0.0, flow)


@compiled
def parted_from_prediction(new: Any, row: Any, tolerance: OdometryTolerance) -> bool:
    """Return whether the displacements since a row differ by more than its bias predicts."""
    if abs(new.psi - row.psi) > BIAS_TURN_MAX:
        return False
    expected = predicted_bias(row, new, tolerance.flow)
    change = speed_change(new, row)
    bound = (
        expected_bound(expected, _unlearned_way(new, row, tolerance.flow), tolerance)
        + TIMING_ERROR * change
    )
    return way_parted(expected, new) > bound


@compiled
def way_parted(expected: FlowBias, new: Any) -> float:
    """Return how far tracked minus onboard place is from what was expected [m]."""
    return float(parted_from(expected, new.px - new.ox, new.py - new.oy))


@compiled
def expected_bound(expected: FlowBias, way: float, tolerance: OdometryTolerance) -> float:
    """Return how far from it that may be [m], with a way that may be misjudged [m]."""
    noise = tolerance.position_noise
    return SIGMAS * sqrt(expected.variance + noise * noise) + tolerance.way_error * way


@compiled
def known_bias(row: Any) -> FlowBias:
    """Return the bias that is known after a row."""
    return FlowBias(
        row.bx,
        row.by,
        row.rate_x,
        row.rate_y,
        row.b_variance,
        row.b_covariance,
        row.b_rate_variance,
    )


@compiled
def keep_bias(row: Any, bias: FlowBias) -> None:
    """Write the bias that is known after a row into it."""
    row.bx, row.by, row.rate_x, row.rate_y = bias.x, bias.y, bias.rate_x, bias.rate_y
    row.b_variance, row.b_covariance = bias.variance, bias.covariance
    row.b_rate_variance = bias.rate_variance
