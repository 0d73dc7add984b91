"""One horizontal axis of the sampled closed loop as a linear map over one common period.

Control ticks, tracking frames, latency, command delay, attitude lag, drag, zero-order hold and the
mode's Kalman filter at its periodic steady state are included; saturation and the acceptor are not.
Every quantity is a row of coefficients on the state at the start of the period, so running the
period once gives its matrix exactly. The loop is stable when all eigenvalues of that matrix lie
inside the unit circle.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import ceil, floor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.errors import ConfigError
from housefly.lab.tuning.observers import ROUNDING, Observer, Rows, Timing, observer_of

_MAX_TICKS = 400
"""Most control ticks in a common period; other rates are rounded by less than half a percent."""
_MIN_PERIOD = 0.02
"""The common period is repeated until it is this long [s]."""

_SERIES_SHARE = 1e-18
"""The exponential series ends when a term is smaller than this; time times pole stays below 5."""


@dataclass(frozen=True, slots=True)
class Loop:
    """Everything that the position loop of one axis depends on, in SI units.

    Attributes:
        alpha: damping gain [1/s].
        beta: stiffness gain [1/s^2].
        lag: lambda of the drone [1/s].
        delay: from command to first reaction [s].
        drag: over mass [1/s].
        tracking_hz: frames per second.
        latency: from exposure to arrival [s].
        rate_hz: control ticks per second.
        paper: whether the paper's filter estimates.
        factor: what the drone does over what it is asked: real for gain, on the unit circle for
            phase.
        model_lag: lambda that the filter believes [1/s]; None: the drone's.
        model_delay: delay that the filter believes [s]; None: the drone's.
        acceleration_noise: Q, one sigma [m/s^2].
        position_noise: R, one sigma [m].
        phase: when frames are taken, as a share of their interval after a tick.
    """

    alpha: float
    beta: float
    lag: float
    delay: float
    drag: float = 0.58
    tracking_hz: float = 100.0
    latency: float = 0.02
    rate_hz: float = 100.0
    paper: bool = False
    factor: complex = 1.0
    model_lag: float | None = None
    model_delay: float | None = None
    acceleration_noise: float = 0.4
    position_noise: float = 0.003
    phase: float = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Period:
    """The loop over one common period.

    The first three states are position, velocity and tilt acceleration.

    Attributes:
        seconds: its length [s].
        matrix: state at the end from the state at the start, shape (n, n).
        noise: state at the end from the noises: one a frame [m], then one push a tick [m/s].
        frames: how many of the noises are frames'.
        asked: wanted acceleration at each tick, from the state at the start and the noises.
    """

    seconds: float
    matrix: Rows
    noise: Rows
    frames: int
    asked: Rows

    @property
    def growth(self) -> float:
        """Growth of the slowest mode in one second; below 1 the loop is stable."""
        return float(np.abs(np.linalg.eigvals(self.matrix)).max() ** (1.0 / self.seconds))


def timing_of(loop: Loop) -> Timing:
    """Return the ticks and frames of the shortest common period.

    Raises:
        ConfigError: tracking is too slow for any.
    """
    ratio = Fraction(loop.tracking_hz / loop.rate_hz).limit_denominator(_MAX_TICKS)
    if ratio <= 0:
        raise ConfigError(
            "--rate", f"is {loop.tracking_hz:g} Hz: too slow beside a loop at {loop.rate_hz:g} Hz"
        )
    repeats = max(1, ceil(_MIN_PERIOD * loop.rate_hz / ratio.denominator))
    ticks, frames = ratio.denominator * repeats, ratio.numerator * repeats
    return Timing(
        1.0 / loop.rate_hz, ticks / loop.rate_hz / frames, ticks, frames, loop.phase, loop.latency
    )


def growth_of(loop: Loop) -> float:
    """Return the growth of the slowest mode in one second; below 1 the loop is stable."""
    return period_of(loop, noises=False).growth


def period_of(loop: Loop, *, noises: bool = True) -> Period:
    """Return the loop over its common period; without ``noises`` their columns are left out."""
    timing = timing_of(loop)
    lag = loop.lag if loop.model_lag is None else loop.model_lag
    delay = loop.delay if loop.model_delay is None else loop.model_delay
    sigmas = loop.acceleration_noise, loop.position_noise
    observer = observer_of(timing, loop.paper, lag, loop.drag, delay, *sigmas)
    run = _Run(loop, timing, observer, noises)
    asked = []
    for tick in range(timing.ticks):
        run.control(tick)
        asked.append(run.rows[run.commands].copy())
        run.advance(tick)
    n = run.size
    return Period(
        timing.ticks * timing.tick, run.rows[:, :n], run.rows[:, n:], timing.frames, np.array(asked)
    )


class _Run:
    """A period under construction.

    Rows: plant (3); the last commands, newest first; the last frames, newest first; the observer's
        own.
    """

    def __init__(self, loop: Loop, timing: Timing, observer: Observer, noises: bool) -> None:
        self._loop, self._timing, self._observer = loop, timing, observer
        reach = timing.latency + timing.interval + timing.tick + max(loop.delay, observer.delay)
        kept_commands = ceil(reach / timing.tick) + 3
        kept_frames = max(
            timing.captured(k * timing.tick) - timing.delivered((k - 1) * timing.tick)
            for k in range(timing.ticks)
        )
        self.commands = 3
        self.frames = self.commands + kept_commands
        self.own = slice(
            self.frames + kept_frames + 1, self.frames + kept_frames + 1 + observer.size
        )
        self.size = self.own.stop
        columns = self.size + (timing.frames + timing.ticks if noises else 0)
        self._factor = loop.factor.real if loop.factor.imag == 0.0 else loop.factor
        self.rows: Rows = np.eye(self.size, columns, dtype=type(self._factor))
        self._has_noises, self._noises = noises, 0

    def control(self, tick: int) -> None:
        """Process the frames that have arrived at a tick, and issue its command."""
        now = tick * self._timing.tick
        before, after = (
            self._timing.delivered(now - self._timing.tick),
            self._timing.delivered(now),
        )
        newest = self._timing.captured(now) - 1
        own = self.rows[self.own]
        for frame in range(before, after):
            own = self._observer.corrected(
                own, frame, self.rows[self.frames + newest - frame], tick, self._issued
            )
        own, position, velocity, push = self._observer.output(own, tick, self._issued)
        self.rows[self.own] = own
        wanted = -self._loop.beta * position - self._loop.alpha * velocity - push
        self.rows[self.commands + 1 : self.frames] = self.rows[
            self.commands : self.frames - 1
        ].copy()
        self.rows[self.commands] = wanted

    def advance(self, tick: int) -> None:
        """Advance the drone to the next tick, exposing frames on the way."""
        timing, loop = self._timing, self._loop
        at, end = tick * timing.tick, (tick + 1) * timing.tick
        if self._has_noises:
            self.rows[1, self.size + timing.frames + tick] += 1.0
        while at < end - ROUNDING:
            index = floor((at - loop.delay) / timing.tick + ROUNDING)
            until = min(end, (index + 1) * timing.tick + loop.delay)
            frame = timing.captured(at)
            until = min(until, timing.taken_at(frame))
            # The newest command is that of this tick.
            pushed = self._factor * self.rows[self.commands + tick - index]
            self.rows[:3] = advanced(self.rows[:3], pushed, loop.lag, loop.drag, until - at)
            at = until
            if timing.captured(at) > frame:
                self._expose()

    def _expose(self) -> None:
        last = self.own.start
        self.rows[self.frames + 1 : last] = self.rows[self.frames : last - 1].copy()
        self.rows[self.frames] = self.rows[0]
        if self._has_noises:
            self.rows[self.frames, self.size + self._noises] += 1.0
            self._noises += 1

    def _issued(self, index: int, tick: int) -> Rows:
        """Return the command issued at tick ``index``.

        It is asked for at ``tick``, before that tick's own command is issued.
        """
        found: Rows = self.rows[self.commands + tick - 1 - index]
        return found


@lru_cache(maxsize=4096)
def _discrete(
    lag: float, drag: float, dt: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the matrix and input column of one step of dt [s].

    The system is x' = v, v' = a - drag v, a' = lag (u - a).
    """
    system = np.zeros((4, 4))
    system[0, 1] = dt
    system[1, 1:3] = -drag * dt, dt
    system[2, 2:] = -lag * dt, lag * dt
    step, term, order = np.eye(4), np.eye(4), 0
    while np.abs(term).max() > _SERIES_SHARE:
        order += 1
        term = term @ system / order
        step += term
    return step[:3, :3], step[:3, 3:]


def advanced(
    state: NDArray[Any], command: NDArray[Any], lag: float, drag: float, dt: float
) -> NDArray[Any]:
    """Return the rows of the state after dt [s] under a constant command.

    Args:
        state: rows of position, velocity and tilt acceleration, shape (3, n).
        command: row of the wanted acceleration, shape (n,).
        lag: lambda [1/s].
        drag: over mass [1/s].
        dt: [s].
    """
    matrix, column = _discrete(lag, drag, round(dt, 12))
    after: NDArray[Any] = matrix @ state + column * command
    return after
