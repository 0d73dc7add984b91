"""A room as viewpoints need it: where the drone may hover now, what hides, what tracking sees."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from housefly.config.site import Site
from housefly.geometry import Vec2, distance
from housefly.messages import Obstacle
from housefly.numeric import FloatArray
from housefly.pilot.navigator import ESCAPE_REACH, PLAN_HORIZON
from housefly.pilot.planning.column import StaticColumns
from housefly.pilot.planning.dijkstra import UNREACHED, CellDistances, distances
from housefly.pilot.planning.live import distances_for, live_grid
from housefly.pilot.planning.obstacles import obstacle_rows
from housefly.pilot.planning.people import may_be_person
from housefly.pilot.planning.people_map import HULL_MARGIN
from housefly.room.coverage import seen_by
from housefly.room.distance import half_diagonal
from housefly.room.grid import Cell, CellIndex, OccupancyGrid, inflation
from housefly.room.level_camera import LevelCamera
from housefly.room.model import Room
from housefly.room.reach import Mask
from housefly.room.sight import hiding_rows, upright_row
from housefly.room.tracked import untracked, untracked_grid

_PERSON_TOP = 1.8
"""People hide what is lower than this behind them [m]."""
_CAMERAS_NEEDED = 2
"""Tracking cameras that must see the drone."""


@dataclass(frozen=True, slots=True, eq=False)
class ReachableMap:
    """Where the drone can hover now.

    Attributes:
        grid: the map with obstacles, people grown by the distance kept from them.
        free: cells in which it may hover and tracking sees it.
        moves: to each of them from where the drone is, UNREACHED without a way.
        landable: cells with clear floor below, where a forced landing hurts nothing.
    """

    grid: OccupancyGrid
    free: Mask
    moves: CellDistances
    landable: Mask

    def open_cells(self, middle: Vec2, reach: float) -> tuple[FloatArray, FloatArray]:
        """Return the reachable free cells around a point: places [m], and the way to each [m].

        Args:
            middle: world xy [m].
            reach: how far from it [m].

        Returns:
            Shapes (n, 2) and (n,).
        """
        grid = self.grid
        i0, j0 = grid.cell_of((middle[0] - reach, middle[1] - reach))
        i1, j1 = grid.cell_of((middle[0] + reach, middle[1] + reach))
        i0, j0 = max(0, i0), max(0, j0)
        part = self.moves[i0 : max(i1 + 1, 0), j0 : max(j1 + 1, 0)]
        ix, iy = np.nonzero(part != UNREACHED)
        ix, iy = ix + i0, iy + j0
        places = np.array(grid.origin) + (np.column_stack([ix, iy]) + 0.5) * grid.resolution
        near = np.hypot(*(places - np.array(middle)).T) <= reach
        ways = self.moves[ix[near], iy[near]].astype(np.float64) * grid.resolution
        return places[near], ways

    def everywhere(self) -> ReachableMap:
        """Return the map as if every free cell could be reached at once."""
        moves = np.where(self.free, 0, UNREACHED).astype(np.int32)
        return ReachableMap(self.grid, self.free, moves, self.landable)

    def clearances(self, places: FloatArray) -> FloatArray:
        """Return the distance of places on the map from anything [m], shape (n,)."""
        found: FloatArray = self.grid.clearance[self._cells(places)]
        return found

    def can_land(self, places: FloatArray) -> Mask:
        """Return which places on the map have clear floor below, shape (n,)."""
        found: Mask = self.landable[self._cells(places)]
        return found

    def _cells(self, places: FloatArray) -> tuple[Any, Any]:
        index = np.floor((places - np.array(self.grid.origin)) / self.grid.resolution).astype(int)
        return index[:, 0], index[:, 1]


class ViewingRoom:
    """One site's room, read only.

    Args:
        site: distances kept, flight height.
        room: its solids and tracking cameras.
        grid: its map.

    Attributes:
        camera: the drone's.
    """

    def __init__(self, site: Site, room: Room, grid: OccupancyGrid) -> None:
        self.site, self.room = site, room
        self.camera = LevelCamera.of(site.drone.airframe.capabilities.camera)
        self._static = untracked_grid(room, site, grid)
        self._modelled = grid
        self._reach = distances_for(inflation(site), site.map.tracking_bound, grid.resolution).reach
        self._standing = untracked(room, site).solids

    @property
    def height(self) -> float:
        """The height that the drone flies at [m]."""
        return self.site.map.flight_height

    @property
    def grid(self) -> OccupancyGrid:
        """The map of the room as it was built."""
        return self._modelled

    @cached_property
    def _tracked(self) -> Mask:
        """Which cells enough tracking cameras see at flight height, shape of the map."""
        nx, ny = self._static.shape
        middles = np.array([self._static.centre_of((i, j)) for i in range(nx) for j in range(ny)])
        points = np.column_stack([middles, np.full(len(middles), self.height)])
        counts = seen_by(self.room, points).sum(axis=1).reshape(nx, ny)
        return np.asarray(counts >= min(_CAMERAS_NEEDED, len(self.room.cameras)), dtype=np.bool_)

    @cached_property
    def _landable(self) -> Mask:
        """Which cells have clear floor below, shape of the map."""
        grid, drone = self._static, self.site.drone
        columns = StaticColumns(self.room, self.height + self.site.map.half_band)
        (west, south), (nx, ny) = grid.origin, grid.shape
        x = west + np.arange(0.5, nx, dtype=np.float64) * grid.resolution
        y = south + np.arange(0.5, ny, dtype=np.float64) * grid.resolution
        hull = half_diagonal(drone.hull_length, drone.hull_width)
        return np.asarray(columns.clearances(x, y) > hull + HULL_MARGIN, dtype=np.bool_)

    def reachable(
        self, start: Vec2, obstacles: Iterable[Obstacle], kept: float, now: float
    ) -> ReachableMap:
        """Return where the drone can hover, keeping a distance from people.

        Args:
            start: where the drone is [m].
            obstacles: people and things that no map shows.
            kept: distance from people [m].
            now: time [s].
        """
        half = self.site.map.half_band
        band = self.height - half, self.height + half
        known = tuple(obstacles)
        rows, _ = obstacle_rows(known, now, PLAN_HORIZON, band, kept)
        # Without a word of tracked furniture it stands where the room model has it.
        told = any(not may_be_person(one) for one in known)
        static = self._static if told else self._modelled
        grid = live_grid(static, rows, self._reach)
        free = (grid.cells == Cell.FREE) & self._tracked
        moves = distances(free, _start_cell(grid, free, start))
        moves = np.where(free, moves, UNREACHED).astype(np.int32)
        return ReachableMap(grid, free, moves, self._landable)

    def hiding(
        self, own: frozenset[str], obstacles: Iterable[Obstacle], around: Vec2, apart: float
    ) -> FloatArray:
        """Return what hides: solids but for some names, obstacles but for those at a point.

        Args:
            own: names of solids that hide nothing.
            obstacles: people and things that no map shows.
            around: the subject, world xy [m].
            apart: obstacles nearer to it are the subject itself [m].
        """
        rows = [hiding_rows(solid for solid in self._standing if solid.name not in own)]
        for one in obstacles:
            reach = one.radius + max(one.size) / 2
            if distance(one.position, around) > apart + reach:
                top = min(one.top, _PERSON_TOP)
                rows.append(upright_row(*one.position, reach, one.bottom, top))
        return np.concatenate(rows)


def _start_cell(grid: OccupancyGrid, free: Mask, start: Vec2) -> CellIndex:
    """Return the drone's cell, or the nearest free one when its own is blocked."""
    nx, ny = grid.shape
    i, j = grid.cell_of(start)
    own = min(max(i, 0), nx - 1), min(max(j, 0), ny - 1)
    if free[own] or not free.any():
        return own
    ix, iy = np.nonzero(free)
    away = np.hypot(ix - own[0], iy - own[1])
    best = int(np.argmin(away))
    return (int(ix[best]), int(iy[best])) if away[best] * grid.resolution <= ESCAPE_REACH else own
