"""A curve by its arc length: places, directions and bends, close together."""

from __future__ import annotations

from math import sqrt
from typing import Any, NamedTuple

import numpy as np

from housefly.numeric import FloatArray, compiled, compiled_with_arrays
from housefly.pilot.planning.trajectory.bspline import curve_points

_PER_SPAN = 16
_SAME_PLACE = 1e-9
"""Samples nearer than this are the same place [m]."""
_STANDING = 1e-6
"""Where the curve moves by less than this for a whole span it stands, and may turn [m]."""


class ArcCurve(NamedTuple):
    """A curve in space.

    Attributes:
        marks: arc length of each sample [m], increasing, shape (n,).
        places: [m], shape (n, 3).
        along: unit vectors, shape (n, 3).
        bends: curvature vectors [1/m], shape (n, 3).
        stands: where it may turn on the spot, shape (n,).
    """

    marks: FloatArray
    places: FloatArray
    along: FloatArray
    bends: FloatArray
    stands: FloatArray


def arc_curve(points: FloatArray) -> ArcCurve:
    """Return the B-spline of control points [m] by its arc length.

    Args:
        points: shape (n, 3), n at least 4; three alike are a place where it stands.
    """
    return _by_arc_length(*curve_points(points, _PER_SPAN))


@compiled_with_arrays
def _by_arc_length(places: Any, first: Any, second: Any) -> ArcCurve:
    """Return the curve of samples and their derivatives; samples in the same place are one."""
    kept = np.zeros(places.shape[0], dtype=np.int64)
    count = 1
    for n in range(1, places.shape[0]):
        if _distance(places, n - 1, n) > _SAME_PLACE:
            kept[count], count = n, count + 1
    marks, stands = np.zeros(count), np.zeros(count)
    spots, along, bends = np.zeros((count, 3)), np.zeros((count, 3)), np.zeros((count, 3))
    for n in range(count):
        spots[n] = places[kept[n]]
    for n in range(count):
        pace, near = _length(first, kept[n]), min(n, count - 2)
        stands[n] = 1.0 if pace < _STANDING else 0.0
        for i in range(3):
            standing = spots[near + 1, i] - spots[near, i]
            along[n, i] = first[kept[n], i] if pace >= _STANDING else standing
        size = max(_length(along, n), 1e-12)
        for i in range(3):
            along[n, i] /= size
        if pace >= _STANDING:
            turning = second[kept[n]]
            ahead = turning[0] * along[n, 0] + turning[1] * along[n, 1] + turning[2] * along[n, 2]
            for i in range(3):
                bends[n, i] = (turning[i] - ahead * along[n, i]) / pace**2
    for n in range(1, count):
        chord = _distance(spots, n - 1, n)
        turn = max(_length(bends, n - 1), _length(bends, n))
        # An arc is longer than its chord.
        marks[n] = marks[n - 1] + chord * (1.0 + (chord * turn) ** 2 / 24.0)
    return ArcCurve(marks, spots, along, bends, stands)


@compiled
def _length(vectors: Any, n: int) -> float:
    x, y, z = vectors[n, 0], vectors[n, 1], vectors[n, 2]
    return sqrt(x * x + y * y + z * z)


@compiled
def _distance(places: Any, a: int, b: int) -> float:
    x, y, z = places[b, 0] - places[a, 0], places[b, 1] - places[a, 1], places[b, 2] - places[a, 2]
    return sqrt(x * x + y * y + z * z)


@compiled
def curve_index(marks: FloatArray, s: float, at: int) -> int:
    """Return the sample at or before an arc length [m], searched from an earlier one."""
    while at < marks.size - 2 and marks[at + 1] <= s:
        at += 1
    return at
