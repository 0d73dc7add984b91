"""Gain, lag, delay and drag fitted to the angles and positions of the tilt blocks.

Paper eqs. (8)-(9) and (22)-(23), plus delay and drag.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from housefly.lab.identification.fit import BlockModel, Fit, fit_blocks
from housefly.lab.identification.response import (
    NO_DRAG,
    SWITCH_SPREAD,
    at_frames,
    delayed,
    first_order,
    grid_times,
    pulses,
    travelled,
)
from housefly.lab.identification.samples import Samples
from housefly.numeric import FloatArray

TILT_GAIN, TILT_LAG, TILT_DELAY, TILT_DRAG = range(4)
"""Order of the constants: c / lambda, lambda [1/s], delay [s], drag [1/s]."""
_START = np.array([1.0, 6.0, 0.08, 0.4])
_BOUNDS = np.array([0.2, 0.8, 0.0, 0.0]), np.array([2.0, 40.0, 0.45, 3.0])
_FIRST_NOISES = (0.007, 0.001)
"""Initial noise of angles [rad] and positions [m]."""
_MIN_NOISES = (0.0003, 0.0001)
_ROUNDS = 3


@dataclass(frozen=True, slots=True, eq=False)
class TiltFit:
    """The fit of the tilt blocks.

    Attributes:
        fit: constants in the order GAIN, LAG, DELAY, DRAG.
        angle_noise: what is left of the angles, one sigma [rad].
        place_noise: what is left of the positions, one sigma [m].
    """

    fit: Fit
    angle_noise: float
    place_noise: float


def fit_tilt(blocks: tuple[Samples, ...], seed: int = 0) -> TiltFit:
    """Fit all tilt blocks; angles and positions are weighted by their residuals in a few rounds."""
    noises, start = _FIRST_NOISES, _START
    for _ in range(_ROUNDS):
        angle_noise, place_noise = noises

        def model(constants: FloatArray, noises: tuple[float, float] = noises) -> list[BlockModel]:
            return [_tilt_block(samples, constants, noises) for samples in blocks]

        found = fit_blocks(model, start, _BOUNDS, seed)
        start = found.constants
        rests = [
            np.split(block.residual[: 2 * samples.at.size], 2)
            for samples, block in zip(blocks, found.blocks, strict=True)
        ]
        left = [
            float(np.sqrt(np.mean(np.concatenate(parts) ** 2)))
            for parts in zip(*rests, strict=True)
        ]
        noises = (
            max(left[0] * angle_noise, _MIN_NOISES[0]),
            max(left[1] * place_noise, _MIN_NOISES[1]),
        )
    return TiltFit(found, *noises)


def _tilt_block(samples: Samples, constants: FloatArray, noises: tuple[float, float]) -> BlockModel:
    """Return one block at given constants; rows are angles, positions, then prior knowledge.

    Its own terms: initial angle, position and speed, a constant push, an offset of the angles, and
    how much later than average each switch left.
    """
    gain, lag, delay, drag = constants
    times = grid_times(samples)
    angle = gain * first_order(delayed(samples, samples.sent, delay, times), lag)
    decay = np.exp(-lag * times)
    slowing = (1.0 - np.exp(-max(drag, NO_DRAG) * times)) / max(drag, NO_DRAG)
    pushed = (times - slowing) / max(drag, NO_DRAG)
    zero, one = np.zeros_like(times), np.ones_like(times)
    late = [gain * first_order(pulse, lag) for pulse in pulses(samples, delay, times)]
    angle_columns = (decay, zero, zero, zero, one, *late)
    place_columns = (
        travelled(decay, drag),
        one,
        slowing,
        pushed,
        zero,
        *(travelled(angle, drag) for angle in late),
    )
    angle_rows = (
        np.column_stack([at_frames(samples, times, column) for column in angle_columns]) / noises[0]
    )
    place_rows = (
        np.column_stack([at_frames(samples, times, column) for column in place_columns]) / noises[1]
    )
    modelled = [
        at_frames(samples, times, angle) / noises[0],
        at_frames(samples, times, travelled(np.tan(angle), drag)) / noises[1],
    ]
    known = np.hstack((np.zeros((len(late), 5)), np.eye(len(late)) / SWITCH_SPREAD))
    nothing = np.zeros(len(late))
    measured = np.concatenate((samples.angle / noises[0], samples.place / noises[1], nothing))
    return BlockModel(
        measured, np.concatenate((*modelled, nothing)), np.vstack((angle_rows, place_rows, known))
    )
