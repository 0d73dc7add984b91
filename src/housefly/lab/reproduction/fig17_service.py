"""Fig. 17: the service as a strip, console and camera side by side at a few moments."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

from housefly.lab.reproduction.drawing import write_figure
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.fig15_paths import paint_fine_grid
from housefly.lab.reproduction.flight import FlightTracks
from housefly.record.plot_style import PLOT_STYLE
from housefly.room.grid import OccupancyGrid
from housefly.theme import LIGHT, ORANGE

RgbImage = NDArray[np.uint8]


@dataclass(frozen=True, slots=True, eq=False)
class Moment:
    """One pair of pictures.

    Attributes:
        title: what happens.
        at: since the order [s].
        console: what the operator sees, shape (h, w, 3).
        camera: what the drone sees, shape (h, w, 3); None where no picture was received.
    """

    title: str
    at: float
    console: RgbImage
    camera: RgbImage | None


def draw_fig17(
    folder: Path,
    moments: tuple[Moment, ...],
    outcome: str,
    photographed: bool,
    *,
    over_wires: bool,
    notice: str = "",
) -> Exhibit:
    """Draw the strip.

    Args:
        folder: where to write.
        moments: of the service.
        outcome: of the service.
        photographed: whether the consoles are photographs of the page, or drawn from the recording.
        over_wires: whether it flew over real wires, or on a stepped clock without camera.
        notice: why it is not the flight that was wanted; "" when it is.
    """
    if over_wires:
        size = (10.0, 2.55 * len(moments))
        write_figure(folder, "fig17", size, lambda figure: _paint(figure, moments))
    else:
        size = (10.0, 2.7 * ceil(len(moments) / 2))
        write_figure(folder, "fig17", size, lambda figure: _paint_consoles(figure, moments))
    source = (
        "photographs of the page in Chromium"
        if photographed
        else "drawn from the recording" + (" (no browser on this machine)" if over_wires else "")
    )
    where = (
        f"over real wires ({outcome}, {moments[-1].at:.0f} s). Left: the console, {source}. Right:"
        " the drone's camera, as received."
        if over_wires
        else f"on a stepped clock ({outcome}, {moments[-1].at:.0f} s): the console's map, {source}."
        " On a stepped clock there is neither page nor camera; flown over real wires, both are"
        " shown side by side."
    )
    return Exhibit(
        "17",
        "The service experiment",
        "fig17",
        "Photographs of the drone on the left, of the operator's page on the right, from take-off"
        " to the entrance.",
        f"One service {where}",
        notice,
        wide=True,
    )


def _paint(figure: Figure, moments: tuple[Moment, ...]) -> None:
    panels = figure.subplots(len(moments), 2, squeeze=False, width_ratios=(1.6, 1.6))
    for (left, right), moment in zip(panels, moments, strict=True):
        _picture(left, moment.console)
        left.set_title(f"{moment.at:.0f} s: {moment.title}", fontsize=9)
        if moment.camera is None:
            right.axis("off")
            right.text(0.5, 0.5, "no picture received", ha="center", va="center")
        else:
            _picture(right, moment.camera)


def _paint_consoles(figure: Figure, moments: tuple[Moment, ...]) -> None:
    panels = figure.subplots(ceil(len(moments) / 2), 2, squeeze=False).ravel()
    for axes, moment in zip(panels, moments, strict=False):
        _picture(axes, moment.console)
        axes.set_title(f"{moment.at:.0f} s: {moment.title}", fontsize=9)
    for axes in panels[len(moments) :]:
        axes.remove()


def _picture(axes: Any, picture: RgbImage) -> None:
    axes.imshow(picture)
    axes.set_xticks([])
    axes.set_yticks([])
    for spine in axes.spines.values():
        spine.set_visible(True)
        spine.set_color(LIGHT.thing_edge)


def drawn_console(grid: OccupancyGrid, flight: FlightTracks, until: float) -> RgbImage:
    """Return the console's map from the recording: path, what was flown until a time [s], drone."""
    with rc_context(PLOT_STYLE):
        figure = Figure(figsize=(8.0, 4.5), dpi=120, layout="constrained", facecolor="white")
        canvas = FigureCanvasAgg(figure)
        axes = figure.subplots()
        paint_fine_grid(axes, grid)
        axes.margins(0.02)
        path, past = np.array(flight.path), flight.seen_at <= until
        axes.plot(path[:, 0], path[:, 1], color=ORANGE, linestyle="--", linewidth=1.5)
        axes.plot(flight.seen[past, 0], flight.seen[past, 1], color=LIGHT.accent, linewidth=1.5)
        if past.any():
            axes.plot(
                *flight.seen[past][-1, :2],
                marker="o",
                markersize=11,
                color=LIGHT.accent,
                markeredgecolor="white",
            )
        canvas.draw()  # type: ignore[no-untyped-call]
        return np.asarray(canvas.buffer_rgba())[..., :3].copy()  # type: ignore[no-untyped-call]
