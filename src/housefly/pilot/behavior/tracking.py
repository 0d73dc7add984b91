"""The moving reference of mode default: a point that travels along the path as the drone should,
with its speed and acceleration.

It speeds up and slows down at a bounded rate, creeps around corners, stops at the end, and waits
for a drone that lags.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import inf, isnan, sin

import numpy as np

from housefly.geometry import Vec2, distance, heading_to, wrap_angle
from housefly.messages import Path
from housefly.pilot.behavior.ride import Ride, Target, Way, headed, ridden, target_of

CORNER_JUMP = 0.12
"""Largest sudden change of the reference velocity at a corner [m/s]."""


@dataclass(frozen=True, slots=True)
class Track:
    """What a follower wants now.

    Attributes:
        position, velocity, acceleration: of the reference in the plane [m, m/s, m/s^2].
        yaw: wanted heading [rad]; None keeps the present one.
        waypoint: index of the next waypoint.
        finished: the reference stands at the end of the path.
    """

    position: Vec2
    velocity: Vec2 = (0.0, 0.0)
    acceleration: Vec2 = (0.0, 0.0)
    yaw: float | None = None
    waypoint: int = 0
    finished: bool = True


def track_of(target: Target, last_waypoint: int) -> Track:
    """Return a compiled reference in the words of the pilot."""
    return Track(
        position=(target.x, target.y),
        velocity=(target.vx, target.vy),
        acceleration=(target.ax, target.ay),
        yaw=None if isnan(target.yaw) else target.yaw,
        waypoint=min(target.waypoint, last_waypoint),
        finished=target.finished,
    )


def way_along(waypoints: tuple[Vec2, ...]) -> Way:
    """Return a path as arrays, with the speeds that its corners allow."""
    points = waypoints[:1] + tuple(b for a, b in pairwise(waypoints) if distance(a, b) > 1e-6)
    lengths = np.array([distance(a, b) for a, b in pairwise(points)])
    corners = [_corner_speed(*three) for three in zip(points, points[1:], points[2:], strict=False)]
    places = np.array(points, dtype=float)
    along = np.diff(places, axis=0) / lengths[:, None]
    return Way(
        points=places,
        marks=np.concatenate(([0.0], np.cumsum(lengths))),
        speeds=np.array([0.0, *corners, 0.0][: len(points)]),
        along=along,
        headings=np.arctan2(along[:, 1], along[:, 0]),
    )


class PathFollower:
    """One path and how far the reference has come on it."""

    def __init__(self, path: Path, speed: float) -> None:
        self._way = way_along(path.waypoints)
        self._cruise = speed
        self._ride = Ride()
        self._last_waypoint = len(path.waypoints) - 1

    def step(self, position: Vec2, moving: bool, dt: float) -> Track:
        """Advance by dt [s] and return the track.

        Args:
            position: where the drone is [m].
            moving: whether the acceptor lets the reference move on; else it brakes and waits.
            dt: time since the last step [s].
        """
        moved = ridden(self._ride, self._way, self._cruise, *position, moving, dt)
        self._ride = headed(moved, self._way)
        return track_of(target_of(self._ride, self._way), self._last_waypoint)

    @property
    def finished(self) -> bool:
        """Whether the reference stands at the end."""
        return bool(self._ride.s >= self._way.marks[-1])

    @property
    def goal(self) -> Vec2:
        """The end of the path [m]."""
        x, y = self._way.points[-1]
        return float(x), float(y)


def _corner_speed(before: Vec2, corner: Vec2, after: Vec2) -> float:
    turn = abs(wrap_angle(heading_to(corner, after) - heading_to(before, corner)))
    return CORNER_JUMP / (2.0 * sin(turn / 2.0)) if turn > 1e-9 else inf
