"""Lets a pilot fly a line that was drawn beforehand instead of planning one: the figure eight."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from math import pi, tau
from typing import Any
from unittest.mock import patch

import numpy as np

from housefly.geometry import Vec2
from housefly.messages import Path, PlanAnswer
from housefly.numeric import FloatArray
from housefly.pilot import assembly
from housefly.pilot.navigator import RoomNavigator

_FINE = 4000
_RAMP = 2.0
"""The eight is begun and ended so gently [s]."""


def figure_eight(middle: Vec2, width: float, rounds: int) -> FloatArray:
    """Return points of a lemniscate of Gerono, from its middle to its middle [m], shape (n, 2).

    Args:
        middle: [m].
        width: from end to end along x; half of it along y [m].
        rounds: how often it is flown.
    """
    angle = np.linspace(0.0, tau * rounds, _FINE * rounds + 1) + pi / 2
    x, y = 0.5 * width * np.cos(angle), 0.25 * width * np.sin(2 * angle)
    return np.asarray(np.stack((middle[0] + x, middle[1] + y), axis=1))


def at_steps(line: FloatArray, step: float) -> FloatArray:
    """Return points of a line so far apart [m], its ends included, shape (n, 2)."""
    marks = _marks(line)
    wanted = np.linspace(0.0, marks[-1], max(2, round(marks[-1] / step) + 1))
    return np.stack([np.interp(wanted, marks, line[:, k]) for k in (0, 1)], axis=1)


def timed_rows(line: FloatArray, height: float, speed: float, tick: float) -> FloatArray:
    """Return place, velocity and acceleration at each tick of a line flown at a speed.

    Args:
        line: shape (n, 2) [m].
        height: [m].
        speed: after a smooth start and before a smooth end [m/s].
        tick: between two rows [s].

    Returns:
        Shape (m, 9).
    """
    marks = _marks(line)
    duration, fine = marks[-1] / speed + _RAMP, tick / 20.0
    times = np.arange(0.0, duration + fine, fine)
    along = speed * _ramped(times, duration)
    travelled = np.minimum(np.cumsum(along) * fine, marks[-1])
    places = np.stack([np.interp(travelled, marks, line[:, k]) for k in (0, 1)], axis=1)
    slopes = np.gradient(places, fine, axis=0)
    kernel = np.ones(41) / 41.0
    slopes = np.stack([np.convolve(slopes[:, k], kernel, "same") for k in (0, 1)], axis=1)
    pushes = np.gradient(slopes, fine, axis=0)
    pushes = np.stack([np.convolve(pushes[:, k], kernel, "same") for k in (0, 1)], axis=1)
    rows = np.zeros((len(times[::20]), 9))
    rows[:, :2], rows[:, 2] = places[::20], height
    rows[:, 3:5], rows[:, 6:8] = slopes[::20], pushes[::20]
    rows[-1, :2], rows[-1, 3:] = line[-1], 0.0
    return rows


@contextmanager
def preset_way(line: FloatArray, step: float, speed: float, height: float) -> Iterator[None]:
    """Let every pilot made in this block fly a line wherever it is sent.

    No order names a curve, and the planner is part of the pilot: so its navigator is replaced while
    the pilot is made.

    Args:
        line: shape (n, 2) [m].
        step: between the corners that a pilot on the grid is given [m].
        speed: along it, for a pilot that flies trajectories [m/s].
        height: likewise [m].
    """
    corners = at_steps(line, step)
    waypoints = tuple((float(x), float(y)) for x, y in corners)
    length = float(_marks(corners)[-1])

    class PresetNavigator(RoomNavigator):
        """Knows one way."""

        def route(self, start: Vec2, goal: Vec2) -> PlanAnswer:
            return PlanAnswer(start, goal, Path(waypoints, length, 1.0), duration=length / speed)

        def way(self, start: Any, goal: Vec2, *more: Any) -> Any:
            return _space_answer(line, height, speed)

    with patch.object(assembly, "RoomNavigator", PresetNavigator):
        yield


def _space_answer(line: FloatArray, height: float, speed: float) -> Any:
    """Return the line as a tree that flies trajectories answers."""
    answer = import_module("housefly.pilot.planning.space.answer").SpaceAnswer
    trajectory = import_module("housefly.pilot.planning.trajectory.trajectory").Trajectory
    tick = import_module("housefly.pilot.planning.trajectory.timing").TICK
    return answer(trajectory(timed_rows(line, height, speed, tick), float(_marks(line)[-1]), 1.0))


def _ramped(times: FloatArray, duration: float) -> FloatArray:
    """Return shares of the full speed: smooth up, full, smooth down."""
    u = np.clip(np.minimum(times, duration - times) / _RAMP, 0.0, 1.0)
    return np.asarray(u * u * u * (10.0 - 15.0 * u + 6.0 * u * u))


def _marks(line: FloatArray) -> FloatArray:
    return np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))))
