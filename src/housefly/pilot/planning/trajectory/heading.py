"""The heading along a trajectory: free, so it never holds a flight up.

The drone looks where it flies; it turns to what it came to see just in time to look at it on
arrival, no faster than a film can follow.
"""

from __future__ import annotations

from math import atan2, isfinite
from typing import Any

import numpy as np

from housefly.numeric import FloatArray, clipped, compiled, wrapped

_LOOKAHEAD = 0.5
"""It looks to where it flies after this time [s], so that turns begin before bends."""
_SLOW = 0.1
"""A slower motion has no direction to look to [m/s]."""


@compiled
def _fill_headings(
    motion: Any, tick: float, start_yaw: float, arrival_yaw: float, rate: float, out: Any
) -> None:
    n, ahead = motion.shape[0], int(_LOOKAHEAD / tick)
    yaw = start_yaw
    for k in range(n):
        at = min(k + ahead, n - 1)
        vx, vy = motion[at, 3], motion[at, 4]
        wish = atan2(vy, vx) if vx * vx + vy * vy > _SLOW * _SLOW else yaw
        left = rate * tick * (n - 1 - k)
        if isfinite(arrival_yaw) and abs(wrapped(arrival_yaw - yaw)) >= left - 2.0 * rate * tick:
            wish = arrival_yaw
        yaw = wrapped(yaw + clipped(wrapped(wish - yaw), rate * tick)) if k > 0 else yaw
        out[k] = yaw


def headings(
    motion: FloatArray, tick: float, start_yaw: float, arrival_yaw: float, rate: float
) -> FloatArray:
    """Return the heading at each row of a motion [rad], shape (n,).

    Args:
        motion: rows of a trajectory, shape (n, 9).
        tick: time between two of them [s].
        start_yaw: heading at the start [rad].
        arrival_yaw: wanted at the end [rad]; nan keeps that of the motion. In a short flight the
            turn goes on after the end.
        rate: how quickly the heading turns [rad/s].
    """
    out = np.empty(len(motion))
    _fill_headings(motion, tick, start_yaw, arrival_yaw, rate, out)
    return out
