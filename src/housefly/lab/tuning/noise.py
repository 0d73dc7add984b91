"""The position error left by tracking noise and gusts (discrete Lyapunov equation)."""

from __future__ import annotations

import numpy as np

from housefly.errors import MissingPartError
from housefly.lab.tuning.loop import Loop, period_of

try:
    from scipy.linalg import solve_discrete_lyapunov
except ImportError as error:
    raise MissingPartError("scipy (gains)", "pip install 'housefly[lab]'") from error

_GUST = 0.1
"""One sigma of the push by moving air that the advice assumes [m/s^2]."""
_GUST_TIME = 1.0
"""Correlation time of the push [s]."""


def position_error(loop: Loop, noise: float) -> float:
    """Return one sigma of the position error [m] of a stable loop.

    Args:
        loop: with gains and filter.
        noise: one sigma of a tracked coordinate [m].
    """
    period = period_of(loop)
    ticks = period.noise.shape[1] - period.frames
    # White pushes with the gusts' spectral density at rest, 2 sigma^2 T.
    push = _GUST * np.sqrt(2.0 * _GUST_TIME / loop.rate_hz)
    sigmas = np.concatenate((np.full(period.frames, noise), np.full(ticks, push)))
    added = period.noise.real * sigmas
    covariance = solve_discrete_lyapunov(period.matrix.real, added @ added.T)
    return float(np.sqrt(max(covariance[0, 0], 0.0)))
