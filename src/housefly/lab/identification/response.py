"""Responses to the commands on a fine grid; integrated commands keep them smooth in the delay."""

from __future__ import annotations

import numpy as np

from housefly.errors import MissingPartError
from housefly.geometry import GRAVITY
from housefly.lab.identification.samples import Samples
from housefly.numeric import FloatArray

try:
    from scipy.signal import lfilter
except ImportError as error:
    raise MissingPartError("scipy (identification)", "pip install 'housefly[lab]'") from error

_GRID_STEP = 0.005
"""Step of the grid [s]."""
_SWITCH_SHARE = 0.5
"""A command that changes by more than this share of the block's amplitude is a switch."""
SWITCH_SPREAD = 0.0087
"""One sigma of how much later than average a switch leaves: 30 ms / sqrt(12) [s]."""
NO_DRAG = 1e-4
"""Smallest drag [1/s]: its effect in a block is below the resolution of tracking."""


def grid_times(samples: Samples) -> FloatArray:
    """Return the times of the grid [s]."""
    return np.arange(0.0, samples.block.duration + 2 * _GRID_STEP, _GRID_STEP)


def delayed(samples: Samples, sent: FloatArray, delay: float, times: FloatArray) -> FloatArray:
    """Return the commands of ``delay`` seconds before, averaged over each step of the grid."""
    edges = np.concatenate((samples.sent_at, [times[-1] + _GRID_STEP]))
    integral = np.concatenate(([0.0], np.cumsum(sent * np.diff(edges))))
    behind = times - delay
    result: FloatArray = (
        np.interp(behind + _GRID_STEP, edges, integral) - np.interp(behind, edges, integral)
    ) / _GRID_STEP
    return result


def pulses(samples: Samples, delay: float, times: FloatArray) -> list[FloatArray]:
    """Return the derivative of the commands on the grid with respect to the time of each switch.

    The drone's command period delays every switch by up to 30 ms, by an amount that nobody records.
    """
    jumps = np.flatnonzero(
        np.abs(np.diff(samples.sent, prepend=0.0)) > _SWITCH_SHARE * abs(samples.block.amplitude)
    )
    jumps = jumps[samples.sent_at[jumps] > -_GRID_STEP]
    before = np.concatenate(([0.0], samples.sent))[jumps]
    found = []
    for at, change in zip(samples.sent_at[jumps], samples.sent[jumps] - before, strict=True):
        place = (at + delay) / _GRID_STEP
        pulse = np.zeros_like(times)
        first = int(np.floor(place))
        for index, share in ((first, 1.0 - (place - first)), (first + 1, place - first)):
            if 0 <= index < pulse.size:
                pulse[index] = -change * share / _GRID_STEP
        found.append(pulse)
    return found


def first_order(drive: FloatArray, pole: float, start: float = 0.0) -> FloatArray:
    """Return y' = pole (drive - y) on the grid, exact for a drive constant over each step."""
    keep = float(np.exp(-pole * _GRID_STEP))
    driven = lfilter([0.0, 1.0 - keep], [1.0, -keep], drive)
    return np.asarray(driven + start * keep ** np.arange(drive.size))


def integrated(rate: FloatArray) -> FloatArray:
    """Return the integral of a rate on the grid, by trapezoids."""
    return np.concatenate(([0.0], np.cumsum(0.5 * (rate[1:] + rate[:-1])) * _GRID_STEP))


def travelled(slope: FloatArray, drag: float) -> FloatArray:
    """Return how far a tilt (its tangent) takes a drone from rest [m] (paper eq. 8).

    v' = g slope - drag v.
    """
    push = np.concatenate((0.5 * (slope[1:] + slope[:-1]), slope[-1:])) * GRAVITY
    drag = max(drag, NO_DRAG)
    return integrated(first_order(push / drag, drag))


def at_frames(samples: Samples, times: FloatArray, values: FloatArray) -> FloatArray:
    """Interpolate values on the grid at the times of the frames."""
    return np.asarray(np.interp(samples.at, times, values))
