"""Figs. 12 and 13: the loops, with the signal of one flight at every arrow."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from housefly.lab.reproduction.block_diagram import WINDOW, Curve, Panel, draw_diagram
from housefly.lab.reproduction.drawing import write_figure
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.flight import FlightTracks
from housefly.numeric import FloatArray
from housefly.theme import GREEN, LIGHT, ORANGE

_LAG_MAX = 0.6
"""Longest lag of the angle behind its command that is looked for [s]."""


def draw_fig12_and_13(
    folder: Path, flight: FlightTracks, demanded: FloatArray, start: float
) -> tuple[Exhibit, Exhibit]:
    """Draw both diagrams.

    Args:
        folder: where to write.
        flight: in mode default, with the truth.
        demanded: by the control law in the world, before any limit [m/s^2], shape (n, 2).
        start: of the part that is shown [s].
    """
    forward = forward_signals(flight, demanded, start)
    feedback = feedback_signals(flight, start)
    write_figure(folder, "fig12", (13.6, 4.3), lambda figure: draw_diagram(figure, forward, ()))
    write_figure(
        folder, "fig13", (13.6, 6.4), lambda figure: draw_diagram(figure, forward, feedback)
    )
    error, lag = _numbers(flight, start)
    limited = _limited(flight, demanded, start)
    return (
        Exhibit(
            "12",
            "Outer and inner loop",
            "fig12",
            "A block diagram without signals: position loop outside, the drone's own attitude loop"
            " inside.",
            f"{WINDOW:.0f} s of one flight of mode default, along x only. The position follows its"
            f" reference to {100 * error:.1f} cm (root mean square), the angle follows its command"
            f" {1000 * lag:.0f} ms behind.{_nose(flight, start)}"
            f" The acceleration is what the law demands before any limit; {limited}.",
            wide=True,
        ),
        Exhibit(
            "13",
            "General control schema with Kalman filter",
            "fig13",
            "The same with Vicon data and Kalman filter in the feedback; no signals.",
            "The same seconds with what tracking saw, as its difference from the truth, and the"
            " speed that the filter made of it, beside the true one.",
            wide=True,
        ),
    )


def forward_signals(flight: FlightTracks, demanded: FloatArray, start: float) -> tuple[Panel, ...]:
    """Return the signals from the reference to the true position, in order."""
    shown, true = _shown(flight.at, start), _shown(flight.true_at, start)
    t, true_t = flight.at[shown] - start, flight.true_at[true] - start
    tilt, reached = flight.asked[shown, 0], flight.reached[shown, 0]
    x = flight.true[true, 0]
    return (
        Panel("x_ref [m]", (Curve(t, flight.reference[shown, 0], LIGHT.quiet),)),
        Panel("demanded acceleration\nalong x [m/s²]", (Curve(t, demanded[shown, 0], ORANGE),)),
        Panel("theta_des [rad]", (Curve(t, tilt, ORANGE),)),
        Panel(
            "theta [rad], dashed: theta_des",
            (Curve(t, tilt, LIGHT.quiet, "--"), Curve(t, reached, GREEN)),
        ),
        Panel("true x [m]", (Curve(true_t, x, LIGHT.ink),)),
    )


def feedback_signals(flight: FlightTracks, start: float) -> tuple[Panel, ...]:
    """Return what leaves tracking, and what leaves the filter."""
    shown, frames = _shown(flight.at, start), _shown(flight.seen_at, start)
    t, seen_t = flight.at[shown] - start, flight.seen_at[frames] - start
    truth = np.interp(flight.seen_at[frames], flight.true_at, flight.true[:, 0])
    speed = np.gradient(flight.true[:, 0], flight.true_at)
    true = _shown(flight.true_at, start)
    return (
        Panel(
            "tracked x - true x [mm]",
            (Curve(seen_t, 1000.0 * (flight.seen[frames, 0] - truth), GREEN, "."),),
        ),
        Panel(
            "dx/dt by the filter [m/s], dashed: true",
            (
                Curve(t, flight.estimate[shown, 2], LIGHT.accent),
                Curve(flight.true_at[true] - start, speed[true], LIGHT.ink, "--"),
            ),
        ),
    )


def _shown(at: FloatArray, start: float) -> NDArray[np.bool_]:
    return np.asarray((at >= start) & (at < start + WINDOW))


def _numbers(flight: FlightTracks, start: float) -> tuple[float, float]:
    """Return the true RMS distance from the reference [m] and the lag of the angle [s]."""
    shown, true = _shown(flight.at, start), _shown(flight.true_at, start)
    at = flight.true_at[true]
    reference = [np.interp(at, flight.at[shown], flight.reference[shown, k]) for k in range(2)]
    off = np.array(reference).T - flight.true[true, :2]
    asked, reached = flight.asked[shown, 0], flight.reached[shown, 0]
    period = float(np.median(np.diff(flight.at)))
    shifts = range(round(_LAG_MAX / period))
    fits = [np.corrcoef(asked[: asked.size - k], reached[k:])[0, 1] for k in shifts]
    return float(np.sqrt(np.nanmean(np.sum(off**2, axis=1)))), float(np.argmax(fits) * period)


def _nose(flight: FlightTracks, start: float) -> str:
    """Return in words that x and pitch have opposite signs, where they have."""
    shown = np.flatnonzero(_shown(flight.at, start))
    yaws = [found.yaw for k in shown if (found := flight.steps[k].outputs.estimate)]
    turned = bool(yaws) and float(np.cos(yaws).mean()) < 0.0
    return " The nose points to -x, so a positive pitch pushes to -x." if turned else ""


def _limited(flight: FlightTracks, demanded: FloatArray, start: float) -> str:
    """Return in words how large the demand was."""
    size = float(np.nanmax(np.linalg.norm(demanded[_shown(flight.at, start)], axis=1)))
    return f"at most {size:.2f} m/s² in these seconds"
