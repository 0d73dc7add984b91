"""Parts of the room that are set apart by order: to keep out of, to keep in, to fly slowly in."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import Enum
from math import inf

import numpy as np

from housefly.geometry import Vec2
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.voxels import VoxelMap, VoxelMask
from housefly.room.polygon import in_polygon


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
    plan = in_polygon(volume.polygon, xs[:, None], ys[None, :])
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


def speeds_at(volumes: Iterable[Volume], places: FloatArray) -> FloatArray:
    """Return the highest speed by order at places [m/s], infinite without one, shape (n,).

    Args:
        volumes: those that are not SLOW do not count.
        places: [m], shape (n, 3).
    """
    speeds = np.full(len(places), inf)
    for volume in volumes:
        if volume.kind is VolumeKind.SLOW:
            inside = in_polygon(volume.polygon, places[:, 0], places[:, 1])
            inside &= (places[:, 2] >= volume.bottom) & (places[:, 2] <= volume.top)
            speeds[inside] = np.minimum(speeds[inside], volume.speed)
    return speeds
