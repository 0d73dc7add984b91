"""How much older poses are than their stamps say, compiled.

A bank of lags: if the poses are late by one of them, then they agree with what the drone itself
told that much earlier. Place and heading count, and the height where the floor below is known; a
drone that hovers shows nothing.
"""

from __future__ import annotations

from math import isnan, nan
from typing import NamedTuple

import numpy as np

from housefly.numeric import FloatArray, compiled, wrapped
from housefly.pilot.estimation.onboard_odometry import (
    MotionRing,
    OdometryState,
    odometry_at,
)

LAG_STEP = 0.05
"""Step of the bank [s]."""
LAG_COUNT = 13
"""Lags tried: 0 to 0.6 s."""
LATENCY_TIME = 3.0
"""Time over which the lags are compared [s]."""
EXCITATION_MIN = 0.03
"""A lag must explain at least this much, one sigma [m]."""
EXPLAINED = 0.25
"""The best lag leaves at most this share of the variance."""
HEADING_ARM = 0.3
"""A turn of a radian counts as much as this way [m]."""
CHANNELS = 4
"""x, y, z, heading."""


class LatencyState(NamedTuple):
    """When the bank was fed last, and since when [s]; what it found [s]."""

    at: float
    since: float
    error: float


NO_LATENCY = LatencyState(at=nan, since=nan, error=nan)


def lag_bank() -> FloatArray:
    """Return an empty bank: mean and variance for each lag and channel."""
    return np.zeros((LAG_COUNT, CHANNELS, 2))


@compiled
def latency_advanced(
    s: LatencyState,
    bank: FloatArray,
    odometry: OdometryState,
    ring: MotionRing,
    at: float,
    x: float,
    y: float,
    z: float,
    yaw: float,
) -> LatencyState:
    """Return the latency after a sighting stamped with a time [s].

    Nothing is compared before the odometry reaches back by the longest lag. A height z that is nan
    does not count: over furniture the drone's own height is another one.
    """
    if odometry.since > at - (LAG_COUNT - 1) * LAG_STEP:
        return s
    is_first = isnan(s.at)
    weight = 1.0 if is_first else min((at - s.at) / LATENCY_TIME, 1.0)
    for lag in range(LAG_COUNT):
        then = odometry_at(odometry, ring, at - lag * LAG_STEP)
        _followed(bank, lag, 0, x - then.x, weight, is_first)
        _followed(bank, lag, 1, y - then.y, weight, is_first)
        _followed(bank, lag, 2, z - then.height, weight, is_first)
        turned = wrapped(yaw - odometry.heading - then.psi)
        _followed(bank, lag, 3, HEADING_ARM * turned, weight, is_first)
    since = at if is_first else s.since
    return LatencyState(at=at, since=since, error=_best_lag(bank))


@compiled
def _followed(
    bank: FloatArray, lag: int, channel: int, value: float, weight: float, is_first: bool
) -> None:
    if is_first or isnan(bank[lag, channel, 0]):
        bank[lag, channel, 0], bank[lag, channel, 1] = value, 0.0
        return
    off = 0.0 if isnan(value) else value - bank[lag, channel, 0]
    bank[lag, channel, 0] += weight * off
    bank[lag, channel, 1] = (1.0 - weight) * (bank[lag, channel, 1] + weight * off * off)


@compiled
def _best_lag(bank: FloatArray) -> float:
    """Return the lag that explains the poses best [s]; nan when no motion shows one."""
    best, least, most, unlagged = 0, 0.0, 0.0, 0.0
    for lag in range(LAG_COUNT):
        left = 0.0
        for channel in range(CHANNELS):
            left += bank[lag, channel, 1]
        if lag == 0 or left < least:
            best, least = lag, left
        most = max(most, left)
        unlagged = left if lag == 0 else unlagged
    if most - least < EXCITATION_MIN * EXCITATION_MIN or least > EXPLAINED * most:
        return nan
    if unlagged - least < EXCITATION_MIN * EXCITATION_MIN or least > EXPLAINED * unlagged:
        return 0.0
    return best * LAG_STEP
