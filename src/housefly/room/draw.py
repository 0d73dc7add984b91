"""Draws a room and its map: as an image, and as text for the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, ceil, cos, degrees, hypot, sin
from pathlib import Path
from string import ascii_uppercase, digits
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, Polygon, Rectangle
from matplotlib.patheffects import withStroke

from housefly.errors import RoomError
from housefly.geometry import Vec2, rotate
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.model import Room, Shape, Solid
from housefly.room.outline import outline
from housefly.theme import LIGHT

_CELL_LOOK: dict[Cell, tuple[str, str, str]] = {
    Cell.FREE: (LIGHT.paper, ".", "free"),
    Cell.OCCUPIED: (LIGHT.wall, "#", "occupied"),
    Cell.VIRTUAL: (LIGHT.virtual, "v", "virtual obstacle"),
    Cell.INFLATED: (LIGHT.margin, "+", "too close for the hull"),
    Cell.OUTSIDE: (LIGHT.outside, " ", "outside"),
}
_UNLABELLED = frozenset(
    {"wall", "window", "decoration", "home pad", "carpet", "room door", "unexplored"}
)
_INCHES_PER_METRE = 0.92
_TEXT_COLUMNS, _TEXT_ROWS = 78, 50
_ROUTE_MARK = "*"
_SPARE_MARKS = ascii_uppercase + digits
_LABEL_SPACING = 0.42
"""Labels closer than this to that of a larger thing are left out [m]."""


def draw_room(
    room: Room,
    grid: OccupancyGrid,
    path: Path,
    *,
    route: Sequence[Vec2] | None = None,
    trail: Sequence[Vec2] | None = None,
) -> None:
    """Write a PNG of the map with furniture, places, cameras and home.

    A planned route and a flown trail are drawn when given.

    Args:
        room: what stands where.
        grid: which cells are free.
        path: the PNG to write.
        route: planned waypoints [m].
        trail: flown positions [m].

    Raises:
        RoomError: the file cannot be written.
    """
    x_min, y_min, x_max, y_max = _frame(room, grid)
    scale = min(_INCHES_PER_METRE, 14.0 / (x_max - x_min), 14.0 / (y_max - y_min))
    width, height = max(5.0, (x_max - x_min) * scale), (y_max - y_min) * scale
    figure = Figure(figsize=(width + 0.6, height + 1.5), dpi=120, facecolor="white")
    FigureCanvasAgg(figure)
    axes = figure.add_axes(
        (0.4 / (width + 0.6), 0.85 / (height + 1.5), width / (width + 0.6), height / (height + 1.5))
    )
    _cells(axes, grid)
    for solid in sorted(room.solids, key=lambda s: s.position[2] + s.size[2] / 2):
        axes.add_patch(_patch(solid))
    _labels(axes, room)
    _cameras(axes, room)
    _lines(axes, route, trail)
    _landmarks(axes, room)
    _frame_and_legend(
        figure, axes, room, grid, (x_min, y_min, x_max, y_max), bool(route), bool(trail)
    )
    try:
        figure.savefig(path)
    except OSError as error:
        raise RoomError(f"{path} cannot be written: {error.strerror or error}") from error


def text_map(room: Room, grid: OccupancyGrid, route: Sequence[Vec2] = ()) -> str:
    """Return the map as text, north (+y) up, with a legend below.

    H is home, each other place has a capital letter of its own, * is the route. It fits a terminal
    of 80 columns, in proportion where a character is twice as high as wide: fine grids are thinned,
    a character shows the worst cell it stands for, blocked before free; of a coarse grid each cell
    is two characters.

    Args:
        room: what stands where.
        grid: which cells are free.
        route: waypoints of a path [m].
    """
    scale = _text_scale(grid)
    canvas = _canvas(grid, scale)
    on_route = 0
    for point in _points_along(route, grid.resolution / 2.0):
        on_route += _put(canvas, grid, scale, point, _ROUTE_MARK)
    marks = _marks([place.name for place in room.places])
    for place in reversed(room.places):
        at_home = place.name == "home"
        _put(canvas, grid, scale, room.home if at_home else place.viewpoint, marks[place.name])
    rows = ["".join(row).rstrip() for row in reversed(canvas)]
    while rows and not rows[0]:
        rows.pop(0)
    while rows and not rows[-1]:
        rows.pop()
    looks = [(letter, words) for _, letter, words in _CELL_LOOK.values() if letter != " "]
    legend = "  ".join(
        f"{letter} {words}" for letter, words in (*looks, *[(_ROUTE_MARK, "path")] * (on_route > 0))
    )
    names = "  ".join(f"{mark} {name}" for name, mark in marks.items())
    return "\n".join([*rows, "", legend, scale.words(grid.resolution), names])


@dataclass(frozen=True, slots=True)
class _TextScale:
    """So many cells a character stands for, across and up; or so many characters a cell is wide."""

    step: int
    rise: int
    width: int

    def words(self, edge: float) -> str:
        across, up = self.step * edge / self.width, self.rise * edge
        cells = f" ({self.step} x {self.rise} cells of {edge:g} m)" if self.rise > 1 else ""
        return f"one character: {across:g} m across, {up:g} m up{cells}"


def _text_scale(grid: OccupancyGrid) -> _TextScale:
    nx, ny = grid.shape
    if 2 * nx <= _TEXT_COLUMNS and ny <= _TEXT_ROWS:
        return _TextScale(1, 1, 2)
    step = max(-(-nx // _TEXT_COLUMNS), -(-ny // (2 * _TEXT_ROWS)))
    return _TextScale(step, 2 * step, 1)


def _canvas(grid: OccupancyGrid, scale: _TextScale) -> list[list[str]]:
    """Return a row of characters for each row of cells, south first."""
    (nx, ny), cells = grid.shape, np.array(grid.cells)
    rank = np.array([0, 4, 3, 2, 1])
    return [
        [
            _worst(cells[i : i + scale.step, j : j + scale.rise], rank)
            for i in range(0, nx, scale.step)
            for _ in range(scale.width)
        ]
        for j in range(0, ny, scale.rise)
    ]


def _put(
    canvas: list[list[str]], grid: OccupancyGrid, scale: _TextScale, point: Vec2, mark: str
) -> bool:
    """Put a mark where a point [m] is; return whether it is on the map."""
    i, j = grid.cell_of(point)
    if not grid.contains((i, j)):
        return False
    canvas[j // scale.rise][i // scale.step * scale.width] = mark
    return True


def _points_along(route: Sequence[Vec2], spacing: float) -> Iterator[Vec2]:
    """Yield points of a route, at most so far apart [m]."""
    for (x0, y0), (x1, y1) in pairwise(route):
        count = max(1, ceil(hypot(x1 - x0, y1 - y0) / spacing))
        for k in range(count + 1):
            yield x0 + (x1 - x0) * k / count, y0 + (y1 - y0) * k / count


def _marks(names: Sequence[str]) -> dict[str, str]:
    """Return a sign for each place: H for home, else the first letter of its name still free."""
    marks = {name: "H" for name in names if name == "home"}
    for name in names:
        if name in marks:
            continue
        free = [sign for sign in f"{name.upper()}{_SPARE_MARKS}" if sign in _SPARE_MARKS]
        taken = {"H", *marks.values()}
        marks[name] = next((sign for sign in free if sign not in taken), "?")
    return marks


def _worst(block: Any, rank: Any) -> str:
    values = block.ravel()
    return _CELL_LOOK[Cell(int(values[np.argmax(rank[values])]))][1]


def _frame(room: Room, grid: OccupancyGrid) -> tuple[float, float, float, float]:
    """Return the part of the plan worth drawing [m]: solids, inside cells, a margin."""
    inside = np.argwhere(grid.cells != Cell.OUTSIDE)
    low = (
        np.array(grid.origin) + inside.min(axis=0) * grid.resolution
        if inside.size
        else np.array(grid.origin)
    )
    high = (
        np.array(grid.origin) + (inside.max(axis=0) + 1) * grid.resolution
        if inside.size
        else low + 1.0
    )
    corners = np.vstack([low, high, *(outline(solid) for solid in room.solids)])
    (x_min, y_min), (x_max, y_max) = corners.min(axis=0) - 0.3, corners.max(axis=0) + 0.3
    return float(x_min), float(y_min), float(x_max), float(y_max)


def _cells(axes: Axes, grid: OccupancyGrid) -> None:
    colours = np.array([to_rgba(_CELL_LOOK[Cell(value)][0]) for value in range(len(Cell))])
    nx, ny = grid.shape
    x, y = grid.origin
    extent = (x, x + nx * grid.resolution, y, y + ny * grid.resolution)
    axes.imshow(
        colours[grid.cells.T], origin="lower", extent=extent, interpolation="nearest", zorder=0
    )
    if grid.resolution >= 0.25:
        for k in range(nx + 1):
            axes.plot([x + k * grid.resolution] * 2, extent[2:], color=LIGHT.line, lw=0.6, zorder=1)
        for k in range(ny + 1):
            axes.plot(extent[:2], [y + k * grid.resolution] * 2, color=LIGHT.line, lw=0.6, zorder=1)


def _patch(solid: Solid) -> Patch:
    fill = to_rgba(solid.colour[:3], 0.5 if solid.collides else 0.25)
    style: dict[str, Any] = {
        "facecolor": fill,
        "edgecolor": to_rgba(LIGHT.ink, 0.45),
        "linewidth": 0.4,
        "zorder": 2,
    }
    if solid.thing in ("wall", "unexplored"):
        style |= {"facecolor": _CELL_LOOK[Cell.OCCUPIED][0], "edgecolor": "none"}
    if solid.shape is Shape.CYLINDER:
        return Circle(solid.position[:2], solid.size[0] / 2, **style)
    return Polygon(outline(solid), closed=True, **style)


def _labels(axes: Axes, room: Room) -> None:
    """Write the name of each thing on its largest solid, larger things first."""
    largest: dict[str, Solid] = {}
    for solid in room.solids:
        best = largest.get(solid.thing)
        if solid.thing not in _UNLABELLED and (best is None or _area(solid) > _area(best)):
            largest[solid.thing] = solid
    written: list[Vec2] = []
    for thing, solid in sorted(largest.items(), key=lambda item: -_area(item[1])):
        x, y, _ = solid.position
        if any(hypot(x - u, y - v) < _LABEL_SPACING for u, v in written):
            continue
        written.append((x, y))
        extent = np.ptp(outline(solid), axis=0)
        upright = 90.0 if extent[1] > 1.6 * extent[0] and len(thing) > 3 else 0.0
        axes.text(
            x,
            y,
            thing,
            fontsize=7.5,
            color=LIGHT.ink,
            ha="center",
            va="center",
            rotation=upright,
            zorder=6,
            **_halo(),
        )


def _halo(width: float = 2.2) -> dict[str, Any]:
    return {"path_effects": [withStroke(linewidth=width, foreground=(1, 1, 1, 0.85))]}


def _area(solid: Solid) -> float:
    return solid.size[0] * solid.size[1]


def _cameras(axes: Axes, room: Room) -> None:
    for camera in room.cameras:
        x, y, _ = camera.position
        ahead = rotate(camera.orientation, (0.0, 0.0, 1.0))
        heading = degrees(atan2(ahead[1], ahead[0]))
        axes.plot(
            x,
            y,
            marker=(3, 0, heading - 90.0),
            color=LIGHT.quiet,
            ms=7,
            mec="white",
            mew=0.6,
            zorder=7,
        )


def _lines(axes: Axes, route: Sequence[Vec2] | None, trail: Sequence[Vec2] | None) -> None:
    if route:
        xs, ys = zip(*route, strict=True)
        axes.plot(xs, ys, color="white", lw=5.0, alpha=0.9, solid_joinstyle="round", zorder=7)
        axes.plot(xs, ys, color=LIGHT.accent, lw=2.6, solid_joinstyle="round", zorder=8)
        axes.plot(
            xs, ys, ls="", marker="o", ms=4.0, mfc="white", mec=LIGHT.accent, mew=1.3, zorder=9
        )
    if trail:
        xs, ys = zip(*trail, strict=True)
        axes.plot(xs, ys, color=LIGHT.danger, lw=1.4, alpha=0.9, zorder=9)


def _landmarks(axes: Axes, room: Room) -> None:
    for place in room.places:
        if place.name != "home":
            x, y = place.viewpoint
            yaw = atan2(place.look_at[1] - y, place.look_at[0] - x)
            axes.annotate(
                "",
                (x + 0.34 * cos(yaw), y + 0.34 * sin(yaw)),
                (x, y),
                arrowprops={"arrowstyle": "->", "color": LIGHT.accent, "lw": 1.2},
            )
            axes.plot(x, y, marker="o", ms=6.5, mfc=LIGHT.accent, mec="white", mew=1.0, zorder=10)
            title = place.title or place.name
            axes.text(
                x,
                y - 0.20,
                title,
                fontsize=8.5,
                weight="bold",
                color=LIGHT.accent,
                ha="center",
                va="top",
                zorder=11,
                **_halo(3),
            )
    x, y = room.home
    axes.plot(x, y, marker="o", ms=15, mfc=LIGHT.accent, mec="white", mew=1.6, zorder=10)
    axes.text(
        x, y, "H", fontsize=9, weight="bold", color="white", ha="center", va="center", zorder=11
    )
    if room.visitor:
        x, y = room.visitor
        axes.plot(x, y, marker="o", ms=12, mfc=LIGHT.danger, mec="white", mew=1.4, zorder=10)
        axes.text(
            x,
            y - 0.28,
            "visitor",
            fontsize=8.5,
            weight="bold",
            color=LIGHT.danger,
            ha="center",
            va="top",
            zorder=11,
            **_halo(3),
        )


def _frame_and_legend(
    figure: Figure,
    axes: Axes,
    room: Room,
    grid: OccupancyGrid,
    frame: tuple[float, float, float, float],
    route: bool,
    trail: bool,
) -> None:
    x_min, y_min, x_max, y_max = frame
    axes.set_xlim(x_min, x_max)
    axes.set_ylim(y_min, y_max)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=7.5, colors=LIGHT.quiet, length=3)
    for spine in axes.spines.values():
        spine.set_visible(False)
    axes.set_title(
        f"{room.name}: {grid.shape[0]} x {grid.shape[1]} cells of {grid.resolution:g} m",
        fontsize=12,
        color=LIGHT.ink,
        loc="left",
    )
    present = set(np.unique(grid.cells).tolist())
    entries: list[Any] = [
        Rectangle(
            (0, 0), 1, 1, facecolor=colour, edgecolor=LIGHT.thing_edge, linewidth=0.5, label=words
        )
        for kind, (colour, _, words) in _CELL_LOOK.items()
        if int(kind) in present and kind is not Cell.OUTSIDE
    ]
    if room.cameras:
        entries.append(
            Line2D(
                [], [], ls="", marker=(3, 0, 0), color=LIGHT.quiet, ms=7, label="tracking camera"
            )
        )
    if route:
        entries.append(Line2D([], [], color=LIGHT.accent, lw=2.6, label="planned route"))
    if trail:
        entries.append(Line2D([], [], color=LIGHT.danger, lw=1.4, label="flown"))
    entries.append(
        Line2D([], [], ls="", marker="o", color=LIGHT.accent, ms=6, label="viewpoint (H: home)")
    )
    figure.legend(
        handles=entries,
        loc="lower center",
        ncols=min(len(entries), 7),
        fontsize=8,
        frameon=False,
        labelcolor=LIGHT.ink,
    )
