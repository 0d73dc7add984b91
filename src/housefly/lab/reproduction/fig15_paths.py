"""Figs. 15 and 16: room, start and goal; the path as planned and as flown, in both modes."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Circle

from housefly.geometry import Vec2, distance
from housefly.lab.reproduction.drawing import write_figure
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.fig07_grid import paint_grid
from housefly.lab.reproduction.flight import FlightTracks
from housefly.messages import Phase
from housefly.record.places import distances_to_path
from housefly.room.grid import Cell, OccupancyGrid
from housefly.theme import GREEN, LIGHT, ORANGE

_SHADES = {
    Cell.FREE: LIGHT.paper,
    Cell.OCCUPIED: LIGHT.wall,
    Cell.VIRTUAL: LIGHT.virtual,
    Cell.INFLATED: LIGHT.margin,
    Cell.OUTSIDE: LIGHT.outside,
}


def draw_fig15_and_16(
    folder: Path,
    paper: tuple[OccupancyGrid, FlightTracks],
    default: tuple[OccupancyGrid, FlightTracks],
    goal: Vec2,
) -> tuple[Exhibit, Exhibit]:
    """Draw both figures."""
    grid, flight = paper
    start = flight.path[0]
    write_figure(
        folder, "fig15", (9.0, 3.7), lambda figure: _ends(figure.subplots(), grid, start, goal)
    )
    write_figure(folder, "fig16", (9.0, 7.4), lambda figure: _both(figure, paper, default, goal))
    numbers = [_words(mode, one) for mode, one in (("paper", flight), ("default", default[1]))]
    return (
        Exhibit(
            "15",
            "Room map, start and target",
            "fig15",
            "The grid with initial and target position.",
            f"From the pad at ({start[0]:.1f}, {start[1]:.1f}) m to ({goal[0]:.1f}, {goal[1]:.1f})"
            " m before the entrance.",
        ),
        Exhibit(
            "16",
            "Planned and flown trajectory",
            "fig16",
            "The planned trajectory; what was flown is not drawn and no error is given.",
            " ".join(numbers),
        ),
    )


def _words(mode: str, flight: FlightTracks) -> str:
    off = distances_to_path(flight.true[flight.true_during(Phase.OUTBOUND), :2], flight.path)
    length = sum(distance(a, b) for a, b in pairwise(flight.path))
    return (
        f"Mode {mode}: {length:.1f} m in {len(flight.path)} waypoints; flown"
        f" {100 * np.sqrt(np.mean(off**2)):.1f} cm off the way (root mean square),"
        f" {100 * off.max():.0f} cm at most, on the way there, in truth."
    )


def _ends(axes: Any, grid: OccupancyGrid, start: Vec2, goal: Vec2) -> None:
    paint_grid(axes, grid, None)
    _mark(axes, start, LIGHT.accent, "start")
    _mark(axes, goal, ORANGE, "target")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def _mark(axes: Any, place: Vec2, colour: str, name: str) -> None:
    axes.add_patch(Circle(place, 0.17, facecolor=colour, edgecolor="black", zorder=4, label=name))


def _both(
    figure: Any,
    paper: tuple[OccupancyGrid, FlightTracks],
    default: tuple[OccupancyGrid, FlightTracks],
    goal: Vec2,
) -> None:
    upper, lower = figure.subplots(2, 1)
    for axes, (grid, flight), title in (
        (upper, paper, "mode paper"),
        (lower, default, "mode default"),
    ):
        if grid is paper[0]:
            paint_grid(axes, grid, None)
        else:
            paint_fine_grid(axes, grid)
        out, back = (
            flight.true_during(Phase.OUTBOUND, Phase.LOOKING),
            flight.true_during(Phase.RETURNING),
        )
        path = np.array(flight.path)
        axes.plot(
            path[:, 0],
            path[:, 1],
            color=ORANGE,
            linestyle="--",
            marker="o",
            markersize=3,
            linewidth=1.5,
            label="planned",
        )
        axes.plot(
            flight.true[out, 0],
            flight.true[out, 1],
            color=LIGHT.accent,
            linewidth=1.5,
            label="flown there",
        )
        axes.plot(
            flight.true[back, 0],
            flight.true[back, 1],
            color=GREEN,
            linewidth=1.2,
            label="flown back",
        )
        axes.set_xlim(
            paper[0].origin[0] - 0.1,
            paper[0].origin[0] + paper[0].cells.shape[0] * paper[0].resolution + 0.1,
        )
        axes.set_ylim(
            paper[0].origin[1] - 0.1,
            paper[0].origin[1] + paper[0].cells.shape[1] * paper[0].resolution + 0.1,
        )
        axes.set_title(title)
        axes.legend(loc="lower center", bbox_to_anchor=(0.62, 1.0), ncols=3)


def paint_fine_grid(axes: Any, grid: OccupancyGrid) -> None:
    """Paint the cells of a fine grid, one shade per kind."""
    (x, y), (nx, ny), edge = grid.origin, grid.cells.shape, grid.resolution
    shades = ListedColormap([_SHADES[cell] for cell in Cell])
    axes.imshow(
        grid.cells.T,
        origin="lower",
        extent=(x, x + nx * edge, y, y + ny * edge),
        cmap=shades,
        vmin=0,
        vmax=len(Cell) - 1,
    )
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
