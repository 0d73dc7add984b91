"""The P laws of yaw and height (paper V-B): a rate that lags behind its command, a delay, one gain.

L(s) = K p e^(-s tau) / (s (s + p))
"""

from __future__ import annotations

from math import atan, inf, pi, radians, sqrt
from typing import NamedTuple

_MIN_PHASE_MARGIN, _MIN_GAIN_MARGIN = radians(60.0), 2.5
"""Margins required of both laws: phase [rad] and gain."""
_GAINS = tuple(round(0.05 * step, 2) for step in range(60, 1, -1))
"""Gains tried, highest first [1/s]: above 3 video blurs and motors howl."""


class RateLoop(NamedTuple):
    """A gain with its margins.

    Attributes:
        gain: K [1/s].
        phase: margin [rad].
        factor: gain margin.
        delay: margin of further delay [s].
    """

    gain: float
    phase: float
    factor: float
    delay: float


def rate_margins(gain: float, pole: float, delay: float) -> RateLoop:
    """Return a gain [1/s] with its margins.

    The pole of the rate is in 1/s, the delay of the loop in s.
    """
    # |L| = 1: w sqrt(w^2 + p^2) = K p, a quadratic in w^2.
    crossing = sqrt(0.5 * (sqrt(pole**4 + 4.0 * (gain * pole) ** 2) - pole**2))
    phase = pi / 2 - atan(crossing / pole) - crossing * delay
    turning = _phase_crossing(pole, delay)
    factor = inf if turning == inf else turning * sqrt(turning**2 + pole**2) / (gain * pole)
    return RateLoop(gain, phase, factor, phase / crossing)


def rate_loop(pole: float, delay: float) -> RateLoop:
    """Return the highest gain that keeps the margins."""
    found = (rate_margins(gain, pole, delay) for gain in _GAINS)
    return next(
        (
            loop
            for loop in found
            if loop.phase >= _MIN_PHASE_MARGIN and loop.factor >= _MIN_GAIN_MARGIN
        ),
        rate_margins(_GAINS[-1], pole, delay),
    )


def _phase_crossing(pole: float, delay: float) -> float:
    """Return the frequency [rad/s] where atan(w / p) + w tau = pi / 2."""
    if delay <= 0.0:
        return inf
    low, high = 0.0, pi / (2.0 * delay)
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (
            (middle, high) if atan(middle / pole) + middle * delay < pi / 2 else (low, middle)
        )
    return high
