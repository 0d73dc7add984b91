"""A mission as the arrays and numbers that the compiled loop reads."""

from __future__ import annotations

from math import inf, nan, sqrt
from typing import NamedTuple

import numpy as np

from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.numeric import FloatArray, compiled
from housefly.pilot.behavior.path_profile import PathProfile, path_profile
from housefly.pilot.behavior.trajectory_progress import is_in_space

PATH, STEP, HOLD = range(3)
TASKS = {Task.PATH: PATH, Task.STEP: STEP, Task.HOLD: HOLD}
STRAIGHT = 1e-9
"""A corner that turns the path by less than this is none [rad]."""
CURVE_TOLERANCE = 5e-4
"""The legs that measure a curve lie no farther from it than this [m]."""


class Route(NamedTuple):
    """What every drone of an experiment is to do.

    Attributes:
        task: ``PATH``, ``STEP`` or ``HOLD``.
        start_x, start_y: where the drone is at first [m].
        path: for the reference of both modes, on corners or through space.
        line: the path in the plane, without waypoints in straight legs, for measuring [m], shape
            (m, 2).
        marks: arc length of the line at its corners [m], shape (m,).
        last_x, last_y: direction of the last leg, 0 when there is none.
        height: z_ref at the start, and where there is no trajectory [m].
        yaw: at the start [rad].
        arrival_yaw: at the end [rad]; nan keeps the path's.
        settle: when the task begins [s].
        duration: of the flight [s].
    """

    task: int
    start_x: float
    start_y: float
    path: PathProfile
    line: FloatArray
    marks: FloatArray
    last_x: float
    last_y: float
    height: float
    yaw: float
    arrival_yaw: float
    settle: float
    duration: float


def route_of(mission: FlightPlan) -> Route:
    """Return a mission as arrays."""
    way = _way_of(mission)
    line = _without_straight(way.points) if not is_in_space(way) else _drawn(way.motion[:, :2])
    if mission.task is Task.STEP:
        line = way.points[[0, -1]] if len(way.points) > 1 else way.points
    leg = line[-1] - line[-2] if len(line) > 1 else np.zeros(2)
    last = leg / max(float(np.hypot(*leg)), 1e-12)
    return Route(
        task=TASKS[mission.task],
        start_x=float(mission.waypoints[0][0]),
        start_y=float(mission.waypoints[0][1]),
        path=way,
        line=np.ascontiguousarray(line),
        marks=np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T)))),
        last_x=float(last[0]),
        last_y=float(last[1]),
        height=float(mission.height),
        yaw=float(mission.yaw),
        arrival_yaw=nan if mission.arrival_yaw is None else float(mission.arrival_yaw),
        settle=float(mission.settle),
        duration=float(mission.duration),
    )


def _way_of(mission: FlightPlan) -> PathProfile:
    if mission.task is Task.PATH and mission.trajectory is not None:
        return mission.trajectory
    return path_profile(
        mission.waypoints if mission.task is not Task.HOLD else mission.waypoints[:1]
    )


@compiled
def off_line(line: FloatArray, x: float, y: float) -> float:
    """Return the distance of a point from a line of straight legs [m], shape (m, 2)."""
    dx, dy = x - line[0, 0], y - line[0, 1]
    nearest = dx * dx + dy * dy
    for leg in range(len(line) - 1):
        nearest = min(nearest, _off_leg_squared(line, leg, x, y))
    return sqrt(nearest)


@compiled
def off_line_near(line: FloatArray, marks: FloatArray, x: float, y: float, reach: float) -> float:
    """Return the same; quickly when the line is known to pass within ``reach`` [m].

    A place on the line is no nearer than a corner is less the way between them.
    """
    nearest, leg, last = inf, 0, len(line) - 2
    while leg <= last:
        dx, dy = x - line[leg, 0], y - line[leg, 1]
        first = marks[leg] + sqrt(dx * dx + dy * dy) - reach
        while leg < last and marks[leg + 1] < first:
            leg += 1
        nearest = min(nearest, _off_leg_squared(line, leg, x, y))
        leg += 1
    off = sqrt(nearest)
    return off if off <= reach else off_line(line, x, y)


@compiled
def _off_leg_squared(line: FloatArray, leg: int, x: float, y: float) -> float:
    ax, ay = line[leg, 0], line[leg, 1]
    along_x, along_y = line[leg + 1, 0] - ax, line[leg + 1, 1] - ay
    share = ((x - ax) * along_x + (y - ay) * along_y) / (along_x * along_x + along_y * along_y)
    share = min(max(share, 0.0), 1.0)
    dx, dy = x - ax - share * along_x, y - ay - share * along_y
    return float(dx * dx + dy * dy)


def _without_straight(points: FloatArray) -> FloatArray:
    legs = np.diff(points, axis=0)
    turns = np.abs(legs[:-1, 0] * legs[1:, 1] - legs[:-1, 1] * legs[1:, 0])
    ahead = np.sum(legs[:-1] * legs[1:], axis=1) > 0.0
    straight = ahead & (turns <= STRAIGHT * np.hypot(*legs[:-1].T) * np.hypot(*legs[1:].T))
    return points[np.concatenate(([True], ~straight, [True]))] if len(points) > 2 else points


def _drawn(curve: FloatArray) -> FloatArray:
    """Return a curve as legs within ``CURVE_TOLERANCE`` (Douglas and Peucker 1973), shape (m, 2).

    One that leads straight up or stands is its first place.
    """
    moves = np.any(np.abs(np.diff(curve, axis=0)) > 0.0, axis=1)
    points = curve[np.concatenate(([True], moves))]
    kept, open_spans = {0, len(points) - 1}, [(0, len(points) - 1)]
    while open_spans:
        first, last = open_spans.pop()
        between = points[first + 1 : last]
        off = _off_chord(between, points[first], points[last])
        if len(between) and off.max() > CURVE_TOLERANCE:
            middle = first + 1 + int(off.argmax())
            kept.add(middle)
            open_spans += [(first, middle), (middle, last)]
    return points[sorted(kept)]


def _off_chord(points: FloatArray, a: FloatArray, b: FloatArray) -> FloatArray:
    leg = b - a
    along = np.einsum("nk,k->n", points - a, leg)
    share = np.clip(along / max(float((leg * leg).sum()), 1e-18), 0.0, 1.0)
    off: FloatArray = np.linalg.norm(points - a - share[:, None] * leg, axis=1)
    return off
