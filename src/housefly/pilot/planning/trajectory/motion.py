"""The motion of a drone that travels along a curve: place, velocity, acceleration."""

from __future__ import annotations

from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled
from housefly.pilot.planning.trajectory.curve import ArcCurve, curve_index
from housefly.pilot.planning.trajectory.kinematic_state import hermite


@compiled
def _fill_motion(curve: ArcCurve, travelled: Any, rows: Any) -> None:
    at = 0
    for n in range(travelled.shape[0]):
        s, v, a = travelled[n, 0], travelled[n, 1], travelled[n, 2]
        at = curve_index(curve.marks, s, at)
        step = curve.marks[at + 1] - curve.marks[at]
        u = min(max((s - curve.marks[at]) / step, 0.0), 1.0)
        norm = 0.0
        for axis in range(3):
            slope = (1.0 - u) * curve.along[at, axis] + u * curve.along[at + 1, axis]
            norm += slope * slope
        norm = np.sqrt(max(norm, 1e-12))
        for axis in range(3):
            m0, m1 = step * curve.along[at, axis], step * curve.along[at + 1, axis]
            p0, p1 = curve.places[at, axis], curve.places[at + 1, axis]
            along = ((1.0 - u) * curve.along[at, axis] + u * curve.along[at + 1, axis]) / norm
            bend = (1.0 - u) * curve.bends[at, axis] + u * curve.bends[at + 1, axis]
            rows[n, axis] = hermite(p0, p1, m0, m1, u)
            rows[n, 3 + axis] = v * along
            rows[n, 6 + axis] = a * along + v * v * bend


def flown_motion(curve: ArcCurve, travelled: FloatArray) -> FloatArray:
    """Return place [m], velocity [m/s] and acceleration [m/s^2] of a motion, shape (m, 9).

    Args:
        curve: to fly.
        travelled: arc length [m], speed [m/s] and acceleration [m/s^2] along it, shape (m, 3).
    """
    rows = np.empty((len(travelled), 9))
    _fill_motion(curve, travelled, rows)
    return rows
