"""The fastest gains and filter that keep their stability margins, for a drone and its tracking.

The paper says that "simulations are running to pick out acceptable coefficients" (V-C) and gives
none. The rule here: critically damped, as fast as the margins below allow, also for a drone whose
lag was identified wrongly.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable
from dataclasses import dataclass, replace
from math import degrees, radians, sqrt, tan

import numpy as np

from housefly.geometry import GRAVITY
from housefly.lab.tuning.loop import Loop, period_of
from housefly.lab.tuning.margins import Margins, is_stable, margins_of
from housefly.lab.tuning.rate_loop import RateLoop, rate_loop
from housefly.numeric import FloatArray

_FREQUENCIES = tuple(round(0.3 + 0.05 * step, 2) for step in range(55))
"""Natural frequencies tried [rad/s]. Above 3 the attitude is no longer a first-order lag."""
_DAMPING = 1.0
MIN_GAIN_MARGIN, MIN_PHASE_MARGIN, MIN_DELAY_MARGIN = 2.0, radians(30.0), 0.05
"""Margins required of the identified drone: gain, phase [rad], delay [s] (at least one frame).

A Nyquist curve that stays one half away from -1 has at least these margins of gain and phase.
"""
_WRONG_LAGS = (0.7, 1.4)
"""The true lambda may be these multiples of the believed one."""
WRONG_LAG_GAIN_MARGIN, WRONG_LAG_PHASE_MARGIN = 1.5, radians(20.0)
"""Margins of gain and phase [rad] required then."""
_MIN_NOISE = 0.0005
"""Smallest tracking noise assumed [m]."""
_ACCELERATION_NOISES = (0.1, 0.2, 0.4, 0.8, 1.6)
"""Values of Q tried, one sigma [m/s^2]."""

_GUST = 0.1
"""One sigma of the push by moving air that the advice assumes [m/s^2]."""
_GUST_TIME = 1.0
"""Correlation time of the push [s]."""

_MAX_DOUBLINGS, _NEGLIGIBLE = 40, 1e-12
"""The sum ends when what is added is a smaller share than this; 2^40 periods are years."""


@dataclass(frozen=True, slots=True)
class GainQuestion:
    """The drone and tracking that gains are wanted for, in SI units.

    Attributes:
        loop: drone, tracking and rates; its gains and noises do not count.
        climb_lag: pole of the climb rate [1/s].
        yaw_lag: pole of the yaw rate [1/s].
        noise: one sigma of a tracked coordinate [m].
        step: largest jump of the reference [m].
        tilt_max: largest pitch or roll [rad].
    """

    loop: Loop
    climb_lag: float = 1.4
    yaw_lag: float = 25.0
    noise: float = 0.001
    step: float = 0.5
    tilt_max: float = 0.21


@dataclass(frozen=True, slots=True)
class Judgement:
    """The margins of a pair (alpha, beta), and objections to it.

    Attributes:
        loop: the pair with everything else.
        margins: with the drone as identified.
        wrong_lag: by share of the believed lambda.
        error: predicted position error in noise and gusts, one sigma [m].
        objections: what is wrong, in words; empty when every promise is kept.
    """

    loop: Loop
    margins: Margins
    wrong_lag: tuple[tuple[float, Margins], ...]
    error: float
    objections: tuple[str, ...]

    @property
    def frequency(self) -> float:
        """Natural frequency [rad/s]."""
        return sqrt(self.loop.beta)

    @property
    def damping(self) -> float:
        """Damping ratio."""
        return self.loop.alpha / (2.0 * self.frequency)


@dataclass(frozen=True, slots=True)
class Advice:
    """The recommended gains.

    Attributes:
        judgement: of alpha and beta with the filter's Q and R.
        yaw: K1 with its margins.
        height: K2 with its margins.
    """

    judgement: Judgement
    yaw: RateLoop
    height: RateLoop


def stiffness_bound(question: GainQuestion) -> float:
    """Return the largest beta [1/s^2] at which the step does not saturate the tilt.

    It is g tan(theta_max) / step.
    """
    return GRAVITY * tan(question.tilt_max) / question.step


def routh_objection(alpha: float, beta: float, lag: float) -> str:
    """Return why a pair is unstable with any tracking, or "" (Routh).

    The polynomial is s^3 + lambda s^2 + lambda alpha s + lambda beta.
    """
    if alpha <= 0.0 or beta <= 0.0:
        return f"alpha ({alpha:g} 1/s) and beta ({beta:g} 1/s^2) must be positive"
    if beta >= lag * alpha:
        return (
            f"beta ({beta:g} 1/s^2) is not below lambda * alpha ({lag * alpha:g} 1/s^2): with the"
            " attitude lag the loop is unstable however good the tracking"
        )
    return ""


def judge(question: GainQuestion, alpha: float, beta: float) -> Judgement:
    """Return the margins of a pair and what speaks against it."""
    loop = replace(question.loop, alpha=alpha, beta=beta)
    margins = margins_of(loop)
    wrong = tuple((share, margins_of(_with_lag(loop, share))) for share in _WRONG_LAGS)
    objections = [
        *filter(None, [routh_objection(alpha, beta, loop.lag)]),
        *_objections(question, loop, margins, wrong),
    ]
    error = position_error(loop, question.noise) if is_stable(loop) else float("inf")
    return Judgement(loop, margins, wrong, error, tuple(objections))


def advise(
    question: GainQuestion, on_progress: Callable[[str], object] = lambda words: None
) -> Advice | None:
    """Return the recommendation, or None when even the slowest pair misses a required margin.

    A small Q trusts the model and filters noise well, but costs phase. So the fastest pair is found
    for each Q, and the one with the smallest error in noise and gusts wins.

    Args:
        question: drone and tracking.
        on_progress: told in words what is being done.
    """
    position_noise = max(question.noise, _MIN_NOISE)
    found = []
    for noise in _ACCELERATION_NOISES:
        on_progress(f"the fastest pair that keeps its margins with Q {noise:g} m/s^2")
        loop = replace(question.loop, position_noise=position_noise, acceleration_noise=noise)
        fastest = _fastest(replace(question, loop=loop))
        if fastest is not None:
            found.append(fastest)
    if not found:
        return None
    best = min(found, key=lambda loop: position_error(loop, question.noise))
    delay = best.delay + best.latency + 0.5 / best.rate_hz + 0.5 / best.tracking_hz
    on_progress("the margins of the best of them")
    judged = judge(replace(question, loop=best), best.alpha, best.beta)
    return Advice(judged, rate_loop(question.yaw_lag, delay), rate_loop(question.climb_lag, delay))


def _fastest(question: GainQuestion) -> Loop | None:
    """Return the fastest loop that keeps the margins, by bisection: slower is always safer."""
    keeping: Loop | None = None
    low, high = 0, len(_FREQUENCIES)
    while low < high:
        middle = (low + high) // 2
        frequency = _FREQUENCIES[middle]
        loop = replace(question.loop, alpha=2.0 * _DAMPING * frequency, beta=frequency**2)
        if _keeps(question, loop):
            keeping, low = loop, middle + 1
        else:
            high = middle
    return keeping


def _keeps(question: GainQuestion, loop: Loop) -> bool:
    """Return whether a loop keeps every required margin, each tested at its limit."""
    if loop.beta > stiffness_bound(question) or not is_stable(loop):
        return False
    known = loop.delay if loop.model_delay is None else loop.model_delay
    later = replace(
        loop, delay=loop.delay + max(MIN_DELAY_MARGIN, 1.0 / loop.tracking_hz), model_delay=known
    )
    wrong = (_with_lag(loop, share) for share in _WRONG_LAGS)
    return (
        is_stable(later)
        and _has(loop, MIN_GAIN_MARGIN, MIN_PHASE_MARGIN)
        and all(
            is_stable(other) and _has(other, WRONG_LAG_GAIN_MARGIN, WRONG_LAG_PHASE_MARGIN)
            for other in wrong
        )
    )


def _has(loop: Loop, gain: float, phase: float) -> bool:
    return is_stable(replace(loop, factor=gain)) and is_stable(
        replace(loop, factor=exp(-1j * phase))
    )


def _with_lag(loop: Loop, share: float) -> Loop:
    believed = loop.lag if loop.model_lag is None else loop.model_lag
    return replace(loop, lag=believed * share, model_lag=believed)


def _objections(
    question: GainQuestion, loop: Loop, margins: Margins, wrong: tuple[tuple[float, Margins], ...]
) -> list[str]:
    frame = 1.0 / loop.tracking_hz
    delay = max(MIN_DELAY_MARGIN, frame)
    bound = stiffness_bound(question)
    found = []
    if margins.gain < MIN_GAIN_MARGIN:
        found.append(f"gain margin {margins.gain:.2f} is below {MIN_GAIN_MARGIN:g}")
    if margins.phase < MIN_PHASE_MARGIN:
        found.append(
            f"phase margin {degrees(margins.phase):.0f} deg is below"
            f" {degrees(MIN_PHASE_MARGIN):.0f} deg"
        )
    if margins.delay < delay:
        found.append(f"delay margin {1000 * margins.delay:.0f} ms is below {1000 * delay:.0f} ms")
    for share, at in wrong:
        if at.gain < WRONG_LAG_GAIN_MARGIN or at.phase < WRONG_LAG_PHASE_MARGIN:
            found.append(
                f"with lambda {100 * share - 100:+.0f} % gain margin {at.gain:.2f} or phase margin"
                f" {degrees(at.phase):.0f} deg is below {WRONG_LAG_GAIN_MARGIN:g} or"
                f" {degrees(WRONG_LAG_PHASE_MARGIN):.0f} deg"
            )
    if loop.beta > bound:
        found.append(
            f"a step of {question.step:g} m saturates the tilt: beta is above {bound:.2f} 1/s^2"
        )
    return found


def position_error(loop: Loop, noise: float) -> float:
    """Return one sigma of the position error [m] of a stable loop.

    Args:
        loop: with gains and filter.
        noise: one sigma of a tracked coordinate [m].
    """
    period = period_of(loop)
    ticks = period.noise.shape[1] - period.frames
    # White pushes with the gusts' spectral density at rest, 2 sigma^2 T.
    push = _GUST * np.sqrt(2.0 * _GUST_TIME / loop.rate_hz)
    sigmas = np.concatenate((np.full(period.frames, noise), np.full(ticks, push)))
    added = period.noise.real * sigmas
    covariance = _steady_covariance(period.matrix.real, added @ added.T)
    return float(np.sqrt(max(covariance[0, 0], 0.0)))


def _steady_covariance(matrix: FloatArray, added: FloatArray) -> FloatArray:
    """Return the sum of A^k Q A'^k over all k, doubled in length each round; A is stable."""
    covariance, power = added, matrix
    for _ in range(_MAX_DOUBLINGS):
        more = power @ covariance @ power.T
        covariance = covariance + more
        if np.abs(more).max() <= _NEGLIGIBLE * np.abs(covariance).max():
            break
        power = power @ power
    return covariance
