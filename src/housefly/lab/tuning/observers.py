"""The estimators of both modes at periodic steady state, as linear maps.

They are made of the live filters' own functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import floor
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from housefly.pilot.estimation.constant_velocity import ConstantVelocity, cv_predicted, cv_updated
from housefly.pilot.estimation.delay_filter import PREDICTION_STEP_MAX
from housefly.pilot.estimation.estimator import (
    DISTURBANCE_WANDER,
    HOVER_BRAKING,
)
from housefly.pilot.estimation.lagged_axis import (
    AxisModel,
    AxisState,
    Transition,
    initial_covariance,
    predicted_axis,
    predicted_covariance,
    transition,
    updated_covariance,
)

Rows = NDArray[np.float64] | NDArray[np.complex128]
"""Quantities as coefficients, shape (quantities, state and noises)."""
_IssuedCommand = Callable[[int, int], Rows]
"""Returns the command issued at one tick, as asked for at another."""
ROUNDING = 1e-9
"""Times that differ by less are the same [ticks or s]."""
_SETTLED_SHARE = 1e-9
"""The covariance is periodic once its gains change by less than this share per period."""
_MAX_ROUNDS = 5000


@dataclass(frozen=True, slots=True)
class Timing:
    """The ticks and frames of a common period; frame 0 is the first one in it.

    Attributes:
        tick: between two control ticks [s].
        interval: between two frames [s].
        ticks: in a common period.
        frames: in a common period.
        phase: of the frames, as a share of their interval.
        latency: from exposure to arrival [s].
    """

    tick: float
    interval: float
    ticks: int
    frames: int
    phase: float
    latency: float

    def taken_at(self, frame: int) -> float:
        """Return when a frame is exposed [s]."""
        return (frame + self.phase) * self.interval

    def captured(self, at: float) -> int:
        """Return the number of the next frame after a time [s]; a frame at that time has passed."""
        return floor(at / self.interval - self.phase + ROUNDING) + 1

    def delivered(self, at: float) -> int:
        """Return the number of the first frame that has not arrived by a time [s]."""
        return self.captured(at - self.latency)


class Observer(Protocol):
    """An estimator as a linear map; ``delay`` is the command delay that it believes [s]."""

    size: int
    delay: float

    def corrected(
        self, own: Rows, frame: int, measured: Rows, tick: int, issued: _IssuedCommand
    ) -> Rows:
        """Return the estimator's rows after a frame arrived at a tick."""
        ...

    def output(self, own: Rows, tick: int, issued: _IssuedCommand) -> tuple[Rows, Rows, Rows, Rows]:
        """Return the estimator's rows at a tick, and what control sees.

        Control sees position, velocity and the push to be cancelled.
        """
        ...


class _Way(NamedTuple):
    """The prediction between two times as a linear map.

    Attributes:
        commands: ticks whose commands act in between.
        state: later state from the earlier one, shape (4, 4).
        command: later state from each of the commands, shape (4, commands).
    """

    commands: tuple[int, ...]
    state: NDArray[np.float64]
    command: NDArray[np.float64]


class _StampedObserver:
    """Mode default: frames count when captured; predicts to when a command given now acts."""

    size = 4

    def __init__(
        self, timing: Timing, model: AxisModel, delay: float, position_noise: float
    ) -> None:
        self.delay = delay
        self._timing, self._model = timing, model
        self._ways: dict[tuple[float, float], _Way] = {}
        self._gains = self._steady(position_noise**2)

    def corrected(
        self, own: Rows, frame: int, measured: Rows, tick: int, issued: _IssuedCommand
    ) -> Rows:
        """Predict from the previous frame to this one, then correct."""
        own = self._rolled(
            own, self._timing.taken_at(frame - 1), self._timing.taken_at(frame), tick, issued
        )
        better: Rows = own + self._gains[frame % self._timing.frames][:, None] * (measured - own[0])
        return better

    def output(self, own: Rows, tick: int, issued: _IssuedCommand) -> tuple[Rows, Rows, Rows, Rows]:
        """Predict from the last frame to one command delay ahead.

        The estimator's own rows stay at the frame.
        """
        now = tick * self._timing.tick
        last = self._timing.taken_at(self._timing.delivered(now) - 1)
        ahead = self._rolled(own, last, now + self.delay, tick, issued)
        return own, ahead[0], ahead[1], ahead[3]

    def _rolled(
        self, own: Rows, start: float, end: float, tick: int, issued: _IssuedCommand
    ) -> Rows:
        way = self._ways.get((start, end))
        if way is None:
            way = self._ways[start, end] = self._way(start, end)
        rolled: Rows = way.state @ own
        if way.commands:
            given = np.array([issued(min(index, tick - 1), tick) for index in way.commands])
            rolled += way.command @ given
        return rolled

    def _way(self, start: float, end: float) -> _Way:
        """Return the prediction between two times as matrices: rows pass through the live filter's
        own step, once for every pair of times in a period.
        """
        pieces = list(self._pieces(start, end))
        commands = sorted({index for _, _, index in pieces})
        rows = np.eye(4, 4 + len(commands))
        unit = np.eye(len(commands), 4 + len(commands), 4)
        axis: Any = AxisState(*rows)
        for at, until, index in pieces:
            step = _plain(transition)(self._model, True, round(until - at, 12))
            axis = _plain(predicted_axis)(axis, unit[commands.index(index)], step)
        predicted = np.array(axis)
        return _Way(tuple(commands), predicted[:, :4], predicted[:, 4:])

    def _pieces(self, start: float, end: float) -> Iterator[tuple[float, float, int]]:
        """Yield start [s], end [s] and the tick whose command acts between them."""
        tick, at = self._timing.tick, start
        while at < end - ROUNDING:
            index = floor((at - self.delay) / tick + ROUNDING)
            until = min(end, (index + 1) * tick + self.delay, at + PREDICTION_STEP_MAX)
            yield at, until, index
            at = until

    def _steady(self, variance: float) -> NDArray[np.float64]:
        """Return the Kalman gains of the frames of a period, shape (frames, 4)."""
        frames = self._timing.frames
        predicted, updated = _plain(predicted_covariance), _plain(updated_covariance)
        steps = [self._steps_to(frame) for frame in range(frames)]
        spread: Any = _plain(initial_covariance)(variance, self._model.noise)
        gains = np.zeros((frames, 4))
        for _ in range(_MAX_ROUNDS):
            before = gains.copy()
            for frame in range(frames):
                for step in steps[frame]:
                    spread = predicted(spread, step)
                gains[frame] = np.array(spread[:4]) / (spread.xx + variance)
                spread = updated(spread, variance)
            if np.abs(gains - before).max() <= _SETTLED_SHARE * np.abs(gains).max():
                break
        return gains

    def _steps_to(self, frame: int) -> list[Transition]:
        """Return the steps of the prediction from the frame before to this one."""
        timing = self._timing
        return [
            _plain(transition)(self._model, True, round(until - at, 12))
            for at, until, _ in self._pieces(timing.taken_at(frame - 1), timing.taken_at(frame))
        ]


