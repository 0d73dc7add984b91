"""Fig. 11: the response of the pitch to a step, with the first-order curve of eq. (22)."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from housefly.config.profile import Interval
from housefly.lab.reproduction.angular_step import AngularStep, response
from housefly.lab.reproduction.drawing import write_figure
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.numeric import FloatArray
from housefly.theme import GREEN, LIGHT, ORANGE

ALPHA, THETA_MAX = 0.4, 0.21
"""Commanded share of the largest angle, and that angle [rad]: the paper's."""


@dataclass(frozen=True, slots=True, eq=False)
class StepFlight:
    """Steps in pitch and roll of one flight.

    Attributes:
        onboard: time since the command [s] and pitch [rad] of the first step, by onboard sensors.
        tracked: times [s] and angles [rad] of all steps, each over its sign, by tracking.
        fit: of the first step.
        constants: from all steps, as ``housefly identify`` finds them.
    """

    onboard: tuple[FloatArray, FloatArray]
    tracked: tuple[FloatArray, FloatArray]
    fit: AngularStep
    constants: dict[str, Interval]


def draw_fig11(folder: Path, steps: StepFlight) -> Exhibit:
    """Draw one step as the drone reports it, all steps as tracking saw them, and the fits."""
    step = steps.fit
    write_figure(
        folder,
        "fig11",
        (8.6, 4.0),
        lambda figure: _paint(figure, steps.onboard, steps.tracked, step),
    )
    lag, gain, delay = (
        steps.constants[key] for key in ("attitude_lag", "attitude_gain", "command_delay")
    )
    return Exhibit(
        "11",
        "Angular response to a step",
        "fig11",
        f"Angle over time for theta_des = alpha theta_max, alpha = {ALPHA}, theta_max = {THETA_MAX}"
        " rad; no constants are given.",
        f"The twin's pitch after a command of {ALPHA * THETA_MAX:.3f} rad. From all steps of one"
        f" flight: lambda = {lag.value:.2f} 1/s ({lag.low:.2f} to {lag.high:.2f}), c/lambda ="
        f" {gain.value:.3f} ({gain.low:.3f} to {gain.high:.3f}), delay = {1000 * delay.value:.0f}"
        f" ms ({1000 * delay.low:.0f} to {1000 * delay.high:.0f}), 95 % intervals. Without the"
        f" delay eq. (22) takes {step.lag_without_delay:.1f} 1/s for lambda.",
    )


def _paint(
    figure: Figure,
    onboard: tuple[FloatArray, FloatArray],
    tracked: tuple[FloatArray, FloatArray],
    step: AngularStep,
) -> None:
    axes = figure.subplots()
    end = float(onboard[0].max())
    asked = ALPHA * THETA_MAX
    axes.plot(
        [-0.1, 0.0, 0.0, end],
        [0.0, 0.0, asked, asked],
        color=LIGHT.quiet,
        linestyle="--",
        linewidth=1.2,
        label="commanded",
    )
    axes.plot(*tracked, ".", color=GREEN, markersize=4, alpha=0.6, label="tracking, all steps")
    axes.plot(*onboard, color=LIGHT.accent, linewidth=1.6, label="drone's own sensors, one step")
    times = np.linspace(0.0, end, 300)
    axes.plot(
        times,
        response(times, asked, step.gain, step.lag, step.delay),
        color=ORANGE,
        linewidth=1.4,
        label="eq. (22) after a delay",
    )
    plain = response(times, asked, step.gain, step.lag_without_delay, 0.0)
    axes.plot(times, plain, color=ORANGE, linewidth=1.0, linestyle=":", label="eq. (22) as printed")
    axes.set_xlabel("time since the command [s]")
    axes.set_ylabel("pitch theta [rad]")
    axes.set_xlim(-0.1, end)
    axes.set_ylim(-0.02, 1.35 * asked)
    axes.grid(True)
    axes.legend(loc="lower right")
