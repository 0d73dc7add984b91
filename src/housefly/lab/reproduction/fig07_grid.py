"""Fig. 7: the occupancy grid of 25 x 9 cells with the drone in it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch, Rectangle

from housefly.geometry import Vec2
from housefly.lab.reproduction.drawing import write_figure
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.room.grid import Cell, OccupancyGrid

_FREE, _OBSTACLE, _VIRTUAL, _DRONE = "#ffffff", "#000000", "#5a5a5a", "#9a9a9a"
_HATCH = "////"


def draw_fig07(folder: Path, grid: OccupancyGrid, drone: Vec2) -> Exhibit:
    """Draw the grid of mode paper: free white, obstacle black, drone grey, as in the paper."""
    free, blocked, outside, virtual = (
        int((grid.cells == cell).sum())
        for cell in (Cell.FREE, Cell.OCCUPIED, Cell.OUTSIDE, Cell.VIRTUAL)
    )
    nx, ny = grid.cells.shape
    write_figure(
        folder, "fig07", (9.0, 3.7), lambda figure: paint_grid(figure.subplots(), grid, drone)
    )
    return Exhibit(
        "7",
        "Occupancy grid",
        "fig07",
        "A 2-D grid of the room: white squares are free, black ones obstacles, the grey one is the"
        " drone.",
        f"B-sen cut at the flight height: {nx} x {ny} = {nx * ny} cells of {grid.resolution:g} m,"
        f" {blocked} blocked by things and walls, {outside} behind walls, {virtual} blocked by"
        f" virtual obstacles of the site file (hatched), {free} free. The paper counts 255.",
    )


def paint_grid(axes: Any, grid: OccupancyGrid, drone: Vec2 | None) -> None:
    """Paint the cells on axes in metres."""
    (x, y), (nx, ny), edge = grid.origin, grid.cells.shape, grid.resolution
    picture = np.where(grid.cells == Cell.FREE, 0, 1)
    extent = (x, x + nx * edge, y, y + ny * edge)
    axes.imshow(
        picture.T,
        origin="lower",
        extent=extent,
        cmap=ListedColormap([_FREE, _OBSTACLE]),
        vmin=0,
        vmax=1,
    )
    for ix, iy in np.argwhere(grid.cells == Cell.VIRTUAL):
        corner = (x + ix * edge, y + iy * edge)
        axes.add_patch(
            Rectangle(
                corner,
                edge,
                edge,
                facecolor=_VIRTUAL,
                edgecolor="white",
                hatch=_HATCH,
                linewidth=0.0,
            )
        )
    for index in range(nx + 1):
        axes.axvline(x + index * edge, color="#c8c8c8", linewidth=0.5)
    for index in range(ny + 1):
        axes.axhline(y + index * edge, color="#c8c8c8", linewidth=0.5)
    handles = [
        Patch(facecolor=_FREE, edgecolor="#888888", label="free"),
        Patch(facecolor=_OBSTACLE, label="obstacle"),
    ]
    handles.append(
        Patch(facecolor=_VIRTUAL, edgecolor="white", hatch=_HATCH, label="virtual obstacle")
    )
    if drone is not None:
        ix, iy = grid.cell_of(drone)
        axes.add_patch(
            Rectangle(
                (x + ix * edge, y + iy * edge), edge, edge, facecolor=_DRONE, edgecolor="#333333"
            )
        )
        handles.append(Patch(facecolor=_DRONE, edgecolor="#333333", label="drone"))
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_aspect("equal")
    axes.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4)