class _PlainObserver:
    """Mode paper: frames count at arrival; the input is the command, without lag, delay or drag."""

    size = 2
    delay = 0.0

    def __init__(self, timing: Timing, noise: float, position_noise: float) -> None:
        self._timing = timing
        self._gains = self._steady(noise, position_noise**2)

    def corrected(
        self, own: Rows, frame: int, measured: Rows, tick: int, issued: _IssuedCommand
    ) -> Rows:
        """Correct at the tick, after predicting once per tick."""
        if frame == self._timing.delivered((tick - 1) * self._timing.tick):
            own = self._moved(own, tick, issued)
        better: Rows = own + self._gains[frame % self._timing.frames][:, None] * (measured - own[0])
        return better

    def output(self, own: Rows, tick: int, issued: _IssuedCommand) -> tuple[Rows, Rows, Rows, Rows]:
        """Return the estimate itself."""
        arrived = self._timing.delivered(tick * self._timing.tick) > self._timing.delivered(
            (tick - 1) * self._timing.tick
        )
        own = own if arrived else self._moved(own, tick, issued)
        return own, own[0], own[1], np.zeros_like(own[0])

    def _moved(self, own: Rows, tick: int, issued: _IssuedCommand) -> Rows:
        dt, push = self._timing.tick, issued(tick - 1, tick)
        return np.array([own[0] + dt * own[1] + 0.5 * dt * dt * push, own[1] + dt * push])

    def _steady(self, noise: float, variance: float) -> NDArray[np.float64]:
        """Return the Kalman gains of the frames of a period, shape (frames, 2)."""
        timing, predicted, updated = self._timing, _plain(cv_predicted), _plain(cv_updated)
        state, gains = ConstantVelocity(0.0, 0.0, variance, 0.0, 0.1), np.zeros((timing.frames, 2))
        for _ in range(_MAX_ROUNDS):
            before = gains.copy()
            for tick in range(timing.ticks):
                state = predicted(state, 0.0, noise, timing.tick)
                for frame in range(
                    timing.delivered((tick - 1) * timing.tick), timing.delivered(tick * timing.tick)
                ):
                    gains[frame % timing.frames] = np.array([state.xx, state.xv]) / (
                        state.xx + variance
                    )
                    state = updated(state, 0.0, variance)
            if np.abs(gains - before).max() <= _SETTLED_SHARE * np.abs(gains).max():
                break
        return gains


@lru_cache(maxsize=512)
def observer_of(
    timing: Timing,
    paper: bool,
    lag: float,
    drag: float,
    delay: float,
    noise: float,
    position_noise: float,
) -> Observer:
    """Return the observer of a mode.

    Args:
        timing: of ticks and frames.
        paper: the paper's filter, which takes lag, drag and delay for nothing.
        lag: lambda believed [1/s].
        drag: believed [1/s].
        delay: believed [s].
        noise: Q, one sigma [m/s^2].
        position_noise: R, one sigma [m].
    """
    if paper:
        return _PlainObserver(timing, noise, position_noise)
    return _StampedObserver(
        timing,
        AxisModel(lag, 1.0, drag, drag + HOVER_BRAKING, noise, DISTURBANCE_WANDER),
        delay,
        position_noise,
    )


def _plain(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return the uncompiled function: it is linear, so rows of coefficients pass through it."""
    found: Callable[..., Any] = function.py_func  # type: ignore[attr-defined]
    return found
