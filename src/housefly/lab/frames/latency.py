"""How much later tracking says that the drone turned than the drone itself."""

from __future__ import annotations

import numpy as np

from housefly.lab.frames.samples import OnboardPoint, TrackedPoint
from housefly.numeric import FloatArray

LAG_MAX = 0.8
"""Longest delay that is looked for, either way [s]."""
_STEP = 0.01
_TURNING = 0.15
"""Faster than this the drone is being turned [rad/s]."""
_LEAST_TURN = 0.6
"""A smaller turn says nothing [rad]."""
_RESIDUAL_MAX = 0.15
"""With a worse fit than this the two do not tell of the same turn [rad]."""
_GAP_MAX = 0.4
"""With longer holes in a turn nothing can be said [s]."""


def tracking_lag(
    tracked: tuple[TrackedPoint, ...], onboard: tuple[OnboardPoint, ...]
) -> float | None:
    """Return the delay of tracking against the drone's own heading [s]; None when it is not known.

    A mirrored heading is the same turn the other way.

    Args:
        tracked: poses of the drone's body, oldest first.
        onboard: its reports over the same time, oldest first.
    """
    if len(tracked) < 10 or len(onboard) < 10:
        return None
    seen_at = np.array([point.at for point in tracked])
    said_at = np.array([point.at for point in onboard])
    psi = np.unwrap([point.psi for point in onboard])
    times = _turning_times(said_at, psi, seen_at[0], seen_at[-1])
    if times.size < 20:
        return None
    if _has_holes(seen_at, times) or _has_holes(said_at, times):
        return None
    said = np.interp(times, said_at, psi)
    yaw = np.unwrap([point.yaw for point in tracked])
    lags = np.arange(-LAG_MAX, LAG_MAX + _STEP / 2, _STEP)
    delayed = [np.interp(times + lag, seen_at, yaw) for lag in lags]
    residuals = [min(_spread(seen - said), _spread(seen + said)) for seen in delayed]
    best = int(np.argmin(residuals))
    return float(lags[best]) if residuals[best] < _RESIDUAL_MAX else None


def _turning_times(said_at: FloatArray, psi: FloatArray, first: float, last: float) -> FloatArray:
    """Return a grid of times around the turn, where both were heard; empty without a turn [s]."""
    grid = np.arange(said_at[0], said_at[-1], 10 * _STEP)
    heading = np.interp(grid, said_at, psi)
    turning = grid[1:][np.abs(np.diff(heading)) > _TURNING * 10 * _STEP]
    if turning.size == 0 or float(np.ptp(heading)) < _LEAST_TURN:
        return np.empty(0)
    start = max(turning[0] - 0.5, said_at[0], first + LAG_MAX)
    end = min(turning[-1] + 0.5, said_at[-1], last - LAG_MAX)
    return np.arange(start, end, _STEP)


def _has_holes(heard_at: FloatArray, times: FloatArray) -> bool:
    around = (heard_at >= times[0] - LAG_MAX) & (heard_at <= times[-1] + LAG_MAX)
    within = heard_at[around]
    return within.size < 2 or bool(np.max(np.diff(within)) > _GAP_MAX)


def _spread(values: FloatArray) -> float:
    return float(np.std(values))
