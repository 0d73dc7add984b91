"""Random numbers of one drone alone: a counter mixed into bits (splitmix64, Steele 2014).

The state is the counter, one 64-bit number in an array of one, so a drone's numbers depend on its
own seed and on nothing else.
"""

from __future__ import annotations

from math import exp, log, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled

RandomState = NDArray[np.uint64]

STRIDE = np.uint64(0x9E3779B97F4A7C15)
FIRST, SECOND = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
S27, S30, S31, S11 = np.uint64(27), np.uint64(30), np.uint64(31), np.uint64(11)
UNIT = 1.0 / 9007199254740992.0
"""2 ** -53."""
LAYERS, LAST_LAYER = 128, np.uint64(127)
TAIL, AREA = 3.442619855899, 9.91256303526217e-3
"""Where the tail begins, and the area of a layer (Marsaglia and Tsang 2000)."""


def _edges() -> NDArray[np.float64]:
    """Return the right edges of the layers, outermost first, shape (LAYERS + 1,)."""
    edges = [AREA / exp(-0.5 * TAIL**2), TAIL]
    while len(edges) < LAYERS:
        edges.append(sqrt(-2.0 * log(AREA / edges[-1] + exp(-0.5 * edges[-1] ** 2))))
    return np.array([*edges, 0.0])


EDGES = _edges()


@compiled
def mixed(bits: Any) -> Any:
    """Return 64 well mixed bits."""
    bits = (bits ^ (bits >> S30)) * FIRST
    bits = (bits ^ (bits >> S27)) * SECOND
    return bits ^ (bits >> S31)


@compiled
def sown(state: RandomState, seed: int) -> None:
    """Start the numbers of a seed; neighbouring seeds have nothing in common."""
    state[0] = mixed(np.uint64(seed) * STRIDE + FIRST)


@compiled
def uniform(state: RandomState) -> float:
    """Return the next number, evenly distributed over 0 (excluded) to 1."""
    state[0] += STRIDE
    return (float(mixed(state[0]) >> S11) + 0.5) * UNIT


@compiled
def exponential(state: RandomState, mean: float) -> float:
    """Return the next number, exponentially distributed."""
    return -mean * log(uniform(state))


@compiled
def normal(state: RandomState) -> float:
    """Return the next number of the standard normal distribution (ziggurat, Doornik 2005).

    The area under the bell is cut into ``LAYERS`` of equal size; all but one draw in eighty fall
    into the part of their layer that lies under the bell whatever the height.
    """
    while True:
        state[0] += STRIDE
        bits = mixed(state[0])
        layer = int(bits & LAST_LAYER)
        x: float = (2.0 * float(bits >> S11) * UNIT - 1.0) * EDGES[layer]
        if abs(x) < EDGES[layer + 1]:
            return x
        if layer == 0:
            return _tail(state, x < 0.0)
        low, high = exp(-0.5 * EDGES[layer] ** 2), exp(-0.5 * EDGES[layer + 1] ** 2)
        if low + uniform(state) * (high - low) < exp(-0.5 * x * x):
            return x


@compiled
def _tail(state: RandomState, negative: bool) -> float:
    """Return a number beyond the last edge (Marsaglia 1964)."""
    while True:
        x, y = -log(uniform(state)) / TAIL, -log(uniform(state))
        if 2.0 * y > x * x:
            return -TAIL - x if negative else TAIL + x
