"""Which free voxels belong to the room: those that can be reached from home."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from housefly.geometry import Vec2
from housefly.numeric import compiled_with_arrays
from housefly.pilot.planning.space.voxels import VoxelIndex, VoxelMap, VoxelMask


@compiled_with_arrays
def _flooded(free: Any, start: Any) -> Any:
    """Return the free voxels that face-to-face moves reach from marked ones; both padded."""
    nx, ny, nz = free.shape
    reached, stride = np.zeros(free.size, dtype=np.bool_), ny * nz
    open_voxel, first = free.ravel(), start.ravel()
    queue = np.empty(free.size, dtype=np.int32)
    head, tail = 0, 0
    for voxel in range(free.size):
        if first[voxel] and open_voxel[voxel]:
            reached[voxel] = True
            queue[tail] = voxel
            tail += 1
    while head < tail:
        voxel = queue[head]
        head += 1
        for move in (stride, -stride, nz, -nz, 1, -1):
            to = voxel + move
            if open_voxel[to] and not reached[to]:
                reached[to] = True
                queue[tail] = to
                tail += 1
    return reached.reshape(nx, ny, nz)


def within_reach(voxels: VoxelMap, home: Vec2) -> VoxelMap:
    """Return the map without the voxels that no way leads to from above a place [m].

    Things that come later only take room away, so what is not reached now never will be.
    """
    free = voxels.free()
    start = np.zeros(free.shape, dtype=np.bool_)
    i, j, _ = voxels.voxel_of((*home, 0.0))
    start[i, j, :] = True
    return replace(voxels, allowed=voxels.allowed & _reached(free, start))


def reached_from_voxel(free: VoxelMask, voxel: VoxelIndex) -> VoxelMask:
    """Return the free voxels that a way leads to from one of them, shape (nx, ny, nz)."""
    start = np.zeros(free.shape, dtype=np.bool_)
    start[voxel] = True
    return _reached(free, start)


def _reached(free: VoxelMask, start: VoxelMask) -> VoxelMask:
    reached: VoxelMask = _flooded(np.pad(free, 1), np.pad(start, 1))[1:-1, 1:-1, 1:-1]
    return reached
