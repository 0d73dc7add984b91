"""The occupancy grid, computed from the room's solids at the flight height.

Rules; the first one that holds wins:

1. OCCUPIED: a footprint covers the middle of the cell or more than a quarter of it.
2. OUTSIDE: the floor there cannot be reached from the home pad, not even by a point (behind walls,
   inside furniture).
3. VIRTUAL: the middle of the cell lies in a virtual obstacle of the site file, a zone of its
   edits, or (not in mode ``paper``) at the flight height in a volume to keep out of, or outside
   those to keep in. These bound the middle of the drone, so they are not inflated.
4. INFLATED (not in mode ``paper``): the middle of the cell is closer to a footprint than half the
   hull's diagonal plus the tracking bound plus the margin.
5. FREE.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from math import floor, hypot

import numpy as np
from numpy.typing import NDArray

from housefly.config.edits import NoFlyZone
from housefly.config.map import VirtualObstacle
from housefly.config.site import Site
from housefly.geometry import Vec2
from housefly.numeric import FloatArray
from housefly.room.distance import clearance_field, covered_shares, footprints, half_diagonal
from housefly.room.model import Room
from housefly.room.polygon import in_polygon
from housefly.room.reach import reachable

CellIndex = tuple[int, int]
_Cells = NDArray[np.uint8]

_COVERED_SHARE = 0.25
"""A cell with more than this share under a footprint is occupied."""
_COORDINATE_MAX = 1e6
"""Points further away [m], or not finite, are on no grid; larger numbers overflow."""
_FINE_EDGE = 0.1
"""Largest cell edge for reachability [m]: walls are thinner than the paper's cells."""


class Cell(IntEnum):
    """What a cell of the grid is."""

    FREE = 0
    OCCUPIED = 1
    VIRTUAL = 2
    INFLATED = 3
    OUTSIDE = 4


@dataclass(frozen=True, slots=True, eq=False)
class OccupancyGrid:
    """Where the middle of the drone may be.

    Attributes:
        origin: lower left corner [m].
        resolution: edge of a cell [m].
        cells: ``Cell`` values, shape (nx, ny), read-only.
        clearance: distance from each cell's middle to the nearest real obstacle [m], shape (nx,
            ny), read-only.
    """

    origin: Vec2
    resolution: float
    cells: _Cells
    clearance: FloatArray

    def __post_init__(self) -> None:
        self.cells.setflags(write=False)
        self.clearance.setflags(write=False)

    @property
    def shape(self) -> CellIndex:
        """Number of cells along x and y."""
        nx, ny = self.cells.shape
        return nx, ny

    def cell_of(self, point: Vec2) -> CellIndex:
        """Return the cell of a point [m]; it may be off the grid, as are points of no room."""
        if not (abs(point[0]) <= _COORDINATE_MAX and abs(point[1]) <= _COORDINATE_MAX):
            return -1, -1
        return (
            floor((point[0] - self.origin[0]) / self.resolution),
            floor((point[1] - self.origin[1]) / self.resolution),
        )

    def centre_of(self, cell: CellIndex) -> Vec2:
        """Return the middle of a cell [m]."""
        return (
            float(self.origin[0] + (cell[0] + 0.5) * self.resolution),
            float(self.origin[1] + (cell[1] + 0.5) * self.resolution),
        )

    def contains(self, cell: CellIndex) -> bool:
        """Return whether the cell is on the grid."""
        nx, ny = self.shape
        return 0 <= cell[0] < nx and 0 <= cell[1] < ny

    def kind(self, cell: CellIndex) -> Cell:
        """Return what the cell is; OUTSIDE off the grid."""
        return Cell(self.cells[cell]) if self.contains(cell) else Cell.OUTSIDE

    def is_free(self, cell: CellIndex) -> bool:
        """Return whether the drone may be there."""
        return self.kind(cell) is Cell.FREE

    def clearance_at(self, point: Vec2) -> float:
        """Return the clearance [m] of a point, to half a cell diagonal; 0 off the grid."""
        cell = self.cell_of(point)
        return float(self.clearance[cell]) if self.contains(cell) else 0.0


def extent_of(grid: OccupancyGrid) -> tuple[float, float, float, float]:
    """Return x_min, y_min, x_max, y_max of a grid [m]."""
    (x, y), (nx, ny) = grid.origin, grid.cells.shape
    return x, y, x + nx * grid.resolution, y + ny * grid.resolution


def inflation(site: Site) -> float:
    """Return the inflation [m]: half hull diagonal + tracking bound + margin."""
    return (
        half_diagonal(site.drone.hull_length, site.drone.hull_width)
        + site.map.tracking_bound
        + site.map.margin
    )


