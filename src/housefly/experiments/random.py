"""Random numbers that belong to one drone alone: a counter mixed into bits (splitmix64, Steele, Lea and Flood 2014).

The state is the counter, one 64-bit number in an array of one, so a drone's numbers depend on its own seed and on nothing else.
"""

from __future__ import annotations

from math import cos, log, pi, sin, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled

State = NDArray[np.uint64]

STRIDE = np.uint64(0x9E3779B97F4A7C15)
FIRST, SECOND = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
S27, S30, S31, S11 = np.uint64(27), np.uint64(30), np.uint64(31), np.uint64(11)
UNIT = 1.0 / 9007199254740992.0
"""2 ** -53."""


@compiled
def mixed(bits: Any) -> Any:
    """Return 64 well mixed bits."""
    bits = (bits ^ (bits >> S30)) * FIRST
    bits = (bits ^ (bits >> S27)) * SECOND
    return bits ^ (bits >> S31)


@compiled
def sown(state: State, seed: int) -> None:
    """Start the numbers of a seed; neighbouring seeds have nothing in common."""
    state[0] = mixed(np.uint64(seed) * STRIDE + FIRST)


@compiled
def uniform(state: State) -> float:
    """Return the next number, evenly distributed over 0 (excluded) to 1."""
    state[0] += STRIDE
    return (float(mixed(state[0]) >> S11) + 0.5) * UNIT


@compiled
def exponential(state: State, mean: float) -> float:
    """Return the next number, exponentially distributed."""
    return -mean * log(uniform(state))


@compiled
def normals(state: State) -> tuple[float, float]:
    """Return the next two numbers of the standard normal distribution (Box and Muller)."""
    radius = sqrt(-2.0 * log(uniform(state)))
    angle = 2.0 * pi * uniform(state)
    return radius * cos(angle), radius * sin(angle)
