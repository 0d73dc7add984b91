"""Figs. 12 and 13: the loops, with the signal of one flight at every arrow."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

from housefly.lab.reproduction.drawing import write_figure
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.flight import FlightTracks
from housefly.numeric import FloatArray
from housefly.pilot.control.laws import acceleration
from housefly.record.plot_style import BLUE, GREEN, GREY, INK, ORANGE

_WINDOW = 9.0
"""Length of the part of the flight that is shown [s]."""
_FRAME_STRIDE = 3
"""Every so many frames of tracking, one is drawn."""


class _Signal(NamedTuple):
    """One arrow: name, curves (time, value, colour, style), and place of its plot (column, row)."""

    name: str
    curves: tuple[tuple[FloatArray, FloatArray, str, str], ...]
    place: tuple[float, float]


def draw_fig12_and_13(folder: Path, flight: FlightTracks, start: float) -> tuple[Exhibit, Exhibit]:
    """Draw both diagrams from ``start`` [s] of a flight on."""
    signals = _signals(flight, start)
    inner = (
        "reference and position",
        "demanded acceleration",
        "commanded angle",
        "reached angle",
        "true position",
    )
    write_figure(
        folder, "fig12", (12.0, 5.0), lambda figure: _diagram(figure, signals, inner, False)
    )
    write_figure(
        folder,
        "fig13",
        (12.0, 7.2),
        lambda figure: _diagram(figure, signals, (*inner, "tracking", "estimate"), True),
    )
    error, lag = _numbers(flight, start)
    return (
        Exhibit(
            "12",
            "Outer and inner loop",
            "fig12",
            "A block diagram without signals: position loop outside, the drone's own attitude loop"
            " inside.",
            f"{_WINDOW:.0f} s of one flight along x at every arrow: the position follows its"
            f" reference to {100 * error:.1f} cm (root mean square), the angle follows its command"
            f" {1000 * lag:.0f} ms behind.",
        ),
        Exhibit(
            "13",
            "General control schema with Kalman filter",
            "fig13",
            "The same with Vicon data and Kalman filter in the feedback; no signals.",
            "The same seconds with what tracking saw and what the filter made of it: position and"
            " speed.",
        ),
    )


def _signals(flight: FlightTracks, start: float) -> dict[str, _Signal]:
    shown = (flight.at >= start) & (flight.at < start + _WINDOW)
    t = flight.at[shown] - start
    frames = (flight.seen_at >= start) & (flight.seen_at < start + _WINDOW)
    seen_t = flight.seen_at[frames] - start
    reference, estimate = flight.reference[shown, 0], flight.estimate[shown]
    push = np.array([acceleration(theta, phi, 0.0)[0] for theta, phi in flight.asked[shown]])
    along = np.cos(_yaws(flight)[shown])
    tilt, reached = flight.asked[shown, 0], flight.reached[shown, 0]
    x, tracked = flight.seen[frames, 0], flight.seen_tilt[frames, 0]
    few = slice(None, None, _FRAME_STRIDE)
    return {
        "reference and position": _Signal(
            "x_ref, x [m]", ((t, reference, GREY, "--"), (t, estimate[:, 0], BLUE, "-")), (0.0, 1.0)
        ),
        "demanded acceleration": _Signal(
            "demanded acceleration [m/s²]", ((t, push * along, ORANGE, "-"),), (1.0, 1.0)
        ),
        "commanded angle": _Signal("theta_des [rad]", ((t, tilt, ORANGE, "-"),), (2.0, 1.0)),
        "reached angle": _Signal(
            "theta [rad]", ((t, tilt, GREY, "--"), (t, reached, GREEN, "-")), (3.0, 1.0)
        ),
        "true position": _Signal("x [m]", ((seen_t, x, GREEN, "-"),), (4.0, 1.0)),
        "tracking": _Signal("tracking: x [m]", ((seen_t[few], x[few], GREEN, "."),), (3.0, 0.0)),
        "estimate": _Signal("Kalman: dx/dt [m/s]", ((t, estimate[:, 2], BLUE, "-"),), (1.0, 0.0)),
        "tracked angle": _Signal("theta [rad]", ((seen_t, tracked, GREEN, "."),), (2.0, 0.0)),
    }


def _yaws(flight: FlightTracks) -> FloatArray:
    return np.array([s.outputs.estimate.yaw if s.outputs.estimate else 0.0 for s in flight.steps])


def _numbers(flight: FlightTracks, start: float) -> tuple[float, float]:
    """Return the RMS distance from the reference [m] and the lag of the angle [s]."""
    shown = (flight.at >= start) & (flight.at < start + _WINDOW)
    off = flight.reference[shown] - flight.estimate[shown, :2]
    asked, reached = flight.asked[shown, 0], flight.reached[shown, 0]
    period = float(np.median(np.diff(flight.at)))
    shifts = range(round(0.6 / period))
    fits = [np.corrcoef(asked[: asked.size - k], reached[k:])[0, 1] for k in shifts]
    return float(np.sqrt(np.nanmean(np.sum(off**2, axis=1)))), float(np.argmax(fits) * period)


_BLOCKS = (
    "reference",
    "feedback\nlinearization",
    "saturation,\nlast gate",
    "drone:\nattitude loop",
    "drone:\nmotion",
)


def _diagram(
    figure: Figure, signals: dict[str, _Signal], names: tuple[str, ...], filtered: bool
) -> None:
    frame = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    figure.set_layout_engine("none")
    frame.set_xlim(0.0, 12.0)
    height = 7.2 if filtered else 5.0
    frame.set_ylim(0.0, height)
    frame.axis("off")
    row = height - 0.85
    centres = [1.2 + 2.4 * k for k in range(5)]
    for centre, words in zip(centres, _BLOCKS, strict=True):
        _block(frame, centre, row, words)
    for left, right in pairwise(centres):
        _arrow(frame, [(left + 0.72, row), (right - 0.72, row)])
    low = 0.55 if filtered else row - 3.35
    if filtered:
        _block(frame, centres[3], low, "Vicon")
        _block(frame, centres[1], low, "Kalman filter")
        _arrow(frame, [(centres[4], row - 0.42), (centres[4], low), (centres[3] + 0.72, low)])
        _arrow(frame, [(centres[3] - 0.72, low), (centres[1] + 0.72, low)])
        _arrow(frame, [(centres[1], low + 0.42), (centres[1], row - 0.42)])
        _arrow(
            frame,
            [(centres[2], row - 0.42), (centres[2], low + 0.62), (centres[1] + 0.74, low + 0.22)],
            dashed=True,
        )
    else:
        _arrow(
            frame,
            [
                (centres[4], row - 0.42),
                (centres[4], low),
                (centres[1], low),
                (centres[1], row - 0.42),
            ],
        )
    for name in names:
        signal = signals[name]
        column, level = signal.place
        centre = centres[0] + 2.4 * column
        bottom = (row - 2.45) if level == 1.0 else low + 0.85
        _plot(figure, signal, (centre - 0.78) / 12.0, bottom / height, 1.62 / 12.0, 1.35 / height)


def _block(frame: Any, x: float, y: float, words: str) -> None:
    frame.add_patch(
        FancyBboxPatch(
            (x - 0.7, y - 0.4),
            1.4,
            0.8,
            boxstyle="round,pad=0.02,rounding_size=0.1",
            facecolor="#eaf3f8",
            edgecolor=BLUE,
        )
    )
    frame.text(x, y, words, ha="center", va="center", fontsize=9)


def _arrow(frame: Any, points: list[tuple[float, float]], *, dashed: bool = False) -> None:
    style = "--" if dashed else "-"
    for a, b in pairwise(points[:-1]):
        frame.plot([a[0], b[0]], [a[1], b[1]], color=INK, linewidth=1.0, linestyle=style, zorder=1)
    frame.add_patch(
        FancyArrowPatch(
            points[-2],
            points[-1],
            arrowstyle="-|>",
            mutation_scale=11,
            color=INK,
            linewidth=1.0,
            linestyle=style,
            zorder=1,
        )
    )


def _plot(
    figure: Figure, signal: _Signal, left: float, bottom: float, width: float, height: float
) -> None:
    axes = figure.add_axes((left, bottom, width, height))
    axes.patch.set_alpha(1.0)
    for t, values, colour, style in signal.curves:
        kind = (
            {"marker": ".", "linestyle": "none", "markersize": 2.5}
            if style == "."
            else {"linestyle": style}
        )
        axes.plot(t, values, color=colour, linewidth=1.1, **kind)
    axes.set_title(
        signal.name, fontsize=8, bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    )
    axes.tick_params(labelsize=7, length=2)
    axes.set_xlim(0.0, _WINDOW)
    axes.set_xticks([0, 3, 6, 9], ["0", "3", "6", "9 s"])
    axes.grid(True, linewidth=0.5)
