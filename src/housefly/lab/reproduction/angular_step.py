"""Identification of (c, lambda) from one tilt step as in the paper's Fig. 11, and with a delay."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.optimize import least_squares

from housefly.numeric import FloatArray

_START = (1.0, 5.0, 0.03)
"""Initial gain, lambda and delay of the search: an ordinary drone."""
_STEPS = (1e-4, 1e-4, 1e-4)
"""Relative steps of the numeric derivatives, larger than the kink of a delay between samples."""
_BOUNDS = ([0.05, 0.2, 0.0], [5.0, 100.0, 0.5])

_ASKED = 0.4 * 0.21
"""The paper's step in pitch [rad]."""
_DURATION, _SAMPLING = 1.0, 0.005
"""Of a simulated step, as the drone reports it [s]."""
_NOISE = 0.001
"""One sigma of a simulated angle [rad]."""


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


def response(time: FloatArray, asked: float, gain: float, lag: float, delay: float) -> FloatArray:
    """Return the angle [rad] at times [s] after the command ``asked`` [rad]: delayed eq. (22)."""
    late = np.maximum(time - delay, 0.0)
    return np.asarray(asked * gain * (1.0 - np.exp(-lag * late)))


def simulated_step(lag: float, delay: float) -> AngularStep:
    """Return the fit to a noisy step of a drone with this lambda [1/s] and pure delay [s]."""
    time = np.arange(0.0, _DURATION, _SAMPLING)
    noise = np.random.Generator(np.random.PCG64(0)).normal(0.0, _NOISE, time.size)
    return fit_step(time, response(time, _ASKED, 1.0, lag, delay) + noise, _ASKED)


def fit_step(time: FloatArray, angle: FloatArray, asked: float) -> AngularStep:
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
    time: FloatArray, angle: FloatArray, asked: float, delayed: bool
) -> tuple[float, float, float]:
    def misses(guess: FloatArray) -> FloatArray:
        gain, lag, delay = guess
        return response(time, asked, gain, lag, delay if delayed else 0.0) - angle

    gain, lag, delay = least_squares(
        misses, _START, bounds=_BOUNDS, x_scale=(1.0, 5.0, 0.05), diff_step=_STEPS
    ).x
    return float(gain), float(lag), float(delay) if delayed else 0.0


def _misfit(
    time: FloatArray, angle: FloatArray, asked: float, fitted: tuple[float, float, float]
) -> float:
    misses = response(time, asked, *fitted) - angle
    return float(np.sqrt(np.mean(misses**2)) / abs(fitted[0] * asked))
