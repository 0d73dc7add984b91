"""Parts of the room that are set apart by order: to keep out of, to keep in, to fly slowly in."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import Enum
from math import inf
from typing import Any

import numpy as np

from housefly.geometry import Vec2
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.voxels import VoxelMap, VoxelMask


class VolumeKind(Enum):
    """What a volume is for."""

    KEEP_OUT = "keep out"
    KEEP_IN = "keep in"
    SLOW = "slow"


@dataclass(frozen=True, slots=True)
class Volume:
    """A polygon with heights; it bounds the middle of the drone.

    Attributes:
        kind: what it is for.
        polygon: corners, at least three, either way round [m].
        bottom, top: heights [m].
        speed: highest speed in it, for SLOW [m/s].
        reason: shown to people.
    """

    kind: VolumeKind
    polygon: tuple[Vec2, ...]
    bottom: float = 0.0
    top: float = inf
    speed: float = inf
    reason: str = ""


def in_volume(voxels: VoxelMap, volume: Volume) -> VoxelMask:
    """Return whose middles lie in a volume, shape (nx, ny, nz); what lies on an edge may not."""
    nx, ny, nz = voxels.shape
    xs, ys, zs = (
        low + (np.arange(count) + 0.5) * voxels.resolution
        for low, count in zip(voxels.origin, (nx, ny, nz), strict=True)
    )
    plan = _in_polygon(volume.polygon, xs[:, None], ys[None, :])
    heights = (zs >= volume.bottom) & (zs <= volume.top)
    mask: VoxelMask = plan[:, :, None] & heights
    return mask


def within_volumes(voxels: VoxelMap, volumes: Iterable[Volume]) -> VoxelMap:
    """Return the map with keep-out volumes closed, and all but the keep-in volumes if any."""
    allowed, known = voxels.allowed.copy(), tuple(volumes)
    kept = [volume for volume in known if volume.kind is VolumeKind.KEEP_IN]
    if kept:
        allowed &= np.logical_or.reduce([in_volume(voxels, volume) for volume in kept])
    for volume in known:
        if volume.kind is VolumeKind.KEEP_OUT:
            allowed &= ~in_volume(voxels, volume)
    return replace(voxels, allowed=allowed)


def speed_limit(volumes: Iterable[Volume], voxels: VoxelMap, speed: float) -> FloatArray:
    """Return the highest speed in each voxel [m/s], shape (nx, ny, nz)."""
    limit = np.full(voxels.shape, speed)
    for volume in volumes:
        if volume.kind is VolumeKind.SLOW:
            inside = in_volume(voxels, volume)
            limit[inside] = np.minimum(limit[inside], volume.speed)
    return limit


def _in_polygon(polygon: tuple[Vec2, ...], x: Any, y: Any) -> VoxelMask:
    """Return which points are inside: a ray along x crosses an odd number of edges."""
    inside = np.zeros(np.broadcast_shapes(x.shape, y.shape), dtype=np.bool_)
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1], strict=True):
        if y0 != y1:
            across = (y0 > y) != (y1 > y)
            inside ^= across & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
    return inside
