"""The moving reference of mode default: a point that travels along the path as the drone should, with its speed and acceleration.

It speeds up and slows down at a bounded rate, creeps around corners, stops at the end, and waits for a drone that lags.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import hypot, inf, sin, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2, distance, heading_to, wrap_angle
from housefly.messages import Path
from housefly.numeric import compiled

ACCELERATION = 0.4
"""How quickly the reference speeds up and slows down [m/s^2]: a fifth of what the tilt limit can give."""
CORNER_JUMP = 0.12
"""Largest sudden change of the reference velocity at a corner [m/s]."""
LOOK_AHEAD = 0.5
"""The nose points to where the path will be after this distance [m], so that turns begin before corners."""
KEEP_HEADING = 0.25
"""Nearer than this to the end the heading stays [m]: a direction over a short distance means nothing."""
PATIENCE = 0.3
"""The reference waits while the drone is further behind than this [m]."""

Numbers = NDArray[np.float64]


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


@compiled
def speed_allowed(s: float, marks: Numbers, speeds: Numbers, acceleration: float) -> float:
    """Return the highest speed [m/s] at arc length s [m] from which every mark ahead can still be passed at its own speed."""
    allowed = inf
    for mark, speed in zip(marks, speeds):  # noqa: B905  (numba knows no strict)
        if mark > s:
            allowed = min(allowed, sqrt(speed * speed + 2.0 * acceleration * (mark - s)))
    return allowed


@compiled
def travelled(
    s: float, v: float, wanted: float, marks: Numbers, speeds: Numbers, acceleration: float, dt: float
) -> tuple[float, float]:
    """Return arc length [m] and speed [m/s] after dt [s], wanting a speed and respecting the marks ahead."""
    end = marks[-1]
    target = min(wanted, speed_allowed(s, marks, speeds, acceleration))
    faster, slower = v + acceleration * dt, v - 1.5 * acceleration * dt
    v_new = max(0.0, min(faster, max(slower, target)))
    s_new = s + 0.5 * (v + v_new) * dt
    if s_new >= end - 1e-4:
        return end, 0.0
    return s_new, v_new


class PathFollower:
    """One path and how far the reference has come on it."""

    def __init__(self, path: Path, speed: float) -> None:
        points = _distinct(path.waypoints)
        self._points = points
        legs = [distance(a, b) for a, b in pairwise(points)]
        self._marks = np.concatenate(([0.0], np.cumsum(legs)))
        self._speeds = np.array([0.0, *(_corner_speed(*three, speed) for three in _triples(points)), 0.0][: len(points)])
        self._cruise = speed
        self._s, self._v, self._a = 0.0, 0.0, 0.0
        self._last_leg = len(path.waypoints) - 1
        self._yaw: float | None = None

    def step(self, position: Vec2, moving: bool, dt: float) -> Track:
        """Advance by dt [s] and return the track.

        Args:
            position: where the drone is [m].
            moving: whether the acceptor lets the reference move on; else it brakes and waits.
            dt: time since the last step [s].
        """
        lagging = distance(position, self._place(self._s)) > PATIENCE
        wanted = self._cruise if moving and not lagging else 0.0
        if dt > 0.0 and not self.finished:
            before = self._v
            result: Any = travelled(self._s, self._v, wanted, self._marks, self._speeds, ACCELERATION, dt)
            self._s, self._v = result
            self._a = (self._v - before) / dt
        return self._track()

    @property
    def finished(self) -> bool:
        """Whether the reference stands at the end."""
        return bool(self._s >= self._marks[-1])

    @property
    def goal(self) -> Vec2:
        """The end of the path [m]."""
        return self._points[-1]

    def _track(self) -> Track:
        here = self._place(self._s)
        leg = self._leg(self._s)
        along = _direction(self._points[leg], self._points[leg + 1]) if len(self._points) > 1 else (0.0, 0.0)
        a = 0.0 if self.finished else self._a
        self._yaw = self._heading(here)
        return Track(
            position=here,
            velocity=(along[0] * self._v, along[1] * self._v),
            acceleration=(along[0] * a, along[1] * a),
            yaw=self._yaw,
            waypoint=min(leg + 1, self._last_leg),
            finished=self.finished,
        )

    def _heading(self, here: Vec2) -> float | None:
        ahead = self._place(self._s + LOOK_AHEAD)
        return heading_to(here, ahead) if distance(here, ahead) > KEEP_HEADING else self._yaw

    def _leg(self, s: float) -> int:
        leg = int(np.searchsorted(self._marks, s, side="right")) - 1
        return max(0, min(leg, len(self._points) - 2))

    def _place(self, s: float) -> Vec2:
        if len(self._points) == 1:
            return self._points[0]
        leg = self._leg(s)
        (ax, ay), (bx, by) = self._points[leg], self._points[leg + 1]
        share = min(max((s - self._marks[leg]) / (self._marks[leg + 1] - self._marks[leg]), 0.0), 1.0)
        return float(ax + share * (bx - ax)), float(ay + share * (by - ay))


def _distinct(points: tuple[Vec2, ...]) -> tuple[Vec2, ...]:
    return points[:1] + tuple(b for a, b in pairwise(points) if distance(a, b) > 1e-6)


def _triples(points: tuple[Vec2, ...]) -> list[tuple[Vec2, Vec2, Vec2]]:
    return list(zip(points, points[1:], points[2:], strict=False))


def _direction(a: Vec2, b: Vec2) -> Vec2:
    length = hypot(b[0] - a[0], b[1] - a[1])
    return (b[0] - a[0]) / length, (b[1] - a[1]) / length


def _corner_speed(before: Vec2, corner: Vec2, after: Vec2, speed: float) -> float:
    turn = abs(wrap_angle(heading_to(corner, after) - heading_to(before, corner)))
    return min(speed, CORNER_JUMP / max(2.0 * sin(turn / 2.0), 1e-9))
