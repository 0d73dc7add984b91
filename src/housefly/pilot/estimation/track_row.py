"""Rows of tracked and onboard way side by side, which the windows compare, compiled."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled
from housefly.pilot.estimation.flow_bias import FlowBias

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
