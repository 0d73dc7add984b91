"""The room as voxels: how far the hull is from everything, and where its middle may be."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import floor

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec3
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import (
    ClearanceArray,
    HullCylinder,
    lower_clearance,
)
from housefly.pilot.planning.space.solid_rows import room_rows
from housefly.room.model import Room

VoxelIndex = tuple[int, int, int]
VoxelMask = NDArray[np.bool_]
CLEARANCE_CAP = 1.0
"""Farther than this from everything is as good as anywhere [m]."""
_COORDINATE_MAX = 1e6
"""Points farther away [m], or not finite, are in no voxel."""


@dataclass(frozen=True, slots=True, eq=False)
class VoxelMap:
    """Where the middle of the hull may be.

    Attributes:
        origin: lower corner [m].
        resolution: edge of a voxel [m].
        hull: of the drone.
        keep: the hull keeps this from everything [m].
        clearance: from the hull in the middle of each voxel to the nearest solid, at most
            ``CLEARANCE_CAP`` [m], shape (nx, ny, nz), read-only.
        allowed: whatever stands there, the middle of the hull may be in this voxel: the room can be
            reached, and no keep-out volume holds it; the same shape, read-only.
    """

    origin: Vec3
    resolution: float
    hull: HullCylinder
    keep: float
    clearance: ClearanceArray
    allowed: VoxelMask

    def __post_init__(self) -> None:
        self.clearance.setflags(write=False)
        self.allowed.setflags(write=False)

    @property
    def shape(self) -> VoxelIndex:
        """Number of voxels along x, y and z."""
        nx, ny, nz = self.clearance.shape
        return nx, ny, nz

    def free(self) -> VoxelMask:
        """Return where the middle of the hull may be, shape (nx, ny, nz)."""
        mask: VoxelMask = self.allowed & (self.clearance >= np.float32(self.keep))
        return mask

    def is_free(self, voxel: VoxelIndex) -> bool:
        """Return whether the middle of the hull may be in a voxel of the map."""
        return bool(self.allowed[voxel] and self.clearance[voxel] >= np.float32(self.keep))

    def voxel_of(self, point: Vec3) -> VoxelIndex:
        """Return the voxel of a point [m]; it may be off the map, as are points of no room."""
        if not all(abs(value) <= _COORDINATE_MAX for value in point):
            return -1, -1, -1
        i, j, k = (
            floor((value - low) / self.resolution)
            for value, low in zip(point, self.origin, strict=True)
        )
        return i, j, k

    def middle_of(self, voxel: VoxelIndex) -> Vec3:
        """Return the middle of a voxel [m]."""
        x, y, z = (
            low + (n + 0.5) * self.resolution for n, low in zip(voxel, self.origin, strict=True)
        )
        return x, y, z

    def contains(self, voxel: VoxelIndex) -> bool:
        """Return whether the voxel is on the map."""
        return all(0 <= n < size for n, size in zip(voxel, self.shape, strict=True))


def voxel_map(room: Room, resolution: float, hull: HullCylinder, keep: float) -> VoxelMap:
    """Return the voxels of a room with nothing in it but what its model has.

    Args:
        room: solids, floor and ceiling.
        resolution: edge of a voxel [m].
        hull: of the drone.
        keep: the hull keeps this from everything [m].
    """
    return with_rows(empty_map(room, resolution, hull, keep), room_rows(room))


def empty_map(room: Room, resolution: float, hull: HullCylinder, keep: float) -> VoxelMap:
    """Return the voxels of a room without any solid, as ``voxel_map`` otherwise."""
    x_min, y_min, x_max, y_max = room.bounds
    sizes = (x_max - x_min, y_max - y_min, room.height)
    nx, ny, nz = (max(1, round(size / resolution)) for size in sizes)
    everywhere = np.ones((nx, ny, nz), dtype=np.bool_)
    empty = np.full((nx, ny, nz), CLEARANCE_CAP, dtype=np.float32)
    return VoxelMap((x_min, y_min, 0.0), resolution, hull, keep, empty, everywhere)


def with_rows(static: VoxelMap, rows: FloatArray) -> VoxelMap:
    """Return the map with more solids in it; the very same map when there are none."""
    if not len(rows):
        return static
    clearance = static.clearance.copy()
    whole = (0, static.shape[0], 0, static.shape[1], 0, static.shape[2])
    lower_clearance(
        rows, static.origin, static.resolution, static.hull, CLEARANCE_CAP, whole, clearance
    )
    return replace(static, clearance=clearance)


def within_heights(voxels: VoxelMap, low: float, high: float, usual: float) -> VoxelMap:
    """Return the map without the heights that are not flown at; the usual one is always open.

    Args:
        voxels: the map.
        low: the middle of the hull is not lower [m] ...
        high: ... nor higher [m].
        usual: the usual height [m].
    """
    zs = voxels.origin[2] + (np.arange(voxels.shape[2]) + 0.5) * voxels.resolution
    is_flown = (zs >= low) & (zs <= high)
    is_flown |= np.abs(zs - usual) <= 0.5 * voxels.resolution + 1e-9
    return replace(voxels, allowed=voxels.allowed & is_flown)
