"""Where a trajectory begins, how often it is written down, and what is between."""

from __future__ import annotations

from typing import NamedTuple

from housefly.numeric import FloatArray, compiled

TICK = 0.02
"""Time between two rows of a trajectory [s]."""


class KinematicState(NamedTuple):
    """Where a trajectory begins.

    Attributes:
        place: [m], shape (3,).
        velocity: [m/s], shape (3,).
        acceleration: [m/s^2], shape (3,).
    """

    place: FloatArray
    velocity: FloatArray
    acceleration: FloatArray


@compiled
def hermite(p0: float, p1: float, m0: float, m1: float, u: float) -> float:
    """Return the cubic between two numbers with slopes m0 and m1 over the whole, at u in 0 .. 1."""
    v = 1.0 - u
    return v * v * ((1.0 + 2.0 * u) * p0 + u * m0) + u * u * ((1.0 + 2.0 * v) * p1 - v * m1)
