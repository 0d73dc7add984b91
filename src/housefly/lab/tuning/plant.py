"""The linear drone of one axis: position, velocity, tilt acceleration; exact between events."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

_SERIES_SHARE = 1e-18
"""The exponential series ends when a term is smaller than this; time times pole stays below 5."""


@lru_cache(maxsize=4096)
def _discrete(
    lag: float, drag: float, dt: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the matrix and input column of one step of dt [s].

    The system is x' = v, v' = a - drag v, a' = lag (u - a).
    """
    system = np.zeros((4, 4))
    system[0, 1] = dt
    system[1, 1:3] = -drag * dt, dt
    system[2, 2:] = -lag * dt, lag * dt
    step, term, order = np.eye(4), np.eye(4), 0
    while np.abs(term).max() > _SERIES_SHARE:
        order += 1
        term = term @ system / order
        step += term
    return step[:3, :3], step[:3, 3:]


def advanced(
    state: NDArray[Any], command: NDArray[Any], lag: float, drag: float, dt: float
) -> NDArray[Any]:
    """Return the rows of the state after dt [s] under a constant command.

    Args:
        state: rows of position, velocity and tilt acceleration, shape (3, n).
        command: row of the wanted acceleration, shape (n,).
        lag: lambda [1/s].
        drag: over mass [1/s].
        dt: [s].
    """
    matrix, column = _discrete(lag, drag, round(dt, 12))
    after: NDArray[Any] = matrix @ state + column * command
    return after
