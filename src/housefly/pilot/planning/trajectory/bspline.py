"""Uniform cubic B-splines: a curve between its control points, smooth to the second derivative.

Each span lies in the hull of its four control points, so it stays in any box that holds them.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled_with_arrays

_BASIS = np.array([[1.0, 4.0, 1.0, 0.0], [-3.0, 0.0, 3.0, 0.0], [3.0, -6.0, 3.0, 0.0]]) / 6.0
_CUBIC = np.array([-1.0, 3.0, -3.0, 1.0]) / 6.0
_POWERS = np.vstack((_BASIS, _CUBIC))
"""Row n holds the shares of the four control points in the coefficient of u^n."""
_AT_END = np.array([[1.0, 1.0, 1.0, 1.0], [0.0, 1.0, 2.0, 3.0], [0.0, 0.0, 2.0, 6.0]])
"""The powers and their derivatives at the end of a span."""


def curve_points(points: FloatArray, per_span: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return places on a curve and its first and second derivatives by the span.

    Args:
        points: control points, shape (n, 3), n at least 4.
        per_span: places on each span; the end is one more.

    Returns:
        Three arrays of shape ((n - 3) * per_span + 1, 3).
    """
    places, first, second = (_placed(*shares, points) for shares in _shares(per_span))
    return places, first, second


@cache
def _shares(per_span: int) -> tuple[tuple[FloatArray, FloatArray], ...]:
    """Return the shares of four control points in places, slopes and bends of a span.

    For each those inside, shape (per_span, 4), and those at the end, shape (4,).
    """
    u = np.arange(per_span) / per_span
    one, nil = np.ones(per_span), np.zeros(per_span)
    powers = np.stack((one, u, u**2, u * u * u), axis=1)
    slopes = np.stack((nil, one, 2.0 * u, 3.0 * u**2), axis=1)
    bends = np.stack((nil, nil, 2.0 * one, 6.0 * u), axis=1)
    return tuple(
        (np.einsum("uk,kn->un", inside, _POWERS), np.einsum("k,kn->n", end, _POWERS))
        for inside, end in zip((powers, slopes, bends), _AT_END, strict=True)
    )


@compiled_with_arrays
def _placed(inside: Any, end: Any, points: Any) -> Any:
    """Return the points of all spans, shape (spans * per_span + 1, 3)."""
    spans, per_span = points.shape[0] - 3, inside.shape[0]
    placed = np.zeros((spans * per_span + 1, 3))
    for n in range(spans * per_span + 1):
        span, u = min(n // per_span, spans - 1), n % per_span
        for axis in range(3):
            for k in range(4):
                share = end[k] if n == spans * per_span else inside[u, k]
                placed[n, axis] += share * points[span + k, axis]
    return placed


def moving_start(
    place: FloatArray, direction: FloatArray, bend: FloatArray, stride: float
) -> FloatArray:
    """Return the first three control points of a curve that begins with a direction and a bend.

    Args:
        place: where it begins, shape (3,).
        direction: unit vector.
        bend: curvature vector, at right angles to it [1/m].
        stride: distance between control points [m].

    Returns:
        Shape (3, 3).
    """
    second = bend * stride * stride
    middle = place - second / 6.0
    ahead = direction * stride
    return np.stack((middle + second / 2.0 - ahead, middle, middle + second / 2.0 + ahead))
