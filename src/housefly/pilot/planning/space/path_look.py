"""Whether a path in space is free of what is known now: the first place where it is not."""

from __future__ import annotations

from math import ceil, inf, sqrt
from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled
from housefly.pilot.planning.live import PATH_SAMPLE, RECEDING_TOLERANCE
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.solid_rows import BOTTOM, TOP
from housefly.pilot.planning.space.voxels import CLEARANCE_CAP

_ROUNDING = 1e-6
"""What is farther from a path than it must be by less than this is not far from it [m]."""


@compiled
def _away_from_leg(row: Any, start: Any, end: Any) -> float:
    """Return the distance in the plane [m] from the middle of a row to a straight leg."""
    dx, dy, x, y = end[0] - start[0], end[1] - start[1], row[0] - start[0], row[1] - start[1]
    length = dx * dx + dy * dy
    share = min(max((x * dx + y * dy) / length, 0.0), 1.0) if length > 0.0 else 0.0
    x, y = x - share * dx, y - share * dy
    return sqrt(x * x + y * y)


@compiled
def _is_far(row: Any, points: Any, hull: HullCylinder, tight: float) -> bool:
    """Return whether a disc around a row is far from a path, leg by leg beside or in height."""
    around = sqrt(row[2] * row[2] + row[3] * row[3]) + row[6]
    around += sqrt(row[7] * row[7] + row[8] * row[8])
    kept = tight + _ROUNDING
    for leg in range(points.shape[0] - 1):
        start, end = points[leg], points[leg + 1]
        below = row[BOTTOM] - max(start[2], end[2]) - hull.half_height
        above = min(start[2], end[2]) - hull.half_height - row[TOP]
        aside = _away_from_leg(row, start, end) - around - hull.radius
        if max(below, above, aside) < kept:
            return False
    return True


@compiled
def _passes_near(rows: Any, points: Any, hull: HullCylinder, tight: float) -> bool:
    is_near = False
    for n in range(rows.shape[0]):
        is_near = is_near or not _is_far(rows[n], points, hull, tight)
    return is_near


def passes_near(rows: FloatArray, points: FloatArray, hull: HullCylinder, tight: float) -> bool:
    """Return whether a path may be blocked at all, which is quickly told; if not, it is free.

    Args:
        rows: what obstacles may cover soon, shape (n, 11).
        points: corners of the path [m], shape (m, 3).
        hull: of the drone.
        tight: a path on which the hull comes closer is blocked [m].
    """
    # Distances are not measured beyond the cap: all that is farther looks as near as it.
    return tight > CLEARANCE_CAP or _passes_near(rows, points, hull, tight)


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
