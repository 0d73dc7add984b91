"""Responses to what was sent, on a fine grid: an integral of the commands makes them smooth in the
delay.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from housefly.errors import MissingPartError
from housefly.geometry import GRAVITY
from housefly.lab.identification.samples import Samples

try:
    from scipy.signal import lfilter
except ImportError as error:
    raise MissingPartError("scipy (identification)", "pip install 'housefly[lab]'") from error

Numbers = NDArray[np.float64]
STEP = 0.005
"""Grid of the responses [s]."""
SWITCH = 0.5
"""A command that changes by more than this share of the block's amplitude is a switch."""
SWITCH_SPREAD = 0.0087
"""One sigma of how late a switch leaves, beside the mean: 30 ms over the square root of twelve [s].
"""
NO_DRAG = 1e-4
"""Drag is at least this [1/s]: what it does in a block is less than the last digit of tracking."""


def grid(samples: Samples) -> Numbers:
    """Return the times at which responses are worked out [s]."""
    return np.arange(0.0, samples.block.duration + 2 * STEP, STEP)


def delayed(samples: Samples, sent: Numbers, delay: float, times: Numbers) -> Numbers:
    """Return the mean over each step of the grid of what was sent ``delay`` seconds before."""
    edges = np.concatenate((samples.sent_at, [times[-1] + STEP]))
    integral = np.concatenate(([0.0], np.cumsum(sent * np.diff(edges))))
    behind = times - delay
    result: Numbers = (
        np.interp(behind + STEP, edges, integral) - np.interp(behind, edges, integral)
    ) / STEP
    return result


def pulses(samples: Samples, delay: float, times: Numbers) -> list[Numbers]:
    """Return what each switch of the block would add to the commands of the grid if it came a
    second later.

    The drone's own command period makes every switch later by up to 30 ms, each by another time
    that nobody records.
    """
    jumps = np.flatnonzero(
        np.abs(np.diff(samples.sent, prepend=0.0)) > SWITCH * abs(samples.block.amplitude)
    )
    jumps = jumps[samples.sent_at[jumps] > -STEP]
    before = np.concatenate(([0.0], samples.sent))[jumps]
    found = []
    for at, change in zip(samples.sent_at[jumps], samples.sent[jumps] - before, strict=True):
        place = (at + delay) / STEP
        pulse = np.zeros_like(times)
        first = int(np.floor(place))
        for index, share in ((first, 1.0 - (place - first)), (first + 1, place - first)):
            if 0 <= index < pulse.size:
                pulse[index] = -change * share / STEP
        found.append(pulse)
    return found


def first_order(drive: Numbers, pole: float, start: float = 0.0) -> Numbers:
    """Return y' = pole (drive - y) on the grid, exact for a drive that is constant over each step."""
    keep = float(np.exp(-pole * STEP))
    driven = lfilter([0.0, 1.0 - keep], [1.0, -keep], drive)
    return np.asarray(driven + start * keep ** np.arange(drive.size))


def integrated(rate: Numbers) -> Numbers:
    """Return the integral of a rate on the grid, by trapezoids."""
    return np.concatenate(([0.0], np.cumsum(0.5 * (rate[1:] + rate[:-1])) * STEP))


def travelled(slope: Numbers, drag: float) -> Numbers:
    """Return how far a tilt takes a drone at rest [m], by its tangent: v' = g slope - drag v (paper
    eq. 8).
    """
    push = np.concatenate((0.5 * (slope[1:] + slope[:-1]), slope[-1:])) * GRAVITY
    drag = max(drag, NO_DRAG)
    return integrated(first_order(push / drag, drag))


def at_frames(samples: Samples, times: Numbers, values: Numbers) -> Numbers:
    """Return values of the grid at the times of the frames."""
    return np.asarray(np.interp(samples.at, times, values))
