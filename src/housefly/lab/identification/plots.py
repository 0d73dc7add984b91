"""Plot of the fit: every block over its model, and the residuals."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from housefly.lab.identification.pattern import Axis
from housefly.lab.identification.response import delayed, first_order, grid_times
from housefly.lab.identification.result import Identified
from housefly.lab.identification.samples import Samples
from housefly.lab.identification.tilt import TILT_DELAY, TILT_GAIN, TILT_LAG
from housefly.numeric import FloatArray
from housefly.record.plot_style import PLOT_STYLE, save_figure
from housefly.theme import GREEN, LIGHT, ORANGE

_TITLES = {Axis.PITCH: "Pitch", Axis.ROLL: "Roll", Axis.TURN: "Turn", Axis.CLIMB: "Climb"}


class StepResponse(NamedTuple):
    """The first step of all tilt blocks, each divided by its command: the paper's Fig. 11.

    Attributes:
        at: times of the frames after the step [s].
        share: angle over commanded angle.
        fit_at: times of the fitted curve [s].
        fit: the curve.
    """

    at: FloatArray
    share: FloatArray
    fit_at: FloatArray
    fit: FloatArray


def step_response(found: Identified) -> StepResponse:
    """Return the response of the angle to the first part of every tilt block, offsets removed."""
    assert found.tilt is not None
    gain, lag, delay, _ = found.tilt.fit.constants
    at, share = [], []
    tilts = [block for block in found.blocks if block.angle.size]
    for block, model in zip(tilts, found.tilt.fit.blocks, strict=True):
        offset = (
            _own(model.own[: block.at.size], model.measured - model.modelled, block.at.size)
            * found.tilt.angle_noise
        )
        inside = block.at < block.block.part
        at.append(block.at[inside])
        share.append((block.angle - offset)[inside] / block.block.amplitude)
    times = np.linspace(0.0, tilts[0].block.part, 200)
    curve = gain * (1.0 - np.exp(-lag * np.maximum(times - delay, 0.0)))
    return StepResponse(np.concatenate(at), np.concatenate(share), times, curve)


def _own(columns: FloatArray, rest: FloatArray, count: int) -> FloatArray:
    """Return the block's initial angle and offset over time, fitted to the angles only."""
    used = columns[:, [0, 4]]
    solution, *_ = np.linalg.lstsq(used, rest[:count], rcond=None)
    return np.asarray(used @ solution)


def draw_fit(found: Identified, stem: Path) -> tuple[Path, Path]:
    """Write ``stem.png`` and ``stem.svg``: data and model above, residuals below; returns both."""
    assert found.tilt is not None and found.climb is not None and found.turn is not None
    with matplotlib.rc_context(PLOT_STYLE):
        figure = Figure(figsize=(12.0, 6.4), layout="constrained")
        panels = figure.subplots(2, 4, sharex="col", height_ratios=(2.2, 1.0))
        for column, axis in enumerate(_TITLES):
            _column(panels[0, column], panels[1, column], found, axis)
        figure.suptitle(_caption(found), fontsize=10)
        return save_figure(figure, stem, dpi=130)


def _caption(found: Identified) -> str:
    units = {
        "attitude_gain": "",
        "attitude_lag": " 1/s",
        "command_delay": " s",
        "drag": " 1/s",
        "climb_lag": " 1/s",
        "yaw_lag": " 1/s",
    }
    words = [
        f"{key} {value.value:.3g} ({value.low:.3g} to {value.high:.3g}){units[key]}"
        for key, value in found.constants.items()
    ]
    return ", ".join(words[:3]) + "\n" + ", ".join(words[3:])


def _column(above: Any, below: Any, found: Identified, axis: Axis) -> None:
    own = [
        (block, model, noise) for block, model, noise in _models(found) if block.block.axis is axis
    ]
    unit = "m" if axis is Axis.CLIMB else "rad"
    for block, model, noise in own:
        sign = np.sign(block.block.amplitude)
        count = block.at.size
        fitted = (model.measured - model.residual)[:count] * noise
        start = fitted[0] if axis in (Axis.CLIMB, Axis.TURN) else 0.0
        order = np.argsort(block.at)
        above.plot(
            block.at,
            sign * (model.measured[:count] * noise - start),
            ".",
            color=LIGHT.accent,
            markersize=3,
            alpha=0.5,
        )
        above.plot(
            block.at[order], sign * (fitted - start)[order], color=ORANGE, linewidth=1.0, alpha=0.8
        )
        below.plot(
            block.at,
            1000 * model.residual[:count] * noise,
            ".",
            color=LIGHT.quiet,
            markersize=3,
            alpha=0.6,
        )
    if axis in (Axis.PITCH, Axis.ROLL) and own:
        _asked(above, own[0][0], found)
    above.plot([], [], ".", color=LIGHT.accent, label="tracking")
    above.plot([], [], color=ORANGE, label="model")
    above.set_title(f"{_TITLES[axis]} ({len(own)} blocks)", loc="left")
    above.set_ylabel(
        {Axis.CLIMB: "height [m]", Axis.TURN: "heading [rad]"}.get(axis, "angle [rad]")
    )
    above.legend(
        frameon=False, fontsize=8, loc="upper left" if axis is Axis.CLIMB else "upper right"
    )
    below.axhline(0.0, color="black", linewidth=0.6)
    below.set_ylabel(f"left [m{unit}]")
    below.set_xlabel("time in the block [s]")


def _asked(panel: Any, block: Samples, found: Identified) -> None:
    assert found.tilt is not None
    times = grid_times(block)
    sign = np.sign(block.block.amplitude)
    panel.plot(
        times,
        sign * delayed(block, block.sent, 0.0, times),
        color=GREEN,
        linewidth=0.9,
        linestyle="--",
        label="asked",
    )
    constants = found.tilt.fit.constants
    lagging = constants[TILT_GAIN] * first_order(
        delayed(block, block.sent, constants[TILT_DELAY], times), constants[TILT_LAG]
    )
    panel.set_ylim(-1.6 * np.abs(lagging).max(), 1.6 * np.abs(lagging).max())


def _models(found: Identified) -> list[tuple[Samples, Any, float]]:
    assert found.tilt is not None and found.climb is not None and found.turn is not None
    by_kind = {
        "tilt": (found.tilt.fit.blocks, found.tilt.angle_noise, (Axis.PITCH, Axis.ROLL)),
        "climb": (found.climb.fit.blocks, 0.001, (Axis.CLIMB,)),
        "turn": (found.turn.fit.blocks, 0.007, (Axis.TURN,)),
    }
    rows = []
    for models, noise, axes in by_kind.values():
        blocks = [block for block in found.blocks if block.block.axis in axes]
        rows += [(block, model, noise) for block, model in zip(blocks, models, strict=True)]
    return rows
