"""Straightens a way through voxels: legs at any angle, through free voxels only.

Of all polylines through points of the way whose legs touch free voxels only, the cheapest is
taken; then points are put on its legs and the same is done again. The way given is one of the
choices each time, so the result is never longer.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from housefly.geometry import Vec3
from housefly.numeric import FloatArray, compiled_with_arrays
from housefly.pilot.planning.space.line_of_sight import line_cost, sees_in_space
from housefly.pilot.planning.space.voxels import VoxelMap, VoxelMask

_ROUNDS = 3
"""So often the way is straightened and its legs divided anew."""
_POINTS = 24
"""About so many points are on the way each time."""
_SAME_PLACE = 1e-9
"""Points nearer than this are the same [voxel edges]."""
_NO_WEIGHTS: FloatArray = np.zeros((0, 0, 0))


@compiled_with_arrays
def _cheapest(free: Any, weights: Any, points: Any) -> Any:
    """Return which points the cheapest polyline through free voxels keeps, shape (n,)."""
    n = points.shape[0]
    cost, came_from = np.full(n, np.inf), np.zeros(n, dtype=np.int64)
    cost[0] = 0.0
    for end in range(1, n):
        for start in range(end - 1, -1, -1):
            a, b = points[start], points[end]
            leg = line_cost(weights, a[0], a[1], a[2], b[0], b[1], b[2])
            if cost[start] + leg >= cost[end]:
                continue
            # The leg that was given is believed: it may begin where the drone must not be.
            if start == end - 1 or sees_in_space(free, a[0], a[1], a[2], b[0], b[1], b[2]):
                cost[end], came_from[end] = cost[start] + leg, start
    kept = np.zeros(n, dtype=np.bool_)
    at = n - 1
    while at > 0:
        kept[at] = True
        at = came_from[at]
    kept[0] = True
    return kept


def taut(free: VoxelMask, points: FloatArray, weights: FloatArray = _NO_WEIGHTS) -> FloatArray:
    """Return the corners of a straightened way, both ends as they were, shape (m, 3).

    Args:
        free: where the middle of the hull may be, shape (nx, ny, nz).
        points: of a way whose legs touch free voxels only, from the lower corner of the map [voxel
            edges], shape (n, 3).
        weights: of the search that found it; empty for none.
    """
    corners = _corners(points)
    for _ in range(_ROUNDS):
        divided = _divided(corners)
        corners = divided[_cheapest(free, weights, divided)]
    return corners


def in_voxel_edges(voxels: VoxelMap, points: FloatArray) -> FloatArray:
    """Return points [m] from the lower corner of a map [voxel edges], shape (n, 3)."""
    scaled: FloatArray = (points - np.array(voxels.origin)) / voxels.resolution
    return scaled


def in_metres(voxels: VoxelMap, points: FloatArray) -> tuple[Vec3, ...]:
    """Return points [voxel edges] in the world [m]."""
    places = np.array(voxels.origin) + points * voxels.resolution
    return tuple((x, y, z) for x, y, z in places.tolist())


def _corners(points: FloatArray) -> FloatArray:
    """Return the points where a way turns, and its ends."""
    apart = np.linalg.norm(np.diff(points, axis=0), axis=1) > _SAME_PLACE
    distinct = points[np.concatenate(([True], apart))]
    along = np.diff(distinct, axis=0)
    turns = np.linalg.norm(np.cross(along[:-1], along[1:]), axis=1) > _SAME_PLACE
    back = (along[:-1] * along[1:]).sum(axis=1) < 0.0
    corners: FloatArray = distinct[np.concatenate(([True], turns | back, [True]))[-len(distinct) :]]
    return corners


def _divided(corners: FloatArray) -> FloatArray:
    """Return corners with points between them, evenly along each leg."""
    lengths = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    counts = 1 + np.floor(_POINTS * lengths / max(float(lengths.sum()), _SAME_PLACE)).astype(int)
    legs = [
        a + (b - a) * (np.arange(count) / count)[:, None]
        for a, b, count in zip(corners[:-1], corners[1:], counts.tolist(), strict=True)
    ]
    return np.concatenate((*legs, corners[-1:]))
