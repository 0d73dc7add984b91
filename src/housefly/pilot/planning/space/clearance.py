"""The distance from the hull to the nearest solid, exact for every voxel, compiled.

The hull is an upright cylinder, every solid an upright prism: the gap between two such bodies is
the root of the squares of a gap in the plane and a gap in height. So nothing is lost to voxels, as
a distance transform of occupied voxels would lose up to a diagonal of one.
"""

from __future__ import annotations

from math import ceil, floor, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec3
from housefly.numeric import FloatArray, compiled, compiled_with_arrays
from housefly.pilot.planning.live import gap
from housefly.pilot.planning.space.solid_rows import BOTTOM, TOP

ClearanceArray = NDArray[np.float32]
VoxelBox = tuple[int, int, int, int, int, int]
"""First voxel and the one behind the last along x, y and z."""


class HullCylinder(NamedTuple):
    """The upright cylinder around a hull.

    Attributes:
        radius: [m].
        half_height: [m].
    """

    radius: float
    half_height: float


@compiled
def height_gap_of(row: Any, z: float, half_height: float) -> float:
    """Return the gap in height [m] between a row and a hull at a height [m], 0 side by side."""
    return float(max(row[BOTTOM] - z - half_height, z - half_height - row[TOP], 0.0))


@compiled
def hull_gap(row: Any, x: float, y: float, z: float, hull: HullCylinder) -> float:
    """Return the distance [m] from the hull around a point [m] to a row, 0 where they touch."""
    aside = max(gap(row, x, y) - hull.radius, 0.0)
    above = height_gap_of(row, z, hull.half_height)
    return sqrt(aside * aside + above * above)


@compiled
def _half_extent(row: Any, axis: int) -> float:
    """Return half the extent of a row along x (0) or y (1), its way included [m]."""
    cosine, sine = abs(row[4]), abs(row[5])
    turned = row[2] * cosine + row[3] * sine if axis == 0 else row[2] * sine + row[3] * cosine
    return float(turned + row[6])


@compiled
def _first(low: float, origin: float, edge: float, start: int, end: int) -> int:
    """Return the first voxel from ``start`` on whose middle lies at or above a number [m]."""
    wanted = (low - origin) / edge - 0.5
    return start if wanted <= start else end if wanted >= end else ceil(wanted)


@compiled
def _behind(high: float, origin: float, edge: float, start: int, end: int) -> int:
    """Return the voxel behind the last one before ``end`` whose middle lies at or below [m]."""
    wanted = (high - origin) / edge - 0.5
    return end if wanted >= end - 1 else start if wanted < start else floor(wanted) + 1


@compiled_with_arrays
def lower_clearance(
    rows: FloatArray,
    origin: Vec3,
    edge: float,
    hull: HullCylinder,
    cap: float,
    box: VoxelBox,
    clearance: ClearanceArray,
) -> None:
    """Lower the clearance of the voxels in a box to what rows leave.

    Args:
        rows: shape (n, 11).
        origin: lower corner of the voxels [m].
        edge: of a voxel [m].
        hull: of the drone.
        cap: clearances beyond this are not looked for [m].
        box: of voxels.
        clearance: [m], shape (nx, ny, nz); written.
    """
    for k in range(rows.shape[0]):
        row, far = rows[k], cap + hull.radius
        ex, ey = _half_extent(row, 0) + far, _half_extent(row, 1) + far
        x_low, x_high = min(0.0, row[7]) - ex, max(0.0, row[7]) + ex
        y_low, y_high = min(0.0, row[8]) - ey, max(0.0, row[8]) + ey
        i0 = _first(row[0] + x_low, origin[0], edge, box[0], box[1])
        i1 = _behind(row[0] + x_high, origin[0], edge, box[0], box[1])
        j0 = _first(row[1] + y_low, origin[1], edge, box[2], box[3])
        j1 = _behind(row[1] + y_high, origin[1], edge, box[2], box[3])
        tall = cap + hull.half_height
        k0 = _first(row[BOTTOM] - tall, origin[2], edge, box[4], box[5])
        k1 = _behind(row[TOP] + tall, origin[2], edge, box[4], box[5])
        for i in range(i0, i1):
            x = origin[0] + (i + 0.5) * edge
            for j in range(j0, j1):
                aside = gap(row, x, origin[1] + (j + 0.5) * edge) - hull.radius
                if aside >= cap:
                    continue
                aside = max(aside, 0.0)
                for n in range(k0, k1):
                    z = origin[2] + (n + 0.5) * edge
                    above = height_gap_of(row, z, hull.half_height)
                    near = aside if above == 0.0 else sqrt(aside * aside + above * above)
                    if near < clearance[i, j, n]:
                        clearance[i, j, n] = near


@compiled
def _hull_clearances(
    rows: Any, reaches: Any, points: Any, hull: HullCylinder, cap: float, out: Any
) -> None:
    for n in range(points.shape[0]):
        best = cap
        x, y, z = points[n, 0], points[n, 1], points[n, 2]
        for k in range(rows.shape[0]):
            far = best + hull.radius + reaches[k]
            if abs(x - rows[k, 0]) > far or abs(y - rows[k, 1]) > far:
                continue
            if height_gap_of(rows[k], z, hull.half_height) < best:
                best = min(best, hull_gap(rows[k], x, y, z, hull))
        out[n] = best


def hull_clearances(
    rows: FloatArray, points: FloatArray, hull: HullCylinder, cap: float
) -> FloatArray:
    """Return the distance [m] from the hull to the nearest row at each point, at most ``cap``.

    Args:
        rows: shape (n, 11).
        points: middles of the hull [m], shape (m, 3).
        hull: of the drone.
        cap: farther is as good [m].

    Returns:
        Shape (m,).
    """
    out = np.empty(len(points))
    reaches = np.hypot(rows[:, 2], rows[:, 3]) + rows[:, 6] + np.hypot(rows[:, 7], rows[:, 8])
    rows, points = np.ascontiguousarray(rows), np.ascontiguousarray(points)  # compiled once
    _hull_clearances(rows, reaches, points, hull, cap, out)
    return out
