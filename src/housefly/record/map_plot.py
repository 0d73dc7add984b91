"""The report's map: grid, furniture, planned and flown path."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Ellipse, Patch
from numpy.typing import NDArray

from housefly.geometry import Vec2
from housefly.messages import Phase
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.record import svg
from housefly.record.series import STATUSES, FlightSeries
from housefly.record.speed_plots import draw_planned
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.model import Room
from housefly.room.outline import outline

_CELLS = (
    (Cell.OUTSIDE, svg.OUTSIDE_FILL, "", "outside"),
    (Cell.INFLATED, svg.INFLATED_FILL, "", "too close"),
    (Cell.VIRTUAL, svg.VIRTUAL_FILL, "////", "kept free"),
    (Cell.OCCUPIED, svg.OCCUPIED_FILL, "", "occupied"),
)
_MAGNIFIED = 20.0
"""A sigma is some millimetres in a room of metres."""
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
        figure.legend(handles=handles, loc="outside lower center", ncols=5)
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
    planned_in_space = draw_planned(axes, flight)
    # Over a curve as wide as a speed's colour needs to be, what was flown is thin and dark.
    colour, width = (svg.TEXT, 1.2) if planned_in_space else (svg.ACCENT, 2.4)
    flown = Line2D([], [], color=colour, linewidth=width, label="flown")
    handles: list[Patch | Line2D] = [flown]
    flat = [path for path, planned in zip(flight.paths, flight.planned, strict=True) if not planned]
    for path in flat:
        axes.plot(*np.array(path.waypoints).T, color=svg.SECONDARY, linestyle=(0, (4, 3)), zorder=4)
    if flat:
        planned = Line2D([], [], color=svg.SECONDARY, linestyle=(0, (4, 3)), label="planned")
        handles = [planned, *handles]
    if len(flight.sighting):
        axes.plot(
            flight.sighting[:, 0], flight.sighting[:, 1], color=colour, linewidth=width, zorder=3
        )
    handles += planned_in_space
    handles += _draw_uncertainty(axes, flight)
    return handles


def _draw_uncertainty(axes: Axes, flight: FlightSeries) -> list[Patch | Line2D]:
    """Draw one sigma each second of the flight, magnified: both axes share one variance."""
    known = np.isfinite(flight.position_std) & np.isfinite(flight.estimate[:, 0])
    known &= np.isin(flight.status, [STATUSES.index(one) for one in AIRBORNE_STATUSES])
    each = np.unique(np.floor(flight.time[known]), return_index=True)[1]
    places = flight.estimate[known][each, :2]
    sizes = 2.0 * _MAGNIFIED * flight.position_std[known][each]
    for (x, y), size in zip(places.tolist(), sizes.tolist(), strict=True):
        axes.add_patch(Ellipse((x, y), size, size, fill=False, edgecolor=svg.MUTED, zorder=5))
    label = f"1 sigma, {_MAGNIFIED:.0f} x"
    return [Line2D([], [], marker="o", markerfacecolor="none", color=svg.MUTED, linestyle="none",
                   label=label)] if len(places) else []  # fmt: skip


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
