"""The position error left by tracking noise and gusts (discrete Lyapunov equation)."""

from __future__ import annotations

import numpy as np

from housefly.lab.tuning.loop import Loop, period_of
from housefly.numeric import FloatArray

_GUST = 0.1
"""One sigma of the push by moving air that the advice assumes [m/s^2]."""
_GUST_TIME = 1.0
"""Correlation time of the push [s]."""

_MAX_DOUBLINGS, _NEGLIGIBLE = 40, 1e-12
"""The sum ends when what is added is a smaller share than this; 2^40 periods are years."""


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
    covariance = _steady_covariance(period.matrix.real, added @ added.T)
    return float(np.sqrt(max(covariance[0, 0], 0.0)))


def _steady_covariance(matrix: FloatArray, added: FloatArray) -> FloatArray:
    """Return the sum of A^k Q A'^k over all k, doubled in length each round; A is stable."""
    covariance, power = added, matrix
    for _ in range(_MAX_DOUBLINGS):
        more = power @ covariance @ power.T
        covariance = covariance + more
        if np.abs(more).max() <= _NEGLIGIBLE * np.abs(covariance).max():
            break
        power = power @ power
    return covariance
