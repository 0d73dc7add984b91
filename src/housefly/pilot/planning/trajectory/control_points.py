"""The control points of a curve inside a corridor: every span of it stays in one box."""

from __future__ import annotations

from itertools import pairwise
from math import ceil

import numpy as np

from housefly.numeric import FloatArray, norm
from housefly.pilot.planning.trajectory.bounded_points import bounded_points

_SHARED = 3
"""So many control points lie in two boxes at once, so that no span has points of only one and of
only the other.
"""
_PULL = 0.3
"""How much shortness counts beside straightness."""


def control_points(
    boxes: FloatArray, start: FloatArray, goal: FloatArray, stride: float
) -> FloatArray:
    """Return the control points of the curve that bends least, shape (n, 3).

    Args:
        boxes: a chain, neighbours overlapping [m], shape (k, 2, 3).
        start: the first three control points [m], shape (3, 3).
        goal: where it ends, at rest [m], shape (3,).
        stride: about how far control points are apart [m].
    """
    lows, highs = [start], [start]
    at = start[-1]
    for box, following in pairwise(boxes):
        shared = np.stack((np.maximum(box[0], following[0]), np.minimum(box[1], following[1])))
        there = np.clip(at, shared[0], shared[1])
        _put(lows, highs, box, _between(at, there, stride))
        _put(lows, highs, shared, _SHARED)
        at = there
    _put(lows, highs, boxes[-1], _between(at, goal, stride))
    lows.append(np.repeat(goal[None, :], 3, axis=0))
    highs.append(lows[-1])
    low, high = np.concatenate(lows), np.concatenate(highs)
    axes = [
        bounded_points(np.ascontiguousarray(low[:, n]), np.ascontiguousarray(high[:, n]), _PULL)
        for n in range(3)
    ]
    return np.stack(axes, axis=1)


def _between(start: FloatArray, end: FloatArray, stride: float) -> int:
    """Return how many control points go between two places."""
    return max(0, ceil(norm(end - start) / stride) - _SHARED + 1)


def _put(lows: list[FloatArray], highs: list[FloatArray], box: FloatArray, count: int) -> None:
    lows.append(np.repeat(box[:1], count, axis=0))
    highs.append(np.repeat(box[1:], count, axis=0))


def stopping_points(corners: FloatArray) -> FloatArray:
    """Return control points of the polyline itself, which stands at every corner, shape (n, 3)."""
    return np.repeat(corners, 3, axis=0)
