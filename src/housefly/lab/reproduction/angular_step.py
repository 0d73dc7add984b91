"""The paper's identification of (c, lambda) from one step of a tilt angle, and what a pure delay
does to it (Fig. 11).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

Numbers = NDArray[np.float64]

START = (1.0, 5.0, 0.03)
"""Where the search for gain, lambda and delay begins: an ordinary drone."""
STEPS = (1e-4, 1e-4, 1e-4)
"""Relative steps of the numeric derivatives: larger than the kink that the delay makes between two
samples.
"""
BOUNDS = ([0.05, 0.2, 0.0], [5.0, 100.0, 0.5])


@dataclass(frozen=True, slots=True)
class AngularStep:
    """One step with the fitted first-order curve.

    Attributes:
        lag: lambda [1/s].
        gain: c / lambda.
        delay: pure delay [s].
        misfit: root of the mean square of what the curve leaves, as a share of the step.
        lag_without_delay: lambda of eq. (22) as printed, which has no delay [1/s].
        misfit_without_delay: what this leaves.
    """

    lag: float
    gain: float
    delay: float
    misfit: float
    lag_without_delay: float
    misfit_without_delay: float


def response(time: Numbers, asked: float, gain: float, lag: float, delay: float) -> Numbers:
    """Return the angle [rad] at times [s] since a command ``asked`` [rad]: eq. (22) after a pure
    delay.
    """
    late = np.maximum(time - delay, 0.0)
    return np.asarray(asked * gain * (1.0 - np.exp(-lag * late)))


def fit_step(time: Numbers, angle: Numbers, asked: float) -> AngularStep:
    """Return the fit to one measured step.

    Args:
        time: since the command [s], shape (n,).
        angle: measured [rad], shape (n,).
        asked: commanded [rad], not zero.
    """
    with_delay = _fitted(time, angle, asked, True)
    without = _fitted(time, angle, asked, False)
    misfit = partial(_misfit, time, angle, asked)
    gain, lag, delay = with_delay
    return AngularStep(lag, gain, delay, misfit(with_delay), without[1], misfit(without))


def _fitted(
    time: Numbers, angle: Numbers, asked: float, delayed: bool
) -> tuple[float, float, float]:
    def misses(guess: Numbers) -> Numbers:
        gain, lag, delay = guess
        return response(time, asked, gain, lag, delay if delayed else 0.0) - angle

    gain, lag, delay = least_squares(
        misses, START, bounds=BOUNDS, x_scale=(1.0, 5.0, 0.05), diff_step=STEPS
    ).x
    return float(gain), float(lag), float(delay) if delayed else 0.0


def _misfit(
    time: Numbers, angle: Numbers, asked: float, fitted: tuple[float, float, float]
) -> float:
    misses = response(time, asked, *fitted) - angle
    return float(np.sqrt(np.mean(misses**2)) / abs(fitted[0] * asked))
