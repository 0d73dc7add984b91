"""The reference of mode paper: the centre of the next cell, target velocity zero, psi_ref 0 or pi
by the leg's direction in x.
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from housefly.geometry import Vec2
from housefly.messages import Path
from housefly.numeric import compiled, wrapped
from housefly.pilot.behavior.acceptor import PAPER_EPSILONS
from housefly.pilot.behavior.ride import Numbers, Target
from housefly.pilot.behavior.tracking import Track, track_of

EPS3 = PAPER_EPSILONS[2]


@compiled
def paper_heading(yaw: float) -> float:
    """Return whichever of 0 and pi is nearer to a heading [rad]."""
    return 0.0 if abs(wrapped(yaw)) <= pi / 2 else pi


@compiled
def cell_after(
    index: int, yaw: float, points: Numbers, x: float, y: float, eps3: float
) -> tuple[int, float]:
    """Return the waypoint and heading [rad] after one look: on to the next when q4 holds, the drone
    nearer than eps3 [m].

    Args:
        index: waypoint that the drone is sent to.
        yaw: 0 or pi.
        points: waypoints [m], shape (n, 2).
        x: where the drone is [m].
        y: likewise.
        eps3: tolerance of place [m].
    """
    dx, dy = x - points[index, 0], y - points[index, 1]
    if index == len(points) - 1 or not sqrt(dx * dx + dy * dy) < eps3:
        return index, yaw
    leg = points[index + 1, 0] - points[index, 0]
    turned = yaw if abs(leg) < 1e-6 else (0.0 if leg > 0.0 else pi)
    return index + 1, turned


@compiled
def cell_target(index: int, yaw: float, points: Numbers) -> Target:
    """Return the reference that stands on a waypoint."""
    return Target(
        points[index, 0], points[index, 1], 0.0, 0.0, 0.0, 0.0, yaw, index, index == len(points) - 1
    )


class CellFollower:
    """One path and the waypoint that the drone is sent to."""

    def __init__(self, path: Path, yaw: float) -> None:
        self._points = np.array(path.waypoints, dtype=float)
        self._index = 0
        self._yaw = paper_heading(yaw)

    def step(self, position: Vec2, moving: bool, dt: float) -> Track:
        """Go on to the next waypoint when q4 holds (nearer than eps3) and return the track; time
        and ``moving`` do not count.
        """
        self._index, self._yaw = cell_after(self._index, self._yaw, self._points, *position, EPS3)
        return track_of(cell_target(self._index, self._yaw, self._points), len(self._points) - 1)

    @property
    def finished(self) -> bool:
        """Whether this is the last one."""
        return self._index == len(self._points) - 1

    @property
    def goal(self) -> Vec2:
        """The end of the path [m]."""
        x, y = self._points[-1]
        return float(x), float(y)
