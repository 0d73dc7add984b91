"""What makes a way dearer than its length: narrow air, people, places that tracking hardly sees.

Each layer is 0 where there is nothing to avoid. Layers are added up; the sum is the weights of the
search.
"""

from __future__ import annotations

import numpy as np

from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import lower_clearance
from housefly.pilot.planning.space.solid_rows import BOTTOM, TOP
from housefly.pilot.planning.space.voxels import VoxelMap
from housefly.room.coverage import seen_by
from housefly.room.model import Room

CAMERAS_WANTED = 3
"""A place seen by so many tracking cameras is tracked well."""
_LANDING_ROOM = 0.4
"""A landing goes so far astray [m]."""
_COARSE = 0.5
"""Coverage is looked up at points so far apart [m]: it changes slowly, and rays are dear."""


def narrowness(voxels: VoxelMap, wide: float, gain: float) -> FloatArray:
    """Return the layer that grows from 0 at a clearance [m] to ``gain`` at ``keep``.

    Shape (nx, ny, nz).
    """
    slope = max(wide - voxels.keep, 1e-9)
    layer: FloatArray = gain * np.clip((wide - voxels.clearance) / slope, 0.0, 1.0)
    return layer


def blindness(voxels: VoxelMap, room: Room, gain: float) -> FloatArray:
    """Return the layer that grows from 0 where tracking sees well to ``gain`` where it is blind.

    Shape (nx, ny, nz); nothing where the room has no cameras, because tracking then sees
    everywhere. It takes a second, so it is made once for a room.
    """
    if not room.cameras:
        return np.zeros(voxels.shape)
    stride = max(1, round(_COARSE / voxels.resolution))
    picks = [np.arange(stride // 2, max(size, stride // 2 + 1), stride) for size in voxels.shape]
    indices = np.stack(np.meshgrid(*picks, indexing="ij"), axis=-1)
    points = np.array(voxels.origin) + (indices.reshape(-1, 3) + 0.5) * voxels.resolution
    seen = seen_by(room, points).sum(axis=1).reshape(indices.shape[:3])
    coarse = gain * (1.0 - np.minimum(seen, CAMERAS_WANTED) / CAMERAS_WANTED)
    nearest = [
        np.clip(np.arange(size) // stride, 0, len(pick) - 1)
        for size, pick in zip(voxels.shape, picks, strict=True)
    ]
    layer: FloatArray = coarse[np.ix_(*nearest)]
    return layer


def height_wish(voxels: VoxelMap, height: float, gain: float) -> FloatArray:
    """Return the layer that grows by ``gain`` for every metre from the usual height [m].

    Shape (nx, ny, nz).
    """
    nx, ny, nz = voxels.shape
    zs = voxels.origin[2] + (np.arange(nz) + 0.5) * voxels.resolution
    return np.broadcast_to(gain * np.abs(zs - height), (nx, ny, nz)).copy()


def above_things(voxels: VoxelMap, rows: FloatArray, gain: float) -> FloatArray:
    """Return the layer that grows to ``gain`` where the hull would land on furniture.

    A drone that lost its link lands by itself where it is: beside a bed is better than on it.

    Args:
        voxels: the map.
        rows: of the room; those that are full from the floor up are furniture, shape (n, 11).
        gain: of the layer.

    Returns:
        Shape (nx, ny, nz).
    """
    nx, ny, nz = voxels.shape
    below = rows[np.isneginf(rows[:, BOTTOM])].copy()
    below[:, TOP] = np.inf
    apart = np.full((nx, ny, 1), _LANDING_ROOM, dtype=np.float32)
    box = (0, nx, 0, ny, 0, 1)
    lower_clearance(below, voxels.origin, voxels.resolution, voxels.hull, _LANDING_ROOM, box, apart)
    layer = gain * (1.0 - apart.astype(np.float64) / _LANDING_ROOM)
    return np.repeat(layer, nz, axis=2)
