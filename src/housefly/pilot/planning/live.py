"""The map of this moment: the room's grid with obstacles on top, and whether a path is free.

Without obstacles it is the room's grid itself. Two distances, so that a path that was just planned
does not count as blocked: a cell is closed when its middle is closer to an obstacle than ``reach``,
a path when one of its points is closer than ``tight``.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, sqrt
from typing import Any

import numpy as np

from housefly.geometry import Vec2
from housefly.numeric import FloatArray, compiled
from housefly.room.grid import Cell, OccupancyGrid

PATH_SAMPLE = 0.05
"""A path is looked at every so often [m]."""
RECEDING_TOLERANCE = 1e-3
"""A drone that is too close already may go where it gets no closer than this from one sample to the
next [m].
"""

_FREE, OCCUPIED, INFLATED, OUTSIDE = (
    int(Cell.FREE),
    int(Cell.OCCUPIED),
    int(Cell.INFLATED),
    int(Cell.OUTSIDE),
)


@dataclass(frozen=True, slots=True)
class KeepDistances:
    """How far the drone's middle keeps from an obstacle.

    Attributes:
        reach: cells whose middle is closer are closed [m].
        tight: a path that comes closer is blocked [m].
    """

    reach: float
    tight: float


def distances_for(keep: float, give: float, resolution: float) -> KeepDistances:
    """Return the distances that make every path through open cells free.

    Args:
        keep: what the drone keeps from the furniture: half its hull, the tracking bound and the
            margin [m].
        give: how much of that may be given away between the middles of two cells [m].
        resolution: edge of a cell [m].
    """
    half_diagonal = resolution / sqrt(2.0)
    tight = keep - min(half_diagonal, give)
    return KeepDistances(tight + half_diagonal, tight)


@compiled
def gap(row: Any, x: float, y: float) -> float:
    """Return the distance [m] from a point to the ground of one obstacle row, 0 inside."""
    dx, dy = x - row[0], y - row[1]
    way = row[7] * row[7] + row[8] * row[8]
    if way > 0.0:
        share = min(max((dx * row[7] + dy * row[8]) / way, 0.0), 1.0)
        dx, dy = dx - share * row[7], dy - share * row[8]
    u = max(abs(dx * row[4] + dy * row[5]) - row[2], 0.0)
    v = max(abs(dy * row[4] - dx * row[5]) - row[3], 0.0)
    return max(sqrt(u * u + v * v) - float(row[6]), 0.0)


@compiled
def standing_gap(row: Any, x: float, y: float) -> float:
    """Return the same distance [m] to where the row's obstacle was seen, wherever it may go."""
    u = max(abs((x - row[0]) * row[4] + (y - row[1]) * row[5]) - row[2], 0.0)
    v = max(abs((y - row[1]) * row[4] - (x - row[0]) * row[5]) - row[3], 0.0)
    return max(sqrt(u * u + v * v) - float(row[6]), 0.0)


@compiled
def _grow(
    rows: Any,
    x0: float,
    y0: float,
    edge: float,
    reach: float,
    most: float,
    cells: Any,
    clearance: Any,
) -> None:
    nx, ny = cells.shape
    touch = 0.7072 * edge
    for k in range(rows.shape[0]):
        far = sqrt(rows[k, 2] * rows[k, 2] + rows[k, 3] * rows[k, 3]) + rows[k, 6]
        far += sqrt(rows[k, 7] * rows[k, 7] + rows[k, 8] * rows[k, 8])
        window = far + most
        for i in range(
            max(0, int((rows[k, 0] - window - x0) / edge)),
            min(nx, int((rows[k, 0] + window - x0) / edge) + 1),
        ):
            x = x0 + (i + 0.5) * edge
            for j in range(
                max(0, int((rows[k, 1] - window - y0) / edge)),
                min(ny, int((rows[k, 1] + window - y0) / edge) + 1),
            ):
                y = y0 + (j + 0.5) * edge
                limit = far + max(reach, clearance[i, j])
                if abs(x - rows[k, 0]) > limit or abs(y - rows[k, 1]) > limit:
                    continue
                near = gap(rows[k], x, y)
                clearance[i, j] = min(clearance[i, j], near)
                if cells[i, j] == OUTSIDE or cells[i, j] == OCCUPIED:
                    continue
                if near <= touch:
                    cells[i, j] = OCCUPIED
                elif near < reach and cells[i, j] == _FREE:
                    cells[i, j] = INFLATED


@compiled
def _first_block(
    rows: Any, points: Any, tight: float, step: float, skip: float
) -> tuple[float, int]:
    """Return how far along a path [m] it is too close, and to which row; (inf, -1) for never."""
    along, before, was_free = 0.0, np.inf, False
    for leg in range(points.shape[0] - 1):
        dx, dy = points[leg + 1, 0] - points[leg, 0], points[leg + 1, 1] - points[leg, 1]
        length = sqrt(dx * dx + dy * dy)
        count = max(int(np.ceil(length / step)), 1)
        for n in range(count + 1):
            nearest, which, present = np.inf, -1, np.inf
            for k in range(rows.shape[0]):
                x, y = points[leg, 0] + dx * n / count, points[leg, 1] + dy * n / count
                near = gap(rows[k], x, y)
                if near < tight:
                    present = min(present, standing_gap(rows[k], x, y))
                if near < nearest:
                    nearest, which = near, k
            is_first = leg == 0 and n == 0
            if nearest < tight and (was_free or (not is_first and present < before - skip)):
                return along + length * n / count, which
            was_free = was_free or nearest >= tight
            before = present
        along += length
    return np.inf, -1


def live_grid(static: OccupancyGrid, rows: FloatArray, reach: float) -> OccupancyGrid:
    """Return the grid with obstacles on top; the very same grid when there are none.

    A cell that an obstacle touches is OCCUPIED, one whose middle is closer than ``reach`` [m]
    INFLATED.
    """
    if not len(rows):
        return static
    cells, clearance = static.cells.copy(), static.clearance.copy()
    _grow(
        rows,
        *static.origin,
        static.resolution,
        reach,
        max(reach, float(clearance.max())),
        cells,
        clearance,
    )
    return OccupancyGrid(static.origin, static.resolution, cells, clearance)


def first_block(rows: FloatArray, points: tuple[Vec2, ...], tight: float) -> tuple[float, int]:
    """Return how far along a path [m] which obstacle row blocks it; (inf, -1) when none does.

    Where the drone is too close already, the path counts as free as long as it leads away from
        where the obstacle is now: inside
    the ground that one may still cover there is no other measure of near and far.
    """
    if not len(rows) or len(points) < 2:
        return inf, -1
    return _first_block(
        rows, np.array(points, dtype=np.float64), tight, PATH_SAMPLE, RECEDING_TOLERANCE
    )