def build_grid(room: Room, site: Site) -> OccupancyGrid:
    """Return the grid that the site's mode flies on.

    Mode ``paper`` covers ``map.paper_rectangle`` with cells of ``map.paper_resolution`` and grows
    nothing (25 x 9 cells with the defaults); mode ``default`` covers the whole room with cells of
    ``map.resolution``.
    """
    if site.mode == "paper":
        return _grid(
            room,
            site,
            site.map.paper_rectangle,
            site.map.paper_resolution,
            0.0,
            site.map.paper_virtual_obstacles,
        )
    virtual: tuple[VirtualObstacle | NoFlyZone, ...] = (
        *site.map.virtual_obstacles,
        *site.edits.zones,
    )
    grid = _grid(room, site, room.bounds, site.map.resolution, inflation(site), virtual)
    return _within_site_volumes(grid, site)


def _within_site_volumes(grid: OccupancyGrid, site: Site) -> OccupancyGrid:
    """Return the grid with what the site's volumes close at the flight height VIRTUAL."""
    height = site.map.flight_height
    if not site.volumes:
        return grid
    xs, ys = (
        low + (np.arange(count) + 0.5) * grid.resolution
        for low, count in zip(grid.origin, grid.shape, strict=True)
    )
    closed = np.zeros(grid.shape, dtype=np.bool_)
    kept = np.zeros(grid.shape, dtype=np.bool_)
    for volume in site.volumes:
        if volume.bottom <= height <= volume.top and volume.kind != "slow":
            target = closed if volume.kind == "keep_out" else kept
            target |= in_polygon(volume.polygon, xs[:, None], ys[None, :])
    if any(volume.kind == "keep_in" for volume in site.volumes):
        closed |= ~kept
    cells = grid.cells.copy()
    cells[closed & ((cells == Cell.FREE) | (cells == Cell.INFLATED))] = Cell.VIRTUAL
    return OccupancyGrid(grid.origin, grid.resolution, cells, grid.clearance)


def _grid(
    room: Room,
    site: Site,
    rectangle: tuple[float, float, float, float],
    resolution: float,
    keep: float,
    virtual: tuple[VirtualObstacle | NoFlyZone, ...],
) -> OccupancyGrid:
    rows = footprints(
        room.solids,
        site.map.flight_height - site.map.half_band,
        site.map.flight_height + site.map.half_band,
    )
    xs, ys = cell_middles(rectangle, resolution)
    cap = hypot(room.bounds[2] - room.bounds[0], room.bounds[3] - room.bounds[1])
    clearance = clearance_field(rows, xs, ys, cap)
    cells = np.full(clearance.shape, Cell.FREE, dtype=np.uint8)
    cells[clearance < keep] = Cell.INFLATED
    for obstacle in virtual:
        cells[in_rectangle(obstacle.rectangle, xs, ys)] = Cell.VIRTUAL
    cells[~_on_reachable_floor(room, rows, min(resolution, _FINE_EDGE), xs, ys, cap)] = Cell.OUTSIDE
    covered = covered_shares(rows, xs, ys, resolution, clearance) > _COVERED_SHARE
    cells[covered | (clearance == 0.0)] = Cell.OCCUPIED
    return OccupancyGrid((rectangle[0], rectangle[1]), resolution, cells, clearance)


def cell_middles(
    rectangle: tuple[float, float, float, float], resolution: float
) -> tuple[FloatArray, FloatArray]:
    """Return x and y of the middles of the cells that cover a rectangle [m]."""
    x_min, y_min, x_max, y_max = rectangle
    nx = max(1, round((x_max - x_min) / resolution))
    ny = max(1, round((y_max - y_min) / resolution))
    return (
        x_min + (np.arange(nx, dtype=np.float64) + 0.5) * resolution,
        y_min + (np.arange(ny, dtype=np.float64) + 0.5) * resolution,
    )


def in_rectangle(
    rectangle: tuple[float, float, float, float], xs: FloatArray, ys: FloatArray
) -> NDArray[np.bool_]:
    """Return which points of a grid lie in a rectangle, edges included [m]."""
    x_min, y_min, x_max, y_max = rectangle
    return ((xs >= x_min) & (xs <= x_max))[:, None] & ((ys >= y_min) & (ys <= y_max))[None, :]


def _on_reachable_floor(
    room: Room, rows: FloatArray, fine: float, xs: FloatArray, ys: FloatArray, cap: float
) -> NDArray[np.bool_]:
    """Return which points a point-sized drone can reach from home without touching a footprint."""
    fine_xs, fine_ys = cell_middles(room.bounds, fine)
    reached = reachable(
        clearance_field(rows, fine_xs, fine_ys, cap), fine_xs, fine_ys, fine, room.home
    )
    i = np.floor((xs - room.bounds[0]) / fine).astype(np.int64)
    j = np.floor((ys - room.bounds[1]) / fine).astype(np.int64)
    within = ((i >= 0) & (i < fine_xs.size))[:, None] & ((j >= 0) & (j < fine_ys.size))[None, :]
    inside: NDArray[np.bool_] = (
        reached[np.clip(i, 0, fine_xs.size - 1)][:, np.clip(j, 0, fine_ys.size - 1)] & within
    )
    return inside
