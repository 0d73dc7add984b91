"""Ways through doors: where the hull's disc does not fit, but the hull itself does.

A second map, finer, has the disc of the hull's half width. Its voxels where the larger disc does
not fit are dear, and only those on the way are opened, so the drone turns where it has room. The
proof is not the map: the hull with its heading is measured at every row that is flown.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.costs import height_wish, narrowness
from housefly.pilot.planning.space.door_headings import door_headings
from housefly.pilot.planning.space.moment import straightened_cells, voxel_at
from housefly.pilot.planning.space.oriented_hull import OrientedHull, oriented_clearances
from housefly.pilot.planning.space.reachability import within_reach
from housefly.pilot.planning.space.search import CellSearch
from housefly.pilot.planning.space.volumes import Volume, within_volumes
from housefly.pilot.planning.space.voxels import (
    CLEARANCE_CAP,
    VoxelMap,
    VoxelMask,
    empty_map,
    with_rows,
    within_heights,
)
from housefly.pilot.planning.trajectory.speed_limits import MotionLimits
from housefly.pilot.planning.trajectory.timing import TICK, KinematicState
from housefly.pilot.planning.trajectory.trajectory import Trajectory, trajectory_along
from housefly.room.model import Room

FINE = 0.05
"""Edge of a voxel: a door leaves less than half of a coarser one [m]."""
DOOR_GIVES = (0.02, 0.005)
"""The map of the narrow hull keeps this much less than ``keep`` [m]. With the first a door of 0.8 m
holds middles of voxels however it is turned; with the second the curve is more in its middle.
"""
DOOR_SPEED = 0.4
"""Highest speed where the disc does not fit [m/s]."""
DOOR_WEIGHT = 6.0
"""What a voxel costs beside its length in which only the narrow hull fits."""
OPENED_AROUND = 0.3
"""Such voxels are opened this far around the way [m]."""
TURN_RATE = 0.9
"""Highest rate of the heading [rad/s]."""
TIGHT_MORE = 0.02
"""Where the disc has so much more than is proven, the heading is free [m]."""
_WIDE, _NARROW_GAIN = 0.35, 4.0


@dataclass(frozen=True, slots=True, eq=False)
class _NarrowWay:
    """A way of the narrow hull.

    Attributes:
        voxels: the map that it was found in.
        cells: of the way, shape (n, 3).
        opened: where the hull may be, tight only beside the way.
        weights: what a voxel costs beside its length.
    """

    voxels: VoxelMap
    cells: NDArray[Any]
    opened: VoxelMask
    weights: FloatArray


class DoorMap:
    """The fine map of a room for the hull with its heading."""

    def __init__(
        self, site: Site, room: Room, solids: FloatArray, volumes: tuple[Volume, ...], keep: float
    ) -> None:
        drone, limits = site.drone, site.limits
        self._hull = OrientedHull(
            drone.hull_length / 2, drone.hull_width / 2, drone.hull_height / 2
        )
        disc = HullCylinder(float(np.hypot(*self._hull[:2])), self._hull.half_height)
        narrow = HullCylinder(min(self._hull[:2]), self._hull.half_height)
        self._least = site.map.tracking_bound
        self._rate = min(TURN_RATE, limits.yaw_rate_max)
        self._wide = self._map(site, room, solids, volumes, disc, keep)
        self._narrow = within_reach(
            self._map(site, room, solids, volumes, narrow, keep - max(DOOR_GIVES)), room.home
        )
        self._dear = height_wish(self._narrow, site.map.flight_height, 0.3)

    @staticmethod
    def _map(
        site: Site,
        room: Room,
        solids: FloatArray,
        volumes: tuple[Volume, ...],
        hull: HullCylinder,
        keep: float,
    ) -> VoxelMap:
        empty = empty_map(room, FINE, hull, keep)
        return with_rows(
            within_volumes(within_heights(empty, *site_heights(site)), volumes), solids
        )

    def trajectory(
        self,
        live: FloatArray,
        rows: FloatArray,
        start: KinematicState,
        goal: FloatArray,
        yaw: float,
        limits: MotionLimits,
        zones: Callable[[FloatArray], FloatArray] | None,
    ) -> Trajectory | None:
        """Return a trajectory with headings to rest at a goal, or None.

        Args:
            live: what is not of the room, shape (m, 11).
            rows: everything, shape (n, 11).
            start: where the reference is and how it moves.
            goal: [m], shape (3,).
            yaw: heading at the start [rad].
            limits: of the drone.
            zones: highest speeds by order, as ``trajectory_along`` takes them.
        """
        here, there = voxel_at(self._narrow, start.place), voxel_at(self._narrow, goal)
        if not all(self._narrow.contains(voxel) for voxel in (here, there)):
            return None
        if not (self._narrow.allowed[here] and self._narrow.allowed[there]):
            return None
        narrow = with_rows(self._narrow, live)
        maps = [replace(narrow, keep=self._wide.keep - give) for give in DOOR_GIVES]
        # Searching a whole map takes longer than the step may: not where there can be no way.
        maps = [voxels for voxels in maps if voxels.is_free(here) and voxels.is_free(there)]
        if not maps:
            return None
        wide = with_rows(self._wide, live).free()
        for voxels in maps:
            found = self._searched(voxels, wide, start, goal)
            if found is None:  # each map is free only where the one before it is
                return None
            flight = self._through(found, rows, start, goal, limits, zones)
            proven = None if flight is None else self._proven(flight, rows, yaw)
            if proven is not None:
                return proven
        return None

    def _searched(
        self, voxels: VoxelMap, wide: VoxelMask, start: KinematicState, goal: FloatArray
    ) -> _NarrowWay | None:
        """Return the voxels of a way of the narrow hull, or None."""
        free = voxels.free()
        is_tight = free & ~wide
        weights = narrowness(voxels, _WIDE, _NARROW_GAIN) + self._dear + DOOR_WEIGHT * is_tight
        ends = voxel_at(voxels, start.place), voxel_at(voxels, goal)
        cells = np.array(CellSearch(free, weights).path(*ends).cells)
        if not len(cells):
            return None
        opened = _opened(free, is_tight, cells, voxels.resolution)
        return _NarrowWay(voxels, cells, opened, weights)

    def _through(
        self,
        way: _NarrowWay,
        rows: FloatArray,
        start: KinematicState,
        goal: FloatArray,
        limits: MotionLimits,
        zones: Callable[[FloatArray], FloatArray] | None,
    ) -> Trajectory | None:
        """Return a trajectory of the narrow hull that is tight only where it must be, or None."""
        voxels, opened = way.voxels, way.opened
        search = CellSearch(opened, way.weights)
        corners = straightened_cells(voxels, search, way.cells, start.place, goal)
        slow = limits._replace(narrow_speed=min(limits.narrow_speed, DOOR_SPEED))
        return trajectory_along(voxels, opened, rows, corners, start, slow, zones)

    def _proven(self, flight: Trajectory, rows: FloatArray, yaw: float) -> Trajectory | None:
        """Return the trajectory with headings that keep the hull off everything, or None.

        Where turning on the way is too late, the drone turns first: it stands.
        """
        disc = hull_clearances(rows, np.ascontiguousarray(flight.rows[:, :3]), self._wide.hull, 1.0)
        is_tight = disc < self._least + TIGHT_MORE
        turned = door_headings(flight.rows, is_tight, rows, self._hull, yaw, self._rate * TICK)
        if turned is None:
            return None
        yaws, waited = turned
        motion = np.vstack((np.repeat(flight.rows[:1], waited, axis=0), flight.rows))
        poses = np.hstack((motion[:, :3], yaws[:, None]))
        near = float(oriented_clearances(rows, poses, self._hull, CLEARANCE_CAP).min())
        if near < self._least:
            return None
        return replace(flight, rows=motion, clearance=near, yaws=yaws)


def site_heights(site: Site) -> tuple[float, float, float]:
    """Return the lowest and the highest height that is planned at, and the usual one [m]."""
    give = site.map.tracking_bound
    low, high = site.limits.height_min + give, site.limits.height_max - give
    return low, high, site.map.flight_height


def _opened(free: VoxelMask, is_tight: VoxelMask, cells: FloatArray, edge: float) -> VoxelMask:
    """Return the free voxels without those tight ones that are not around the way."""
    opened = free & ~is_tight
    reach = ceil(OPENED_AROUND / edge)
    for cell in cells[is_tight[tuple(cells.T)]]:
        box = tuple(slice(max(0, n - reach), n + reach + 1) for n in cell)
        opened[box] = free[box]
    opened[tuple(cells.T)] = True
    return opened
