"""Whether a path in space is free of what is known now: the first place where it is not."""

from __future__ import annotations

from math import ceil, inf

import numpy as np

from housefly.numeric import FloatArray
from housefly.pilot.planning.live import PATH_SAMPLE, RECEDING_TOLERANCE
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.voxels import CLEARANCE_CAP


def first_block_in_space(
    rows: FloatArray, standing: FloatArray, points: FloatArray, hull: HullCylinder, tight: float
) -> tuple[float, int]:
    """Return how far along a path [m] which row blocks it; (inf, -1) when none does.

    Where the drone is too close already, the path counts as free as long as it leads away from
    where the obstacle is now.

    Args:
        rows: what obstacles may cover soon, shape (n, 11).
        standing: what they cover now, shape (n, 11).
        points: corners of the path [m], shape (m, 3).
        hull: of the drone.
        tight: a path on which the hull comes closer is blocked [m].
    """
    if not len(rows) or len(points) < 2:
        return inf, -1
    places, marks = _sampled(points)
    near = hull_clearances(rows, places, hull, CLEARANCE_CAP)
    close = near < tight
    if not close.any():
        return inf, -1
    # Of the middle: the hull may touch already, and nothing is nearer than that.
    now = hull_clearances(standing, places, HullCylinder(0.0, 0.0), inf)
    was_free = np.logical_or.accumulate(~close)
    closer = np.append(False, now[1:] < now[:-1] - RECEDING_TOLERANCE)
    blocked = close & (was_free | closer)
    if not blocked.any():
        return inf, -1
    at = int(blocked.argmax())
    each = [float(hull_clearances(row[None, :], places[at : at + 1], hull, inf)[0]) for row in rows]
    return float(marks[at]), int(np.argmin(each))


def _sampled(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return places along a path, shape (k, 3), and how far along they are [m], shape (k,)."""
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    marks = np.concatenate(([0.0], np.cumsum(lengths)))
    count = max(2, ceil(marks[-1] / PATH_SAMPLE) + 1)
    wanted = np.linspace(0.0, marks[-1], count)
    places = np.column_stack([np.interp(wanted, marks, points[:, axis]) for axis in range(3)])
    return np.ascontiguousarray(places), wanted
