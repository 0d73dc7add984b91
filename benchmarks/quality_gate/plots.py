"""The gate's plots: where each way of flying flew, how fast, how high, how far off."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from housefly.numeric import FloatArray
from housefly.record import svg
from housefly.room.model import Room
from housefly.room.outline import outline
from quality_gate.flown_row import FlownRow
from quality_gate.scenario import Way

_COLOURS = {
    Way.GRID.value: svg.SECONDARY,
    Way.SPACE.value: svg.ACCENT,
    Way.PAPER.value: svg.FAULT,
}
_SIZE = (10.4, 7.2)
_TIME, _PLACE, _VELOCITY, _WANTED = 0, slice(1, 4), slice(4, 7), slice(7, 10)


def row_svg(room: Room, flown: Sequence[FlownRow], title: str) -> str:
    """Return a row's picture, the ways side by side: plan, speed, height, distance off.

    Args:
        room: where it was flown; only what stands in it is drawn.
        flown: by each way; those without a leg are left out.
        title: for who cannot see it.
    """
    known = [row for row in flown if row.legs]
    with svg.drawing(title):
        figure = Figure(figsize=_SIZE, layout="constrained")
        grid = figure.add_gridspec(4, 1, height_ratios=(3.2, 1.0, 0.8, 1.0))
        plan, speed, height, off = (figure.add_subplot(grid[k]) for k in range(4))
        _draw_room(plan, room)
        for row in known:
            _draw_way(plan, row)
            _draw_time(speed, height, off, row)
        plan.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
        speed.set(ylabel="speed [m/s]")
        height.set(ylabel="height [m]")
        off.set(ylabel="off the\nreference [mm]", xlabel="time in flight, leg after leg [s]")
        handles = [Line2D([], [], color=_COLOURS[row.way], label=row.way) for row in known]
        handles.append(
            Line2D([], [], color=svg.MUTED, linestyle=(0, (4, 3)), label="the reference")
        )
        figure.legend(handles=handles, loc="outside lower center", ncols=4)
        return svg.to_svg(figure, title)


def _draw_room(axes: Axes, room: Room) -> None:
    outlines = [outline(solid) for solid in room.solids if solid.collides]
    axes.add_collection(
        PolyCollection(
            outlines, facecolor=svg.INFLATED_FILL, edgecolor=svg.FURNITURE_LINE, linewidth=0.5
        )
    )
    x_min, y_min, x_max, y_max = room.bounds
    axes.set(xlim=(x_min, x_max), ylim=(y_min, y_max))
    axes.grid(visible=False)


def _draw_way(axes: Axes, row: FlownRow) -> None:
    for leg in row.legs:
        course = np.array(leg.course)
        if not len(course):
            continue
        axes.plot(*course[:, 7:9].T, color=svg.MUTED, linestyle=(0, (4, 3)), linewidth=0.7)
        axes.plot(*course[:, 1:3].T, color=_COLOURS[row.way], linewidth=1.2)
        axes.plot(*leg.goal, ".", color=svg.TEXT, markersize=4)


def _draw_time(speed: Axes, height: Axes, off: Axes, row: FlownRow) -> None:
    began, colour = 0.0, _COLOURS[row.way]
    for leg in row.legs:
        course = np.array(leg.course)
        if not len(course):
            continue
        time = course[:, _TIME] - course[0, _TIME] + began
        began = float(time[-1])
        speed.plot(time, _length(course[:, _VELOCITY]), color=colour, linewidth=1.0)
        height.plot(time, course[:, 9], color=svg.MUTED, linestyle=(0, (4, 3)), linewidth=0.7)
        height.plot(time, course[:, 3], color=colour, linewidth=1.0)
        apart = 1000.0 * _length(course[:, _PLACE] - course[:, _WANTED])
        off.plot(time, apart, color=colour, linewidth=1.0)
        for axes in (speed, height, off):
            axes.axvline(began, color=svg.LINE, linewidth=0.6)


def _length(vectors: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.norm(vectors, axis=1))
