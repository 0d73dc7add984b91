"""Uniform cubic B-splines: a curve between its control points, smooth to the second derivative.

Each span lies in the hull of its four control points, so it stays in any box that holds them.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from housefly.numeric import FloatArray

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
    u = np.arange(per_span) / per_span
    one, nil = np.ones(per_span), np.zeros(per_span)
    powers = np.stack((one, u, u**2, u**3), axis=1)
    slopes = np.stack((nil, one, 2.0 * u, 3.0 * u**2), axis=1)
    bends = np.stack((nil, nil, 2.0 * one, 6.0 * u), axis=1)
    windows = np.lib.stride_tricks.sliding_window_view(points, 4, axis=0)
    inside = (_placed(coefficients @ _POWERS, windows) for coefficients in (powers, slopes, bends))
    places, first, second = (
        np.vstack((body, (end @ _POWERS) @ windows[-1].T))
        for body, end in zip(inside, _AT_END, strict=True)
    )
    return places, first, second


def _placed(shares: Any, windows: Any) -> FloatArray:
    """Return the points of all spans, shape (spans * per_span, 3)."""
    placed: FloatArray = np.einsum("uk,sdk->sud", shares, windows).reshape(-1, windows.shape[1])
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
