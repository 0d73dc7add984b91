"""The report's map: grid, furniture, planned and flown path."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from housefly.geometry import Vec2
from housefly.messages import Phase
from housefly.record import svg
from housefly.record.series import FlightSeries
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.model import Room
from housefly.room.outline import outline

_CELLS = (
    (Cell.OUTSIDE, svg.OUTSIDE_FILL, "", "outside"),
    (Cell.INFLATED, svg.INFLATED_FILL, "", "too close"),
    (Cell.VIRTUAL, svg.VIRTUAL_FILL, "////", "kept free"),
    (Cell.OCCUPIED, svg.OCCUPIED_FILL, "", "occupied"),
)
_WIDTH = 10.4
"""Width of every picture of the report [inch]."""


def map_svg(flight: FlightSeries, room: Room, grid: OccupancyGrid) -> str:
    """Return the plan of the room with the planned and the flown path."""
    x_min, y_min, x_max, y_max = room.bounds
    with svg.drawing("map"):
        figure = Figure(
            figsize=(_WIDTH, min(12.0, 0.92 * _WIDTH * (y_max - y_min) / (x_max - x_min) + 0.75)),
            layout="constrained",
        )
        axes = figure.add_subplot()
        handles = _draw_cells(axes, grid)
        _draw_furniture(axes, room)
        handles += _draw_flight(axes, flight)
        _draw_points(axes, room, flight)
        axes.set(
            xlim=(x_min - 0.1, x_max + 0.1),
            ylim=(y_min - 0.1, y_max + 0.1),
            aspect="equal",
            xlabel="x [m]",
            ylabel="y [m]",
        )
        axes.grid(visible=False)
        figure.legend(handles=handles, loc="outside lower center", ncols=7)
        return svg.to_svg(
            figure, "Map of the room with the planned path and the way that was flown"
        )


def _draw_cells(axes: Axes, grid: OccupancyGrid) -> list[Patch | Line2D]:
    handles: list[Patch | Line2D] = []
    for cell, colour, hatch, label in _CELLS:
        boxes = list(_boxes(grid, cell))
        if boxes:
            # Edges of the same colour hide the seams between neighbouring boxes.
            axes.add_collection(
                PolyCollection(
                    boxes, facecolor=colour, edgecolor=colour, linewidth=0.4, hatch=hatch, zorder=1
                )
            )
            handles.append(Patch(facecolor=colour, edgecolor=svg.LINE, hatch=hatch, label=label))
    return handles


def _boxes(grid: OccupancyGrid, cell: Cell) -> Iterator[list[Vec2]]:
    """Yield the corners of boxes that cover the cells of one kind: runs along x, merged along y."""
    open_runs: dict[tuple[int, int], int] = {}
    for row in range(grid.cells.shape[1] + 1):
        runs = _runs(grid.cells[:, row] == cell) if row < grid.cells.shape[1] else set()
        for run in open_runs.keys() - runs:
            yield _corners(grid, run, open_runs.pop(run), row)
        for run in runs - open_runs.keys():
            open_runs[run] = row


def _runs(marked: NDArray[np.bool_]) -> set[tuple[int, int]]:
    """Return first and one past last index of each run of marked cells."""
    changes = np.diff(np.concatenate(([0], marked.astype(np.int8), [0])))
    return set(
        zip(
            np.flatnonzero(changes == 1).tolist(),
            np.flatnonzero(changes == -1).tolist(),
            strict=True,
        )
    )


def _corners(grid: OccupancyGrid, run: tuple[int, int], first_row: int, end_row: int) -> list[Vec2]:
    x0, x1 = (grid.origin[0] + column * grid.resolution for column in run)
    y0, y1 = (grid.origin[1] + row * grid.resolution for row in (first_row, end_row))
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def _draw_furniture(axes: Axes, room: Room) -> None:
    outlines = [outline(solid) for solid in room.solids if solid.collides]
    axes.add_collection(
        PolyCollection(
            outlines, facecolor="none", edgecolor=svg.FURNITURE_LINE, linewidth=0.7, zorder=2
        )
    )


def _draw_flight(axes: Axes, flight: FlightSeries) -> list[Patch | Line2D]:
    planned = Line2D([], [], color=svg.SECONDARY, linestyle=(0, (4, 3)), label="planned")
    flown = Line2D([], [], color=svg.ACCENT, linewidth=2.4, label="flown")
    for path in flight.paths:
        axes.plot(*np.array(path.waypoints).T, color=svg.SECONDARY, linestyle=(0, (4, 3)), zorder=4)
    if len(flight.sighting):
        axes.plot(
            flight.sighting[:, 0], flight.sighting[:, 1], color=svg.ACCENT, linewidth=2.4, zorder=3
        )
    return [planned, flown]


def _draw_points(axes: Axes, room: Room, flight: FlightSeries) -> None:
    for place in room.places:
        _mark(axes, place.viewpoint, ".", place.title or place.name, svg.MUTED)
    _mark(axes, room.home, "s", "", svg.TEXT)
    if room.visitor is not None:
        _mark(axes, room.visitor, "o", "visitor", svg.TEXT)
    outbound = flight.path[flight.during(Phase.OUTBOUND) & (flight.path >= 0)]
    if outbound.size:
        _mark(axes, flight.paths[outbound[-1]].waypoints[-1], "*", "", svg.ACCENT)


def _mark(axes: Axes, point: Vec2, marker: str, label: str, colour: str) -> None:
    axes.plot(*point, marker=marker, markersize=8, color=colour, linestyle="none", zorder=5)
    axes.annotate(
        label,
        point,
        xytext=(6, 6),
        textcoords="offset points",
        color=svg.TEXT,
        fontsize=8,
        zorder=6,
    )
