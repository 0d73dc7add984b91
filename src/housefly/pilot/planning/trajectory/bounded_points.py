"""Control points that bend a curve as little as their boxes allow, compiled.

Along each axis by itself: the least sum of squared second differences, and a little of the first,
between bounds. The matrix has two bands on each side, so a solution with given points held at their
bounds takes one sweep there and back; the points to hold are found by block principal pivoting
(Judice and Pires 1994): all that are wrong change sides at once as long as that makes them fewer,
else the last of them alone, which comes to an end for every strictly convex sum. Every answer lies
between the bounds, found or not.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled, compiled_with_arrays

_FREE, _LOW, _HIGH = 0, 1, 2
_EQUAL = 1e-9
_SWEEPS = 600
"""The set of held points is sought for so long; some ten sweeps are usual."""
_BLOCKS = 8
"""So often all change sides although they do not become fewer."""


@compiled
def _solved(d: Any, e: Any, f: Any, b: Any) -> None:
    """Solve a symmetric system with diagonals d, e, f (first, second and third); into ``b``."""
    n = d.size
    for i in range(n):
        if i >= 1:
            d[i] -= e[i - 1] * e[i - 1] * d[i - 1]
        if i >= 2:
            d[i] -= f[i - 2] * f[i - 2] * d[i - 2]
        if i + 1 < n:
            if i >= 1:
                e[i] -= f[i - 1] * d[i - 1] * e[i - 1]
            e[i] /= d[i]
        if i + 2 < n:
            f[i] /= d[i]
        if i >= 1:
            b[i] -= e[i - 1] * b[i - 1]
        if i >= 2:
            b[i] -= f[i - 2] * b[i - 2]
    for i in range(n - 1, -1, -1):
        b[i] /= d[i]
        if i + 1 < n:
            b[i] -= e[i] * b[i + 1]
        if i + 2 < n:
            b[i] -= f[i] * b[i + 2]


@compiled_with_arrays
def bounded_points(low: FloatArray, high: FloatArray, pull: float) -> FloatArray:
    """Return the numbers between two bounds that bend least, shape (n,).

    Args:
        low: lower bounds, shape (n,), n at least 3; equal ones hold a point.
        high: upper bounds.
        pull: weight of the squared first differences.
    """
    n = low.size
    h0, h1, h2 = np.zeros(n), np.zeros(n), np.zeros(n)
    for i in range(n - 2):
        h0[i] += 1.0
        h0[i + 1] += 4.0
        h0[i + 2] += 1.0
        h1[i] -= 2.0
        h1[i + 1] -= 2.0
        h2[i] += 1.0
    for i in range(n - 1):
        h0[i] += pull
        h0[i + 1] += pull
        h1[i] -= pull
    h0 += 1e-9
    held = np.zeros(n, dtype=np.int8)
    for i in range(n):
        held[i] = _LOW if high[i] - low[i] < _EQUAL else _FREE
    x = 0.5 * (low + high)
    fewest, blocks = n + 1, _BLOCKS
    for _ in range(_SWEEPS):
        d, e, f, b = h0.copy(), h1.copy(), h2.copy(), np.zeros(n)
        for i in range(n):
            if held[i]:
                x[i] = high[i] if held[i] == _HIGH else low[i]
        for i in range(n):
            if held[i]:
                d[i], b[i] = 1.0, x[i]
            else:
                for j in range(max(0, i - 2), min(n, i + 3)):
                    if held[j]:
                        apart = abs(i - j)
                        first = min(i, j)
                        b[i] -= (h1[first] if apart == 1 else h2[first]) * x[j]
        for i in range(n - 1):
            if held[i] or held[i + 1]:
                e[i] = 0.0
            if i + 2 < n and (held[i] or held[i + 2]):
                f[i] = 0.0
        _solved(d, e, f, b)
        wrong, last, side = 0, -1, held.copy()
        for i in range(n):
            if high[i] - low[i] < _EQUAL:
                continue
            slope = h0[i] * b[i]
            for j in range(max(0, i - 2), min(n, i + 3)):
                if j != i:
                    slope += (h1[min(i, j)] if abs(i - j) == 1 else h2[min(i, j)]) * b[j]
            if held[i] == _FREE:
                side[i] = _LOW if b[i] < low[i] - _EQUAL else _FREE
                side[i] = _HIGH if b[i] > high[i] + _EQUAL else side[i]
            elif (held[i] == _LOW and slope < -_EQUAL) or (held[i] == _HIGH and slope > _EQUAL):
                side[i] = _FREE
            if side[i] != held[i]:
                wrong, last = wrong + 1, i
        x = b
        if wrong == 0:
            break
        blocks = _BLOCKS if wrong < fewest else blocks - 1
        fewest = min(fewest, wrong)
        if blocks > 0:
            held = side
        else:
            held[last] = side[last]
    return np.minimum(np.maximum(x, low), high)
