"""The report's planned curves: speed as colour, height along the way, and how far to a stop."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from housefly.config.airframe import BrakingConstants
from housefly.messages import TrajectoryPoint
from housefly.numeric import FloatArray
from housefly.record import svg
from housefly.record.series import FlightSeries

_WIDTH, _ROW = 10.4, 1.5
"""Size of one strip [inch]."""
_PLANNED_WIDTH = 5.0
"""What was flown is drawn over it, thin [pt]."""
_TOP_SPEED_MIN = 0.1
_FLOWN_MIN = 0.3
"""A curve that was flown for less is one that another replaced at once [m]."""
_BEHIND, _AHEAD = 0.5, 1.5
"""A flown place is looked for so far around the one before it, along the curve [m]."""


def draw_planned(axes: Axes, flight: FlightSeries) -> list[Patch | Line2D]:
    """Draw the curves that were planned in space from above, and return the legend's handles."""
    curves = [_columns(points) for points in flight.planned if points]
    if not curves:
        return []
    top = _top_speed(curves)
    for curve in curves:
        axes.add_collection(_coloured(curve[:, :2], curve[:, 4], top))
    return [_handle(kind, top) for kind in range(len(svg.SPEED_FILLS))]


def height_svg(flight: FlightSeries) -> str:
    """Return the height along each curve, as planned and as tracked; "" where none is in space."""
    known = [number for number, points in enumerate(flight.planned) if points]
    numbers = [number for number in known if _flown_along(flight, number) > _FLOWN_MIN] or known
    if not numbers:
        return ""
    curves = [_columns(flight.planned[number]) for number in numbers]
    top = _top_speed(curves)
    with svg.drawing("height"):
        height = _ROW * len(numbers) + 0.8
        figure = Figure(figsize=(_WIDTH, height))
        figure.subplots_adjust(
            left=0.06, right=0.985, bottom=0.42 / height, top=1.0 - 0.7 / height, hspace=0.6
        )
        rows = np.atleast_1d(figure.subplots(len(numbers), 1))
        for row, (number, curve) in enumerate(zip(numbers, curves, strict=True)):
            rows[row].set_title(f"height [m], curve {row + 1}")
            _draw_height(rows[row], flight, number, curve, top)
        rows[-1].set_xlabel("way along the curve [m]")
        handles = [_handle(kind, top) for kind in range(len(svg.SPEED_FILLS))]
        handles.append(Line2D([], [], color=svg.TEXT, linewidth=1.2, label="flown"))
        figure.legend(handles=handles, loc="upper right", ncols=6)
        return svg.to_svg(figure, "Height along the planned curves, with their speed, and as flown")


def stopping_svg(flight: FlightSeries, braking: BrakingConstants) -> str:
    """Return speed, the way to a stop from it, and one sigma of the place, over time."""
    elapsed = flight.time - flight.time[0] if flight.time.size else flight.time
    stop = flight.speed**2 / (2.0 * braking.deceleration) + flight.speed * braking.reaction_time
    strips = (
        ("speed [m/s]", flight.speed),
        ("way to a stop, reaction included [m]", stop),
        ("one sigma of the place in the plane [mm]", 1000.0 * flight.position_std),
    )
    with svg.drawing("stopping"):
        height = 1.35 * len(strips) + 0.6
        figure = Figure(figsize=(_WIDTH, height))
        figure.subplots_adjust(
            left=0.06, right=0.985, bottom=0.42 / height, top=1.0 - 0.3 / height, hspace=0.45
        )
        rows = figure.subplots(len(strips), 1, sharex=True)
        for axes, (title, values) in zip(rows, strips, strict=True):
            axes.set_title(title)
            axes.plot(elapsed, values, color=svg.ACCENT, linewidth=1.2)
            axes.set_ylim(bottom=0.0)
        rows[-1].set_xlabel("time [s]")
        rows[0].set_xlim(0.0, max(float(elapsed[-1]), 1.0) if elapsed.size else 1.0)
        return svg.to_svg(figure, "Speed, way to a stop and one sigma of the place over time")


def _columns(points: tuple[TrajectoryPoint, ...]) -> FloatArray:
    """Return x, y, z [m], way along the curve [m] and speed [m/s], shape (n, 5)."""
    places = np.array([point.position for point in points])
    marks = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1))))
    return np.column_stack((places, marks, [point.speed for point in points]))


def _top_speed(curves: list[FloatArray]) -> float:
    return max(_TOP_SPEED_MIN, *(float(curve[:, 4].max()) for curve in curves))


def _coloured(places: FloatArray, speeds: FloatArray, top: float) -> LineCollection:
    """Return a line whose colour is the speed; places have shape (n, 2)."""
    legs = np.stack((places[:-1], places[1:]), axis=1)
    count = len(svg.SPEED_FILLS)
    kinds = np.clip((count * (speeds[:-1] + speeds[1:]) / (2.0 * top)).astype(int), 0, count - 1)
    colours = [svg.SPEED_FILLS[kind] for kind in kinds]
    return LineCollection(
        list(legs), colors=colours, linewidths=_PLANNED_WIDTH, capstyle="round", zorder=2
    )


def _handle(kind: int, top: float) -> Line2D:
    low, high = (top * share / len(svg.SPEED_FILLS) for share in (kind, kind + 1))
    label = f"planned {low:.1f} to {high:.1f} m/s"
    return Line2D([], [], color=svg.SPEED_FILLS[kind], linewidth=_PLANNED_WIDTH, label=label)


def _draw_height(
    axes: Axes, flight: FlightSeries, number: int, curve: FloatArray, top: float
) -> None:
    axes.add_collection(_coloured(curve[:, [3, 2]], curve[:, 4], top))
    flown = flight.estimate[flight.path == number]
    axes.plot(_marks_of(flown[:, :2], curve), flown[:, 2], color=svg.TEXT, linewidth=1.2, zorder=4)
    highest = float(max(curve[:, 2].max(), np.nanmax(flown[:, 2], initial=0.0)))
    axes.set(xlim=(0.0, max(float(curve[-1, 3]), 0.1)), ylim=(0.0, highest + 0.3))


def _flown_along(flight: FlightSeries, number: int) -> float:
    """Return how far the drone moved along a curve in all [m]."""
    curve = _columns(flight.planned[number])
    marks = _marks_of(flight.estimate[flight.path == number][::10, :2], curve)
    return float(np.nanmax(marks, initial=0.0))


def _marks_of(places: FloatArray, curve: FloatArray) -> FloatArray:
    """Return how far along a curve each place is [m]; never back by much, for it may cross itself.

    Args:
        places: in order [m], shape (m, 2).
        curve: as of ``_columns``.
    """
    fine = np.linspace(0.0, curve[-1, 3], 20 * len(curve))
    xs, ys = (np.interp(fine, curve[:, 3], curve[:, axis]) for axis in (0, 1))
    marks, mark = np.full(len(places), np.nan), 0.0
    for row, (x, y) in enumerate(places.tolist()):
        near = (fine >= mark - _BEHIND) & (fine <= mark + _AHEAD)
        off = np.where(near, np.hypot(xs - x, ys - y), np.inf)
        if np.isfinite(x):
            marks[row] = mark = float(fine[off.argmin()])
    return marks
