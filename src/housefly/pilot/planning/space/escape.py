"""The way out for a drone that is where it may not be: too close to something, or in a volume.

Around it a ball of voxels is opened as far as they are no worse than where it is: nothing that
stands there gets nearer, nor does anybody. They are dear, so the way out is short.
"""

from __future__ import annotations

import numpy as np

from housefly.geometry import Vec3
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.voxels import VoxelMap, VoxelMask

ESCAPE_RADIUS = 1.0
"""So far a drone may fly to be free [m]."""
ESCAPE_WEIGHT = 8.0
"""What a voxel of the way out costs beside its length."""
RECEDING_GIVE = 0.02
"""So much nearer it may come meanwhile: voxels end at their middles [m]."""


def escape_mask(
    voxels: VoxelMap, free: VoxelMask, open_air: VoxelMask, here: FloatArray, rows: FloatArray
) -> VoxelMask:
    """Return the free voxels and those of the way out, shape (nx, ny, nz).

    Args:
        voxels: the map of the room without what moves.
        free: where the hull may be, with what moves.
        open_air: where no volume forbids it.
        here: middle of the hull [m], shape (3,).
        rows: what moves, where it is now and as large as it is, shape (n, 11).
    """
    place: Vec3 = (float(here[0]), float(here[1]), float(here[2]))
    first = voxels.voxel_of(place)
    low = [max(0, n - _reach(voxels)) for n in first]
    high = [min(m, n + _reach(voxels) + 1) for n, m in zip(first, voxels.shape, strict=True)]
    box = tuple(slice(a, b) for a, b in zip(low, high, strict=True))
    middles = np.moveaxis(np.indices([b - a for a, b in zip(low, high, strict=True)]), 0, -1)
    places = np.array(voxels.origin) + (middles + np.array(low) + 0.5) * voxels.resolution
    is_near = np.linalg.norm(places - here, axis=-1) <= ESCAPE_RADIUS
    # From its middle, not its hull: it may touch what it has to get away from.
    point = HullCylinder(0.0, voxels.hull.half_height)
    far = voxels.hull.radius + voxels.keep
    live = hull_clearances(rows, np.vstack((here, places.reshape(-1, 3))), point, far)
    better = live[1:].reshape(is_near.shape) >= live[0] - RECEDING_GIVE
    still = voxels.clearance[box]
    better &= still >= min(float(voxels.clearance[first]), voxels.keep) - RECEDING_GIVE
    better &= still > 0.0
    if open_air[first]:
        better &= open_air[box]
    opened = free.copy()
    opened[box] |= is_near & better
    opened[first] = True
    return opened


def _reach(voxels: VoxelMap) -> int:
    return int(np.ceil(ESCAPE_RADIUS / voxels.resolution))
