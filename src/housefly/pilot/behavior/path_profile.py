"""A planned path as the arrays that the compiled reference travels on."""

from __future__ import annotations

from itertools import pairwise
from math import atan2, inf, sin
from typing import NamedTuple

import numpy as np

from housefly.geometry import Vec2, distance, heading_to, wrap_angle
from housefly.numeric import FloatArray, elementwise

CORNER_VELOCITY_JUMP = 0.12
"""Largest sudden change of the reference velocity at a corner [m/s]."""


class PathProfile(NamedTuple):
    """A path as arrays.

    Attributes:
        points: corners, no two neighbours alike [m], shape (n, 2).
        marks: arc length of each [m], shape (n,).
        speeds: highest speed at each [m/s], shape (n,).
        along: direction of each leg, shape (n - 1, 2).
        headings: the same as angles [rad], shape (n - 1,).
        waypoints: corners as planned, for mode paper [m], shape (m, 2).
        motion: of a trajectory in space, which then is what is flown: place [m], velocity [m/s],
            acceleration [m/s^2] and heading [rad] every ``timing.TICK``, shape (k, 10); ``marks``
            are the times of ``points`` [s]. Without rows there is none.
    """

    points: FloatArray
    marks: FloatArray
    speeds: FloatArray
    along: FloatArray
    headings: FloatArray
    waypoints: FloatArray
    motion: FloatArray


NO_MOTION: FloatArray = np.zeros((0, 10))
"""Of a path in the plane."""


def path_profile(waypoints: tuple[Vec2, ...]) -> PathProfile:
    """Return a path as arrays, with the speeds that its corners allow."""
    points = waypoints[:1] + tuple(b for a, b in pairwise(waypoints) if distance(a, b) > 1e-6)
    lengths = np.array([distance(a, b) for a, b in pairwise(points)])
    corners = [_corner_speed(*three) for three in zip(points, points[1:], points[2:], strict=False)]
    places = np.array(points, dtype=float)
    along = np.diff(places, axis=0) / lengths[:, None]
    return PathProfile(
        points=places,
        marks=np.concatenate(([0.0], np.cumsum(lengths))),
        speeds=np.array([0.0, *corners, 0.0][: len(points)]),
        along=along,
        headings=elementwise(atan2, along[:, 1], along[:, 0]),
        waypoints=np.array(waypoints, dtype=float),
        motion=NO_MOTION,
    )


def _corner_speed(before: Vec2, corner: Vec2, after: Vec2) -> float:
    turn = abs(wrap_angle(heading_to(corner, after) - heading_to(before, corner)))
    return CORNER_VELOCITY_JUMP / (2.0 * sin(turn / 2.0)) if turn > 1e-9 else inf


NO_PATH = path_profile(((0.0, 0.0),))
"""Stands where no path is followed."""
