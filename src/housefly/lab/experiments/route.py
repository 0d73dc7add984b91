"""A mission as the arrays and numbers that the compiled loop reads."""

from __future__ import annotations

from math import nan, sqrt
from typing import NamedTuple

import numpy as np

from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.numeric import FloatArray, compiled
from housefly.pilot.behavior.path_profile import PathProfile, path_profile

PATH, STEP, HOLD = range(3)
TASKS = {Task.PATH: PATH, Task.STEP: STEP, Task.HOLD: HOLD}
STRAIGHT = 1e-9
"""A corner that turns the path by less than this is none [rad]."""


class Route(NamedTuple):
    """What every drone of an experiment is to do.

    Attributes:
        task: ``PATH``, ``STEP`` or ``HOLD``.
        path: for the reference of both modes.
        line: the path without waypoints in straight legs, for measuring [m], shape (m, 2).
        last_x, last_y: direction of the last leg, 0 when there is none.
        height: z_ref [m].
        yaw: at the start [rad].
        arrival_yaw: at the end [rad]; nan keeps the path's.
        settle: when the task begins [s].
        duration: of the flight [s].
    """

    task: int
    path: PathProfile
    line: FloatArray
    last_x: float
    last_y: float
    height: float
    yaw: float
    arrival_yaw: float
    settle: float
    duration: float


def route_of(mission: FlightPlan) -> Route:
    """Return a mission as arrays."""
    way = path_profile(
        mission.waypoints if mission.task is not Task.HOLD else mission.waypoints[:1]
    )
    line = _without_straight(way.points)
    if mission.task is Task.STEP:
        line = way.points[[0, -1]] if len(way.points) > 1 else way.points
    leg = line[-1] - line[-2] if len(line) > 1 else np.zeros(2)
    last = leg / max(float(np.hypot(*leg)), 1e-12)
    return Route(
        task=TASKS[mission.task],
        path=way,
        line=np.ascontiguousarray(line),
        last_x=float(last[0]),
        last_y=float(last[1]),
        height=float(mission.height),
        yaw=float(mission.yaw),
        arrival_yaw=nan if mission.arrival_yaw is None else float(mission.arrival_yaw),
        settle=float(mission.settle),
        duration=float(mission.duration),
    )


@compiled
def off_line(line: FloatArray, x: float, y: float) -> float:
    """Return the distance of a point from a line of straight legs [m], shape (m, 2)."""
    dx, dy = x - line[0, 0], y - line[0, 1]
    nearest = dx * dx + dy * dy
    for leg in range(len(line) - 1):
        ax, ay = line[leg, 0], line[leg, 1]
        along_x, along_y = line[leg + 1, 0] - ax, line[leg + 1, 1] - ay
        share = ((x - ax) * along_x + (y - ay) * along_y) / (along_x * along_x + along_y * along_y)
        share = min(max(share, 0.0), 1.0)
        dx, dy = x - ax - share * along_x, y - ay - share * along_y
        nearest = min(nearest, dx * dx + dy * dy)
    return sqrt(nearest)


def _without_straight(points: FloatArray) -> FloatArray:
    legs = np.diff(points, axis=0)
    turns = np.abs(legs[:-1, 0] * legs[1:, 1] - legs[:-1, 1] * legs[1:, 0])
    ahead = np.sum(legs[:-1] * legs[1:], axis=1) > 0.0
    straight = ahead & (turns <= STRAIGHT * np.hypot(*legs[:-1].T) * np.hypot(*legs[1:].T))
    return points[np.concatenate(([True], ~straight, [True]))] if len(points) > 2 else points
