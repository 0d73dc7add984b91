"""The block diagram of Figs. 12 and 13: blocks in a row, a plot at every arrow, feedback below."""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple

from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

from housefly.numeric import FloatArray
from housefly.theme import LIGHT

WINDOW = 9.0
"""Length of the part of a flight that is shown [s]."""
_BLOCKS = (
    "reference",
    "feedback\nlinearization",
    "saturation,\nlast gate",
    "drone:\nattitude loop",
    "drone:\nmotion",
)
_WIDTH, _SPACING, _FIRST = 13.6, 2.5, 0.9
"""Of the drawing, between the middles of blocks, and of the first one [inch]."""
_HALF = (0.68, 0.4)
"""Half the width and height of a block [inch]."""
_PLOT = (1.65, 1.3)
"""Width and height of a plot [inch]."""


class Curve(NamedTuple):
    """Times [s], values, colour, and the line style or "." for points."""

    at: FloatArray
    values: FloatArray
    colour: str
    style: str = "-"


class Panel(NamedTuple):
    """The signal at one arrow."""

    name: str
    curves: tuple[Curve, ...]


def draw_diagram(figure: Figure, forward: tuple[Panel, ...], feedback: tuple[Panel, ...]) -> None:
    """Draw the diagram.

    Args:
        figure: to draw on; its size counts in inches.
        forward: at the five arrows from the reference to the position.
        feedback: what leaves tracking and filter; without them the position is fed back as it is.
    """
    height = float(figure.get_size_inches()[1])
    frame = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    figure.set_layout_engine("none")
    frame.set_xlim(0.0, _WIDTH)
    frame.set_ylim(0.0, height)
    frame.axis("off")
    row, low = height - 2.75, 0.6
    middles = [_FIRST + _SPACING * k for k in range(len(_BLOCKS))]
    for middle, words in zip(middles, _BLOCKS, strict=True):
        _block(frame, middle, row, words)
    ends = [*middles, middles[-1] + _SPACING]
    for panel, (left, right) in zip(forward, pairwise(ends), strict=True):
        stop = right - _HALF[0] if right != ends[-1] else right - 0.5
        _arrow(frame, [(left + _HALF[0], row), (stop, row)])
        between = 0.5 * (left + right)
        frame.plot([between, between], [row + 0.04, row + 0.75], color=LIGHT.quiet, linewidth=0.7)
        _plot(figure, panel, between, row + 0.75)
    out, law = ends[-1] - 0.5, middles[1]
    frame.plot([out, out], [row, low], color=LIGHT.ink, linewidth=1.0)
    if not feedback:
        _arrow(frame, [(out, low), (law, low), (law, row - _HALF[1])])
        return
    _filtered(figure, frame, feedback, (row, low, out), middles)


def _filtered(
    figure: Figure,
    frame: Any,
    feedback: tuple[Panel, ...],
    lines: tuple[float, float, float],
    middles: list[float],
) -> None:
    row, low, out = lines
    seen, estimated = feedback
    law, vicon = middles[1], middles[4]
    _block(frame, vicon, low, "Vicon")
    kalman = middles[2]
    _block(frame, kalman, low, "Kalman filter")
    _arrow(frame, [(out, low), (vicon + _HALF[0], low)])
    _arrow(frame, [(vicon - _HALF[0], low), (kalman + _HALF[0], low)])
    between = 0.5 * (kalman + vicon)
    frame.plot([between, between], [low + 0.04, low + 0.5], color=LIGHT.quiet, linewidth=0.7)
    _plot(figure, seen, between, low + 0.5)
    _arrow(frame, [(kalman - _HALF[0], low), (law, low), (law, row - _HALF[1])])
    _plot(figure, estimated, middles[0] + 0.2, low + 0.5)
    start = middles[0] + 0.2 + 0.5 * _PLOT[0]
    frame.plot([start, law - 0.02], [low + 1.15] * 2, color=LIGHT.quiet, linewidth=0.7)
    sent = 0.5 * (middles[2] + middles[3])
    corner = row - 0.75
    _arrow(
        frame,
        [(sent, row - 0.04), (sent, corner), (kalman, corner), (kalman, low + _HALF[1])],
        dashed=True,
    )


def _block(frame: Any, x: float, y: float, words: str) -> None:
    frame.add_patch(
        FancyBboxPatch(
            (x - _HALF[0] + 0.02, y - _HALF[1] + 0.02),
            2 * _HALF[0] - 0.04,
            2 * _HALF[1] - 0.04,
            boxstyle="round,pad=0.02,rounding_size=0.1",
            facecolor=LIGHT.card,
            edgecolor=LIGHT.accent,
        )
    )
    frame.text(x, y, words, ha="center", va="center", fontsize=9)


def _arrow(frame: Any, points: list[tuple[float, float]], *, dashed: bool = False) -> None:
    style = "--" if dashed else "-"
    for a, b in pairwise(points[:-1]):
        frame.plot(
            [a[0], b[0]], [a[1], b[1]], color=LIGHT.ink, linewidth=1.0, linestyle=style, zorder=1
        )
    frame.add_patch(
        FancyArrowPatch(
            points[-2],
            points[-1],
            arrowstyle="-|>",
            mutation_scale=11,
            color=LIGHT.ink,
            linewidth=1.0,
            linestyle=style,
            shrinkA=0.0,
            shrinkB=0.0,
            zorder=1,
        )
    )


def _plot(figure: Figure, panel: Panel, middle: float, bottom: float) -> None:
    width, height = (float(size) for size in figure.get_size_inches())
    box = (middle - 0.42 * _PLOT[0]) / width, (bottom + 0.22) / height
    axes = figure.add_axes((*box, _PLOT[0] / width, _PLOT[1] / height))
    for curve in panel.curves:
        kind = (
            {"marker": ".", "linestyle": "none", "markersize": 2.0}
            if curve.style == "."
            else {"linestyle": curve.style}
        )
        axes.plot(curve.at, curve.values, color=curve.colour, linewidth=1.1, **kind)
    axes.set_title(panel.name, fontsize=8)
    axes.tick_params(labelsize=7, length=2)
    axes.set_xlim(0.0, WINDOW)
    axes.set_xticks([0, 3, 6, 9], ["0", "3", "6", "9 s"])
    axes.grid(True, linewidth=0.5)
