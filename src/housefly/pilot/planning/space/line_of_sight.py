"""Straight lines through voxels: whether all voxels touched by one are free, and what it costs."""

from __future__ import annotations

from math import floor, sqrt
from typing import Any

from housefly.numeric import compiled

TOUCHED = 1e-6
"""Voxels closer to the line than this [voxel edges] count as touched."""


@compiled
def _span(a: float, b: float, low: float, high: float) -> tuple[float, float]:
    """Return for which shares of the way from a to b it lies between two numbers; (1, 0) never."""
    if abs(b - a) < TOUCHED:
        return (0.0, 1.0) if min(a, b) <= high and max(a, b) >= low else (1.0, 0.0)
    first, last = (low - a) / (b - a), (high - a) / (b - a)
    return max(min(first, last), 0.0), min(max(first, last), 1.0)


@compiled
def _cells_between(a: float, b: float, first: float, last: float) -> tuple[int, int]:
    """Return the first and last cell that the way from a to b touches between two shares of it."""
    u, v = a + (b - a) * first, a + (b - a) * last
    return floor(min(u, v) - TOUCHED), floor(max(u, v) + TOUCHED)


@compiled
def sees_in_space(
    free: Any, x0: float, y0: float, z0: float, x1: float, y1: float, z1: float
) -> bool:
    """Return whether all voxels touched by the closed segment are free.

    Its ends are seen from the lower corner of the map [voxel edges].
    """
    nx, ny, nz = free.shape
    i0, i1 = _cells_between(x0, x1, 0.0, 1.0)
    j0, j1 = _cells_between(y0, y1, 0.0, 1.0)
    k0, k1 = _cells_between(z0, z1, 0.0, 1.0)
    if i0 < 0 or j0 < 0 or k0 < 0 or i1 >= nx or j1 >= ny or k1 >= nz:
        return False
    for i in range(i0, i1 + 1):
        first, last = _span(x0, x1, i - TOUCHED, i + 1 + TOUCHED)
        if first > last:
            continue
        j0, j1 = _cells_between(y0, y1, first, last)
        for j in range(j0, j1 + 1):
            enter, leave = _span(y0, y1, j - TOUCHED, j + 1 + TOUCHED)
            enter, leave = max(enter, first), min(leave, last)
            if enter > leave:
                continue
            k0, k1 = _cells_between(z0, z1, enter, leave)
            for k in range(k0, k1 + 1):
                if not free[i, j, k]:
                    return False
    return True


@compiled
def line_cost(
    weights: Any, x0: float, y0: float, z0: float, x1: float, y1: float, z1: float
) -> float:
    """Return the cost [voxel edges] of a straight line: its length times one more than its mean
    weight.

    The weights are read every half voxel; an empty array weighs nothing.
    """
    dx, dy, dz = x1 - x0, y1 - y0, z1 - z0
    length = sqrt(dx * dx + dy * dy + dz * dz)
    if weights.size == 0 or length == 0.0:
        return length
    count, total = int(2.0 * length) + 1, 0.0
    for n in range(count):
        share = (n + 0.5) / count
        total += weights[int(x0 + share * dx), int(y0 + share * dy), int(z0 + share * dz)]
    return length * (1.0 + total / count)
