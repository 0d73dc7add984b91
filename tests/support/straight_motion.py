"""A motion in space that is known in closed form."""

from __future__ import annotations

import numpy as np

from housefly.numeric import FloatArray
from housefly.pilot.planning.trajectory.timing import TICK


def straight(length: float, seconds: float, height: float = 0.0) -> FloatArray:
    """Return a smooth motion from rest to rest along x, climbing by a height, shape (n, 9)."""
    share = np.linspace(0.0, 1.0, max(2, round(seconds / TICK) + 1))
    span = TICK * (len(share) - 1)
    place = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
    speed = 30.0 * share**2 * (1.0 - share) ** 2 / span
    push = 60.0 * share * (1.0 - share) * (1.0 - 2.0 * share) / span**2
    ends = np.array([length, 0.0, height])
    parts = [np.outer(one, ends) for one in (place, speed, push)]
    parts[0][:, 2] += 1.1
    return np.hstack(parts)
