"""The box that an identification flight must stay in."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from housefly.errors import RoomError
from housefly.geometry import Vec2, Vec3, distance
from housefly.room.grid import OccupancyGrid

_HEIGHT_BAND = 0.7
"""The drone must stay within this distance of its flight height [m]."""


@dataclass(frozen=True, slots=True)
class Box:
    """A square of the floor plan around a point, and a band of height.

    Attributes:
        centre: world xy [m].
        reach: half its side [m].
        height: middle of the band [m].
    """

    centre: Vec2
    reach: float
    height: float

    def holds(self, position: Vec3) -> bool:
        """Return whether a point is inside."""
        x, y, z = position
        inside = abs(x - self.centre[0]) <= self.reach and abs(y - self.centre[1]) <= self.reach
        return inside and abs(z - self.height) <= _HEIGHT_BAND


def free_reach(grid: OccupancyGrid, centre: Vec2) -> float:
    """Return half the side of the largest free square around a point [m].

    Obstacles on the grid are already inflated by the hull.
    """
    here = grid.cell_of(centre)
    if not grid.contains(here) or not grid.is_free(here):
        return 0.0
    rings = 0
    while _is_free(grid, here, rings + 1):
        rings += 1
    return rings * grid.resolution


def find_box(grid: OccupancyGrid, start: Vec2, reach: float, height: float) -> Box:
    """Return the box of this reach whose centre is closest to ``start``.

    Raises:
        RoomError: no place has so much room; the message names the one with the most.
    """
    rings = ceil(reach / grid.resolution)
    free = np.argwhere(grid.cells == 0)
    nearest = sorted(
        ((int(ix), int(iy)) for ix, iy in free),
        key=lambda cell: distance(grid.centre_of(cell), start),
    )
    for cell in nearest:
        if _is_free(grid, cell, rings):
            return Box(grid.centre_of(cell), reach, height)
    best = max(nearest, key=lambda cell: free_reach(grid, grid.centre_of(cell)), default=None)
    if best is None:
        raise RoomError("the map has no free cell")
    x, y = grid.centre_of(best)
    raise RoomError(
        f"no free square of {2 * reach:.1f} m anywhere: the most room is"
        f" {2 * free_reach(grid, (x, y)):.1f} m around ({x:.1f}, {y:.1f}); clear some space, or"
        " give a smaller --box"
    )


def _is_free(grid: OccupancyGrid, cell: tuple[int, int], rings: int) -> bool:
    (ix, iy), (nx, ny) = cell, grid.cells.shape
    if ix - rings < 0 or iy - rings < 0 or ix + rings >= nx or iy + rings >= ny:
        return False
    return not grid.cells[ix - rings : ix + rings + 1, iy - rings : iy + rings + 1].any()
