"""Plot of a judgement: the step response, and the gain margin over the gains."""

from __future__ import annotations

from dataclasses import replace
from math import sqrt
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from housefly.config.estimation import ONLY_LEVEL_PUSHES
from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_traced
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan, Task
from housefly.lab.tuning.advice import MIN_GAIN_MARGIN, GainQuestion, Judgement, stiffness_bound
from housefly.lab.tuning.loop import Loop, growth_of
from housefly.pilot.estimation.estimator_state import EstimatorKind
from housefly.record.plot_style import PLOT_STYLE, save_figure
from housefly.theme import GREEN, LIGHT, ORANGE

_RESPONSE_TIME = 8.0
"""Length of the step response [s]."""
_LEVELS = (1.0, 1.5, 2.0, 3.0, 4.0, 6.0)
_ALPHAS: NDArray[np.float64] = np.linspace(0.4, 12.0, 16)
_FREQUENCIES: NDArray[np.float64] = np.linspace(0.4, 5.0, 16)


def draw_judgement(judgement: Judgement, question: GainQuestion, stem: Path) -> tuple[Path, Path]:
    """Write ``stem.png`` and ``stem.svg`` and return them."""
    with matplotlib.rc_context(PLOT_STYLE):
        figure = Figure(figsize=(10.0, 4.2), layout="constrained")
        response, margins = figure.subplots(1, 2)
        _response(response, judgement, question)
        _map(figure, margins, judgement, question)
        return save_figure(figure, stem, dpi=150)


def _response(axes: Any, judgement: Judgement, question: GainQuestion) -> None:
    """Plot the batch engine's own flight, with noise and saturation."""
    ticks = _fly_step(judgement.loop, question)
    t = ticks["t"] - SETTLE
    shown = (t >= -0.5) & (t <= _RESPONSE_TIME)
    axes.plot(
        [-0.5, 0.0, 0.0, _RESPONSE_TIME],
        [0.0, 0.0, question.step, question.step],
        color=LIGHT.quiet,
        linestyle="--",
        label="reference",
    )
    axes.plot(t[shown], ticks["x"][shown], color=LIGHT.accent, label="drone")
    axes.set_xlabel("time after the step [s]")
    axes.set_ylabel("position [m]")
    axes.set_title("Step response, noise included", loc="left")
    tilt = axes.twinx()
    tilt.plot(t[shown], ticks["theta"][shown], color=ORANGE, linewidth=1.0)
    tilt.axhline(question.tilt_max, color=ORANGE, linestyle=":", linewidth=0.8)
    tilt.axhline(-question.tilt_max, color=ORANGE, linestyle=":", linewidth=0.8)
    tilt.set_ylim(-1.25 * question.tilt_max, 1.25 * question.tilt_max)
    tilt.set_ylabel("pitch [rad] (dotted: limit)", color=ORANGE)
    tilt.spines["right"].set_visible(True)
    axes.plot([], [], color=ORANGE, linewidth=1.0, label="pitch")
    axes.legend(loc="lower right")


def _fly_step(loop: Loop, question: GainQuestion) -> NDArray[Any]:
    """Return the flight of a step, tick by tick (``experiments.trace``)."""
    case = cases(
        Site(estimation=ONLY_LEVEL_PUSHES),
        1,
        estimator=EstimatorKind.ON_ARRIVAL if loop.paper else EstimatorKind.DELAY_COMPENSATED,
        rate_hz=loop.rate_hz,
        alpha=loop.alpha,
        beta=loop.beta,
        acceleration_noise=loop.acceleration_noise,
        position_noise=loop.position_noise,
        lag=loop.lag,
        model_lag=loop.lag,
        drag=loop.drag,
        model_drag=loop.drag,
        delay=loop.delay,
        model_delay=loop.delay,
        tilt_max=question.tilt_max,
        mocap_rate_hz=loop.tracking_hz,
        mocap_latency=loop.latency,
        mocap_noise=question.noise,
        seed=1,
    )
    ends = ((0.0, 0.0), (question.step, 0.0))
    return fly_traced(case, FlightPlan(Task.STEP, ends, SETTLE + _RESPONSE_TIME))


def _map(figure: Figure, axes: Any, judgement: Judgement, question: GainQuestion) -> None:
    """Plot the gain margin over alpha and frequency, with the bounds that need no tracking."""
    field = np.array(
        [
            [_gain(judgement.loop, alpha, frequency) for alpha in _ALPHAS]
            for frequency in _FREQUENCIES
        ]
    )
    filled = axes.contourf(
        _ALPHAS, _FREQUENCIES, field, levels=_LEVELS, cmap="cividis", extend="max"
    )
    axes.contour(
        _ALPHAS, _FREQUENCIES, field, levels=[MIN_GAIN_MARGIN], colors="white", linewidths=1.4
    )
    figure.colorbar(
        filled, ax=axes, label=f"gain margin (white line: {MIN_GAIN_MARGIN:g}; blank: unstable)"
    )
    alphas = np.linspace(_ALPHAS[0], _ALPHAS[-1], 200)
    axes.plot(
        alphas,
        np.sqrt(judgement.loop.lag * alphas),
        color=ORANGE,
        linewidth=1.4,
        label="beta = lambda alpha (Routh)",
    )
    axes.axhline(
        sqrt(stiffness_bound(question)),
        color=GREEN,
        linestyle="--",
        label=f"a step of {question.step:g} m saturates",
    )
    axes.plot(
        alphas,
        alphas / 2.0,
        color=LIGHT.quiet,
        linewidth=0.9,
        linestyle=":",
        label="critically damped",
    )
    axes.plot(
        judgement.loop.alpha,
        judgement.frequency,
        marker="*",
        markersize=15,
        color="white",
        markeredgecolor="black",
    )
    axes.set_xlim(_ALPHAS[0], _ALPHAS[-1])
    axes.set_ylim(_FREQUENCIES[0], _FREQUENCIES[-1])
    axes.set_xlabel("alpha [1/s]")
    axes.set_ylabel("natural frequency, sqrt(beta) [rad/s]")
    axes.set_title("Gain margin; the star is this pair", loc="left")
    axes.legend(loc="upper left", fontsize=8, frameon=True, framealpha=0.85)


def _gain(loop: Loop, alpha: float, frequency: float) -> float:
    """Return the gain margin to a few percent; nan where the loop is unstable."""
    own = replace(loop, alpha=float(alpha), beta=float(frequency) ** 2)
    low, high = 1.0, 8.0
    if growth_of(own) >= 1.0:
        return float("nan")
    if growth_of(replace(own, factor=high)) < 1.0:
        return high
    while high / low > 1.04:
        middle = sqrt(low * high)
        low, high = (
            (middle, high) if growth_of(replace(own, factor=middle)) < 1.0 else (low, middle)
        )
    return low
