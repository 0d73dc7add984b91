"""The report's plots over time: position and references, commands, states, battery, ages."""

from __future__ import annotations

from enum import Enum
from math import pi

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from housefly.config.limits import LimitsConfig
from housefly.config.site import Site
from housefly.messages import SafetyMode, SetpointForm
from housefly.numeric import FloatArray
from housefly.record import svg
from housefly.record.series import (
    BEHAVIORS,
    PHASES,
    SAFETY_MODES,
    FlightSeries,
    IntArray,
)

_WIDTH = 10.4
_ROW = 1.35
"""Size of one strip [inch]."""

_SAFETY_FILLS = {
    SafetyMode.NOMINAL: svg.STATE_FILLS[0],
    SafetyMode.WARN: svg.STATE_FILLS[1],
    SafetyMode.SLOW: svg.STATE_FILLS[1],
    SafetyMode.HOLD: svg.STATE_FILLS[2],
    SafetyMode.RETURN: svg.STATE_FILLS[3],
    SafetyMode.STOPPED: svg.WARN,
    SafetyMode.LAND: svg.WARN,
    SafetyMode.DESCEND: svg.WARN,
    SafetyMode.CUT: svg.FAULT,
}


def position_svg(flight: FlightSeries) -> str:
    """Return x, y, z and yaw: estimate and reference."""
    with svg.drawing("position"):
        figure, rows = _strips(flight, 4)
        names = ("x [m]", "y [m]", "z [m]", "yaw [rad]")
        estimate, reference = _unwound(flight)
        for column, (axes, name) in enumerate(zip(rows, names, strict=True)):
            axes.set_title(name)
            axes.plot(
                _elapsed(flight),
                estimate[:, column],
                color=svg.ACCENT,
                linewidth=2.0,
                label="estimate",
            )
            axes.plot(
                _elapsed(flight),
                reference[:, column],
                color=svg.SECONDARY,
                linestyle=(0, (4, 3)),
                label="reference",
            )
        rows[0].legend(loc="upper right", ncols=2, bbox_to_anchor=(1.0, 1.4))
        return svg.to_svg(figure, "Position and heading over time, with their references")


def commands_svg(flight: FlightSeries, site: Site) -> str:
    """Return the setpoints between their limits."""
    strips = _strips_of(flight.form, site.limits)
    with svg.drawing("commands"):
        figure, rows = _strips(flight, 4)
        for column, (axes, (name, limit)) in enumerate(zip(rows, strips, strict=True)):
            axes.set_title(name)
            axes.plot(_elapsed(flight), flight.setpoint[:, column], color=svg.ACCENT, linewidth=1.0)
            if limit is None:
                continue
            for bound in (-limit, limit):
                axes.axhline(bound, color=svg.WARN, linewidth=1.0, linestyle=(0, (1, 2)))
            axes.set_ylim(-1.25 * limit, 1.25 * limit)
        return svg.to_svg(figure, "Commands over time, between their limits")


def _strips_of(form: SetpointForm, limits: LimitsConfig) -> tuple[tuple[str, float | None], ...]:
    """Return what each number of a setpoint is, and its limit where it has one."""
    climb = ("climb rate [m/s]", limits.vertical_speed_max)
    turn = ("yaw rate [rad/s], counter-clockwise is positive", limits.yaw_rate_max)
    strips: dict[SetpointForm, tuple[tuple[str, float | None], ...]] = {
        SetpointForm.VELOCITY: (("forward [m/s]", None), ("left [m/s]", None), climb, turn),
        SetpointForm.POSITION: (("x [m]", None), ("y [m]", None), ("z [m]", None), turn),
    }
    tilt = limits.tilt_max
    leaning = ("pitch \u03b8 [rad], forward is positive", tilt)
    return strips.get(form, (leaning, ("roll \u03c6 [rad], right is positive", tilt), climb, turn))


def states_svg(flight: FlightSeries) -> str:
    """Return the states of mission, acceptor and gate as labelled bands."""
    with svg.drawing("states"):
        figure, rows = _strips(flight, 3, row=0.78)
        safety = tuple(_SAFETY_FILLS[mode] for mode in SAFETY_MODES)
        _draw_bands(rows[0], "errand", flight, flight.phase, PHASES, svg.STATE_FILLS)
        _draw_bands(rows[1], "behavior", flight, flight.behavior, BEHAVIORS, svg.STATE_FILLS)
        _draw_bands(rows[2], "safety", flight, flight.safety, SAFETY_MODES, safety)
        return svg.to_svg(figure, "States over time: errand, behavior and safety")


