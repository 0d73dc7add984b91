"""An occupancy grid as browsers draw it."""

from __future__ import annotations

from housefly.hub.api.pilot_queries import GridView
from housefly.room.grid import Cell, OccupancyGrid

_CELL_LETTERS = {
    Cell.FREE: ".",
    Cell.OCCUPIED: "#",
    Cell.VIRTUAL: "v",
    Cell.INFLATED: "i",
    Cell.OUTSIDE: "x",
}


def grid_view(grid: OccupancyGrid) -> GridView:
    """Return an occupancy grid as rows of letters, lowest y first."""
    width, height = grid.cells.shape
    letters = [_CELL_LETTERS[Cell(value)] for value in range(len(_CELL_LETTERS))]
    rows = tuple("".join(letters[value] for value in grid.cells[:, row]) for row in range(height))
    return GridView(grid.origin, grid.resolution, width, height, rows)
