"""A curve by its arc length: places, directions and bends, close together."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from housefly.numeric import FloatArray, compiled
from housefly.pilot.planning.trajectory.bspline import curve_points

_PER_SPAN = 16
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
    places, first, second = curve_points(points, _PER_SPAN)
    pace = np.linalg.norm(first, axis=1)
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    moves = np.concatenate(([True], steps > 1e-9))
    places, first, second, pace = places[moves], first[moves], second[moves], pace[moves]
    stands = pace < _STANDING
    along = np.where(stands[:, None], _towards_next(places), first)
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-12)[:, None]
    across = second - (second * along).sum(axis=1)[:, None] * along
    bends = np.where(stands[:, None], 0.0, across / np.maximum(pace, _STANDING)[:, None] ** 2)
    chords = np.linalg.norm(np.diff(places, axis=0), axis=1)
    # An arc is longer than its chord.
    turn = np.linalg.norm(bends, axis=1)
    arcs = chords * (1.0 + (chords * np.maximum(turn[:-1], turn[1:])) ** 2 / 24.0)
    marks = np.concatenate(([0.0], np.cumsum(arcs)))
    return ArcCurve(marks, places, along, bends, stands.astype(np.float64))


def _towards_next(places: FloatArray) -> FloatArray:
    """Return the way from each place to the next; the last one's from the one before."""
    steps = np.diff(places, axis=0)
    return np.vstack((steps, steps[-1:]))


@compiled
def curve_index(marks: FloatArray, s: float, at: int) -> int:
    """Return the sample at or before an arc length [m], searched from an earlier one."""
    while at < marks.size - 2 and marks[at + 1] <= s:
        at += 1
    return at