def health_svg(flight: FlightSeries, site: Site) -> str:
    """Return battery charge and the ages of pose and telemetry, with the limits of safety."""
    limits = site.limits
    with svg.drawing("health"):
        figure, rows = _strips(flight, 3)
        battery, pose, telemetry = rows
        battery.set_title("battery [%]")
        battery.plot(_elapsed(flight), 100.0 * flight.battery, color=svg.ACCENT)
        battery.set_ylim(0.0, 105.0)
        _limit(battery, 100.0 * limits.battery_floor, "land")
        _draw_age(pose, "age of the pose [s]", flight, flight.pose_age)
        _limit(pose, limits.pose_age_level, "level")
        _limit(pose, limits.pose_age_land, "land")
        _draw_age(telemetry, "age of the telemetry [s]", flight, flight.telemetry_age)
        _limit(telemetry, limits.telemetry_age, "land")
        return svg.to_svg(
            figure, "Battery, age of the pose and age of the telemetry over time, with their limits"
        )


def _strips(flight: FlightSeries, count: int, row: float = _ROW) -> tuple[Figure, list[Axes]]:
    height = row * count + 0.6
    figure = Figure(figsize=(_WIDTH, height))
    # The same margins everywhere: one moment stands at one place in all pictures of the page.
    figure.subplots_adjust(
        left=0.06, right=0.985, bottom=0.42 / height, top=1.0 - 0.3 / height, hspace=0.45
    )
    rows = list(np.atleast_1d(figure.subplots(count, 1, sharex=True)))
    rows[-1].set_xlabel("time [s]")
    elapsed = _elapsed(flight)
    rows[0].set_xlim(0.0, max(float(elapsed[-1]), 1.0) if elapsed.size else 1.0)
    return figure, rows


def _elapsed(flight: FlightSeries) -> FloatArray:
    return flight.time - flight.time[0] if flight.time.size else flight.time


def _unwound(flight: FlightSeries) -> tuple[FloatArray, FloatArray]:
    """Return estimate and reference with headings that do not jump where an angle wraps."""
    estimate, reference = flight.estimate.copy(), flight.reference.copy()
    known = np.isfinite(estimate[:, 3])
    estimate[known, 3] = np.unwrap(estimate[known, 3])
    reference[:, 3] = (
        estimate[:, 3] + np.remainder(reference[:, 3] - estimate[:, 3] + pi, 2.0 * pi) - pi
    )
    return estimate, reference


def _draw_bands(
    axes: Axes,
    title: str,
    flight: FlightSeries,
    numbers: IntArray,
    states: tuple[Enum, ...],
    colours: tuple[str, ...],
) -> None:
    axes.set_title(title)
    axes.set(ylim=(0.0, 1.0), yticks=[])
    axes.grid(visible=False)
    axes.spines["left"].set_visible(False)
    if not numbers.size:
        return
    elapsed = _elapsed(flight)
    present = [
        Patch(facecolor=colours[number], label=states[number].value)
        for number in np.unique(numbers)
    ]
    axes.legend(
        handles=present,
        loc="lower right",
        bbox_to_anchor=(1.0, 0.92),
        ncols=7,
        handlelength=1.0,
        columnspacing=1.2,
    )
    starts = np.concatenate(([0], np.flatnonzero(np.diff(numbers)) + 1))
    for start, end in zip(starts, np.append(starts[1:], numbers.size - 1), strict=True):
        left, width = float(elapsed[start]), float(elapsed[end] - elapsed[start])
        state = int(numbers[start])
        axes.broken_barh([(left, width)], (0.08, 0.84), facecolor=colours[state], edgecolor="none")
        if width * _WIDTH / max(float(elapsed[-1]), 1e-9) > 0.068 * len(states[state].value):
            axes.text(
                left + width / 2,
                0.48,
                states[state].value,
                ha="center",
                va="center",
                fontsize=8,
                color=svg.TEXT,
            )


def _draw_age(axes: Axes, title: str, flight: FlightSeries, age: FloatArray) -> None:
    axes.set_title(title)
    axes.plot(_elapsed(flight), np.maximum(age, 1e-3), color=svg.ACCENT, linewidth=0.8)
    axes.set(
        yscale="log",
        ylim=(5e-4, 10.0),
        yticks=[1e-3, 1e-2, 1e-1, 1.0, 10.0],
        yticklabels=["0.001", "0.01", "0.1", "1", "10"],
    )
    axes.minorticks_off()


def _limit(axes: Axes, value: float, consequence: str) -> None:
    axes.axhline(value, color=svg.WARN, linewidth=1.0, linestyle=(0, (1, 2)))
    axes.annotate(
        consequence,
        (1.0, value),
        xycoords=("axes fraction", "data"),
        xytext=(-2, 2),
        textcoords="offset points",
        ha="right",
        fontsize=8,
    )
