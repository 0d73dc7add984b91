"""Straightens a cell path: a leg may go at any angle where every cell that it touches is free."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor
from typing import Any

from housefly.geometry import Vec2
from housefly.numeric import compiled
from housefly.room.grid import Cell, OccupancyGrid

_FREE = int(Cell.FREE)
TOUCH = 1e-6
"""Cells closer to the leg than this [cell edges] count as touched."""


@compiled
def _sees(cells: Any, x0: float, y0: float, x1: float, y1: float) -> bool:
    """Return whether all cells touched by the closed segment are free; in cell edges."""
    nx, ny = cells.shape
    if x1 < x0:
        x0, y0, x1, y1 = x1, y1, x0, y0
    first, last = floor(x0 - TOUCH), floor(x1 + TOUCH)
    low, high = floor(min(y0, y1) - TOUCH), floor(max(y0, y1) + TOUCH)
    if first < 0 or last >= nx or low < 0 or high >= ny:
        return False
    upright = x1 - x0 < TOUCH
    slope = 0.0 if upright else (y1 - y0) / (x1 - x0)
    for i in range(first, last + 1):
        bottom, top = low, high
        if not upright:
            ya = y0 + slope * (min(max(i - TOUCH, x0), x1) - x0)
            yb = y0 + slope * (min(max(i + 1 + TOUCH, x0), x1) - x0)
            bottom, top = floor(min(ya, yb) - TOUCH), floor(max(ya, yb) + TOUCH)
        for j in range(bottom, top + 1):
            if cells[i, j] != _FREE:
                return False
    return True


def sees(grid: OccupancyGrid, start: Vec2, end: Vec2) -> bool:
    """Return whether the straight line between two points [m] touches free cells only."""
    return bool(_sees(grid.cells, *_in_cells(grid, start), *_in_cells(grid, end)))


def straightened(grid: OccupancyGrid, points: Sequence[Vec2]) -> tuple[Vec2, ...]:
    """Return the points that are needed: from each fly straight to the farthest in sight.

    The result is never longer than the path given, and touches free cells only if that one does.
    """
    kept = [points[0]]
    at = 0
    while at < len(points) - 1:
        at = next(
            (k for k in range(len(points) - 1, at + 1, -1) if sees(grid, points[at], points[k])),
            at + 1,
        )
        kept.append(points[at])
    return tuple(kept)


def _in_cells(grid: OccupancyGrid, point: Vec2) -> Vec2:
    return (point[0] - grid.origin[0]) / grid.resolution, (
        point[1] - grid.origin[1]
    ) / grid.resolution
