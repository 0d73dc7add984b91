"""Clusters of neighbouring beams that end before the room does, with place and size."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import atan2, cos, hypot, pi, sin

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2
from housefly.numeric import FloatArray

_FOREGROUND_MARGIN = 0.15
"""A beam that ends this much before the room hits something new [m].

Five times the noise, and the roughness of the room itself.
"""
_MAX_GAP = 0.25
"""Points farther apart than this belong to two clusters [m]."""
_MAX_MISSING_BEAMS = 3
"""At most this many beams in a row may be lost within one cluster."""
_MIN_POINTS = 3
"""Clusters of fewer points are noise."""
_MIN_RADIUS = 0.05
"""Smallest radius of a cluster [m]."""
_MAX_DISC_RADIUS = 0.5
"""Larger clusters are rectangles [m, radius]."""
_DISC_DEPTH = pi / 4
"""Mean distance from the visible side of a disc to its centre, as a share of its radius."""


@dataclass(frozen=True, slots=True)
class Cluster:
    """One thing in one scan.

    Attributes:
        position: its centre, world xy [m].
        radius: of the disc; 0 for a rectangle.
        size: length and width of the rectangle [m]; (0, 0) for a disc.
        yaw: of the rectangle [rad].
        points: how many beams hit it.
    """

    position: Vec2
    radius: float
    size: Vec2
    yaw: float
    points: int


def foreground_limit(background: FloatArray) -> FloatArray:
    """Return how far a beam of the foreground reaches at most [m].

    At an edge the nearer side counts.
    """
    nearest = background.copy()
    nearest[1:] = np.minimum(nearest[1:], background[:-1])
    nearest[:-1] = np.minimum(nearest[:-1], background[1:])
    return nearest - _FOREGROUND_MARGIN


def clusters_of(points: FloatArray, beams: NDArray[np.int64], origin: Vec2) -> tuple[Cluster, ...]:
    """Return the clusters of foreground points.

    Args:
        points: world xy [m] in the order of the beams, shape (n, 2).
        beams: number of each point's beam, shape (n,).
        origin: where the scanner is [m].
    """
    if not len(points):
        return ()
    steps = points[1:] - points[:-1]
    jumps = np.hypot(steps[:, 0], steps[:, 1]) > _MAX_GAP
    jumps |= beams[1:] - beams[:-1] > _MAX_MISSING_BEAMS + 1
    edges = [0, *(np.flatnonzero(jumps) + 1).tolist(), len(points)]
    return tuple(
        cluster_of(points[start:end], origin)
        for start, end in pairwise(edges)
        if end - start >= _MIN_POINTS
    )


def cluster_of(points: FloatArray, origin: Vec2) -> Cluster:
    """Return the cluster of points [m], ordered from edge to edge as seen from an origin [m]."""
    (ax, ay), (bx, by) = points[0].tolist(), points[-1].tolist()
    width = hypot(bx - ax, by - ay)
    if width > 2.0 * _MAX_DISC_RADIUS:
        return _rectangle(points, atan2(by - ay, bx - ax))
    mx, my = (np.add.reduce(points, axis=0) / len(points)).tolist()
    radius = max(width / 2.0, _MIN_RADIUS)
    away = max(hypot(mx - origin[0], my - origin[1]), 1e-9)
    behind = _DISC_DEPTH * radius / away
    middle = (mx + (mx - origin[0]) * behind, my + (my - origin[1]) * behind)
    return Cluster(middle, radius, (0.0, 0.0), 0.0, len(points))


def _rectangle(points: FloatArray, yaw: float) -> Cluster:
    """Return the rectangle around all points, along the line from the first to the last."""
    along = points[:, 0] * cos(yaw) + points[:, 1] * sin(yaw)
    across = points[:, 1] * cos(yaw) - points[:, 0] * sin(yaw)
    u, v = (along.max() + along.min()) / 2, (across.max() + across.min()) / 2
    position = (float(u * cos(yaw) - v * sin(yaw)), float(u * sin(yaw) + v * cos(yaw)))
    return Cluster(position, 0.0, (float(np.ptp(along)), float(np.ptp(across))), yaw, len(points))
