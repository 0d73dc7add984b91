"""A way through voxels as a chain of free boxes: what stays in them stays free.

A box reaches from the middle of its first voxels to that of its last. So between two free middles
a wall is as far as at both, and a corner nearer by no more than the bulge of a circle between them
(5 mm for voxels of 0.1 m and a distance of 0.5 m).
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled, compiled_with_arrays
from housefly.pilot.planning.space.voxels import VoxelMask

_REACH = 25
"""A box grows to no more than so many voxels along each axis."""


@compiled
def _is_free(free: Any, low: Any, high: Any) -> bool:
    """Return whether all voxels from ``low`` to ``high`` are free, both included."""
    for i in range(low[0], high[0] + 1):
        for j in range(low[1], high[1] + 1):
            for k in range(low[2], high[2] + 1):
                if not free[i, j, k]:
                    return False
    return True


@compiled
def _grown(free: Any, low: Any, high: Any, reach: int) -> None:
    """Grow a free box by layers, in turn on all six sides, while they are free."""
    open_sides = 63
    while open_sides:
        for side in range(6):
            axis, is_high = side // 2, side % 2
            if not open_sides & (1 << side):
                continue
            kept_low, kept_high = low[axis], high[axis]
            layer = kept_high + 1 if is_high else kept_low - 1
            fits = 0 <= layer < free.shape[axis] and kept_high - kept_low + 1 < reach
            if fits:
                low[axis], high[axis] = layer, layer
                fits = _is_free(free, low, high)
                low[axis], high[axis] = kept_low, kept_high
            if not fits:
                open_sides &= ~(1 << side)
            elif is_high:
                high[axis] = layer
            else:
                low[axis] = layer


@compiled_with_arrays
def _chain(free: Any, voxels: Any, reach: int, boxes: Any) -> int:
    """Write a chain of boxes that holds voxels one after the other; return how many."""
    count, at = 0, 0
    while at < voxels.shape[0]:
        low, high = boxes[count, 0], boxes[count, 1]
        low[:], high[:] = voxels[at], voxels[at]
        end = at
        while end + 1 < voxels.shape[0]:
            trial_low = np.minimum(low, voxels[end + 1])
            trial_high = np.maximum(high, voxels[end + 1])
            if not _is_free(free, trial_low, trial_high):
                break
            low[:], high[:] = trial_low, trial_high
            end += 1
        _grown(free, low, high, reach)
        while end + 1 < voxels.shape[0] and (
            (low <= voxels[end + 1]).all() and (voxels[end + 1] <= high).all()
        ):
            end += 1
        count += 1
        at = max(end, at + 1) if end + 1 < voxels.shape[0] else voxels.shape[0]
    return count


def corridor(free: VoxelMask, points: FloatArray) -> FloatArray:
    """Return boxes that a way leads through, neighbours overlapping, shape (n, 2, 3).

    Args:
        free: where the middle of the hull may be, shape (nx, ny, nz).
        points: corners of a way through free voxels [voxel edges], shape (m, 3).

    Returns:
        Lower and upper corners [voxel edges]; a box of one voxel has no extent.
    """
    voxels = _voxels_along(points)
    boxes = np.zeros((len(voxels), 2, 3), dtype=np.int64)
    count = _chain(free, voxels, _REACH, boxes)
    chain: FloatArray = _needed(boxes[:count]) + 0.5
    return chain


def _voxels_along(points: FloatArray) -> Any:
    """Return the voxels that a way passes, one after the other, shape (n, 3)."""
    middles = [points[:1]]
    for a, b in pairwise(points):
        shares = [np.array([0.0, 1.0])]
        for axis in range(3):
            low, high = sorted((a[axis], b[axis]))
            planes = np.arange(np.floor(low) + 1.0, np.ceil(high))
            shares.append((planes - a[axis]) / (b[axis] - a[axis]) if planes.size else planes)
        crossed = np.sort(np.concatenate(shares))
        middles.append(a + (b - a) * (0.5 * (crossed[1:] + crossed[:-1]))[:, None])
    cells = np.floor(np.concatenate((*middles, points[-1:]))).astype(np.int64)
    differs = np.concatenate(([True], (np.diff(cells, axis=0) != 0).any(axis=1)))
    return np.ascontiguousarray(cells[differs])


def _needed(boxes: Any) -> Any:
    """Return the boxes without those whose neighbours overlap widely."""
    kept = [boxes[0]]
    for n in range(1, len(boxes)):
        if n + 1 < len(boxes):
            shared = np.minimum(kept[-1][1], boxes[n + 1][1]) - np.maximum(
                kept[-1][0], boxes[n + 1][0]
            )
            own = np.minimum(kept[-1][1], boxes[n][1]) - np.maximum(kept[-1][0], boxes[n][0])
            if (shared >= np.minimum(own, 2)).all() and (shared >= 0).all():
                continue
        kept.append(boxes[n])
    return np.array(kept)
