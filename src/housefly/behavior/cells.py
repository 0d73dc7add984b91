"""The reference of mode paper: the centre of the next cell, target velocity zero, psi_ref 0 or pi by the leg's direction in x."""

from __future__ import annotations

from math import pi

from housefly.behavior.acceptor import PAPER_EPSILONS
from housefly.behavior.tracking import Track
from housefly.geometry import Vec2, distance, wrap_angle
from housefly.messages import Path

EPS3 = PAPER_EPSILONS[2]


def paper_heading(yaw: float) -> float:
    """Return whichever of 0 and pi is nearer to a heading [rad]."""
    return 0.0 if abs(wrap_angle(yaw)) <= pi / 2 else pi


class CellFollower:
    """One path and the waypoint that the drone is sent to."""

    def __init__(self, path: Path, yaw: float) -> None:
        self._points = path.waypoints
        self._index = 0
        self._yaw = paper_heading(yaw)

    def step(self, position: Vec2, moving: bool, dt: float) -> Track:
        """Go on to the next waypoint when q4 holds (nearer than eps3) and return the track; time and ``moving`` do not count."""
        if self._index < len(self._points) - 1 and distance(position, self.here) < EPS3:
            leg = self._points[self._index + 1][0] - self._points[self._index][0]
            self._yaw = self._yaw if abs(leg) < 1e-6 else (0.0 if leg > 0.0 else pi)
            self._index += 1
        return Track(self.here, yaw=self._yaw, waypoint=self._index, finished=self.finished)

    @property
    def here(self) -> Vec2:
        """The waypoint that the drone is sent to [m]."""
        return self._points[self._index]

    @property
    def finished(self) -> bool:
        """Whether this is the last one."""
        return self._index == len(self._points) - 1

    @property
    def goal(self) -> Vec2:
        """The end of the path [m]."""
        return self._points[-1]
