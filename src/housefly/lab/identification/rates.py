"""Time constants of climb and turn: a rate that lags its command, observed as its integral."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from housefly.lab.identification.fit import BlockModel, Fit, fit_blocks
from housefly.lab.identification.response import (
    SWITCH_SPREAD,
    at_frames,
    delayed,
    first_order,
    grid_times,
    integrated,
    pulses,
)
from housefly.lab.identification.samples import Samples
from housefly.numeric import FloatArray

TIME_CONSTANT, _GAIN, _SINK_GAIN = range(3)
"""Order of the constants: time constant [s], gain, and for climb the gain of sinking."""
_NOISES = {"climb": 0.001, "turn": 0.007}


@dataclass(frozen=True, slots=True, eq=False)
class RateFit:
    """The fit of the climb or turn blocks.

    Attributes:
        fit: constants in the order TIME, GAIN, OTHER_GAIN (climb only).
        half_time: half of the interval of the time constant, the doubt about the delay included
            [s].
        noise: what is left, one sigma [m or rad].
    """

    fit: Fit
    half_time: float
    noise: float


def fit_climb(
    blocks: tuple[Samples, ...], delay: float, half_delay: float, seed: int = 0
) -> RateFit:
    """Fit climb blocks; a drone may sink faster than it climbs, so each way has its own gain."""
    start, low, high = (0.6, 1.0, 1.0), (0.02, 0.2, 0.2), (5.0, 4.0, 4.0)

    def of(delay: float) -> Fit:
        return _fit(blocks, delay, _NOISES["climb"], (start, low, high), seed, _up_and_down)

    return _with_doubt(of, delay, half_delay, _NOISES["climb"])


def fit_turn(
    blocks: tuple[Samples, ...], delay: float, half_delay: float, seed: int = 0
) -> RateFit:
    """Fit turn blocks."""
    start, low, high = (0.1, 1.0), (0.0005, 0.2), (3.0, 3.0)

    def of(delay: float) -> Fit:
        return _fit(blocks, delay, _NOISES["turn"], (start, low, high), seed, _both_ways)

    return _with_doubt(of, delay, half_delay, _NOISES["turn"])


def _with_doubt(
    of: Callable[[float], Fit], delay: float, half_delay: float, noise: float
) -> RateFit:
    """Fit at the delay found and at both ends of its interval.

    A later command looks like a slower drone, so the uncertainty of the delay widens the interval.
    """
    fit = of(delay)
    ends = [
        of(max(0.0, delay + side * half_delay)).constants[TIME_CONSTANT] for side in (-1.0, 1.0)
    ]
    by_delay = 0.5 * abs(ends[1] - ends[0])
    left = float(np.sqrt(np.mean(np.concatenate([block.residual for block in fit.blocks]) ** 2)))
    return RateFit(fit, float(np.hypot(fit.half[TIME_CONSTANT], by_delay)), noise * left)


_Gains = Callable[[FloatArray, FloatArray], FloatArray]
"""Applies the gains to the commands on the grid."""


def _both_ways(drive: FloatArray, constants: FloatArray) -> FloatArray:
    return np.asarray(constants[_GAIN] * drive)


def _up_and_down(drive: FloatArray, constants: FloatArray) -> FloatArray:
    return np.asarray(np.where(drive > 0.0, constants[_GAIN], constants[_SINK_GAIN]) * drive)


def _fit(
    blocks: tuple[Samples, ...],
    delay: float,
    noise: float,
    limits: tuple[tuple[float, ...], tuple[float, ...], tuple[float, ...]],
    seed: int,
    parts: _Gains,
) -> Fit:
    def model(constants: FloatArray) -> list[BlockModel]:
        return [_block(samples, constants, delay, noise, parts) for samples in blocks]

    start, low, high = (np.array(numbers) for numbers in limits)
    return fit_blocks(model, start, (low, high), seed)


def _block(
    samples: Samples, constants: FloatArray, delay: float, noise: float, parts: _Gains
) -> BlockModel:
    """Return one block at given constants.

    Its own terms are the initial position and rate, and how much later than average each switch
    left.
    """
    times, pole = grid_times(samples), 1.0 / constants[TIME_CONSTANT]
    drive = delayed(samples, samples.sent, delay, times)
    rate = first_order(parts(drive, constants), pole)
    late = [
        integrated(first_order(constants[_GAIN] * pulse, pole))
        for pulse in pulses(samples, delay, times)
    ]
    columns = (np.ones_like(times), integrated(np.exp(-pole * times)), *late)
    own = np.column_stack([at_frames(samples, times, column) for column in columns]) / noise
    known = np.hstack((np.zeros((len(late), 2)), np.eye(len(late)) / SWITCH_SPREAD))
    nothing = np.zeros(len(late))
    measured, modelled = samples.place / noise, at_frames(samples, times, integrated(rate)) / noise
    return BlockModel(
        np.concatenate((measured, nothing)),
        np.concatenate((modelled, nothing)),
        np.vstack((own, known)),
    )
