"""What never changes of a room in space: made once for all flights of a site in the same room."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from housefly.config.site import Site
from housefly.config.twin import TwinConfig
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import HullCylinder
from housefly.pilot.planning.space.costs import above_things, blindness, height_wish
from housefly.pilot.planning.space.doors import DoorMap, site_heights
from housefly.pilot.planning.space.reachability import within_reach
from housefly.pilot.planning.space.site_volumes import site_volumes
from housefly.pilot.planning.space.solid_rows import filled_rows
from housefly.pilot.planning.space.volumes import Volume, within_volumes
from housefly.pilot.planning.space.voxels import (
    VoxelMap,
    VoxelMask,
    empty_map,
    with_rows,
    within_heights,
)
from housefly.room.distance import half_diagonal
from housefly.room.model import Room
from housefly.room.tracked import untracked

HEIGHT_GAIN, BLIND_GAIN, ABOVE_GAIN = 0.3, 1.0, 1.0
"""What a metre off the usual height, air that tracking does not see, and air over furniture cost.
"""
_ROOMS_KEPT = 2
"""So many rooms are kept: flights follow flights in the same one."""


@dataclass(frozen=True, slots=True, eq=False)
class RoomSpace:
    """A room without what tracking sees and without what moves; nobody writes into it.

    Attributes:
        hull: the cylinder around the drone's.
        keep: it keeps this from everything [m].
        solids: rows of the room (``solid_rows.filled_rows``), shape (n, 11).
        open_air: where no order forbids to fly, shape (nx, ny, nz).
        static: the voxels that can be reached from home.
        dear: what does not change of the weights of the search, shape (nx, ny, nz), read-only.
        volumes: set apart by order.
        doors: ways through doors.
    """

    hull: HullCylinder
    keep: float
    solids: FloatArray
    open_air: VoxelMask
    static: VoxelMap
    dear: FloatArray
    volumes: tuple[Volume, ...]
    doors: DoorMap


def room_space(site: Site, room: Room) -> RoomSpace:
    """Return the space of a room; the pilot knows nothing of the twin, so neither does it."""
    return _room_space(site.model_copy(update={"twin": TwinConfig()}), room)


@lru_cache(maxsize=_ROOMS_KEPT)
def _room_space(site: Site, room: Room) -> RoomSpace:
    hull = HullCylinder(
        half_diagonal(site.drone.hull_length, site.drone.hull_width), site.drone.hull_height / 2
    )
    keep = site.map.tracking_bound + site.map.margin
    bare, volumes = untracked(room, site), site_volumes(site)
    solids = filled_rows(bare, site.map.flight_height)
    empty = empty_map(bare, site.map.voxel, hull, keep)
    within = within_volumes(within_heights(empty, *site_heights(site)), volumes)
    static = within_reach(with_rows(within, solids), room.home)
    dear = height_wish(empty, site.map.flight_height, HEIGHT_GAIN)
    dear += blindness(empty, room, BLIND_GAIN)
    dear += above_things(empty, solids, ABOVE_GAIN)
    dear.setflags(write=False)
    doors = DoorMap(site, bare, solids, volumes, keep)
    return RoomSpace(hull, keep, solids, within.allowed, static, dear, volumes, doors)
