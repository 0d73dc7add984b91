"""The hull as it is: a rectangle with a heading. Through a door it fits where its disc does not."""

from __future__ import annotations

from math import cos, sin, sqrt
from typing import Any, NamedTuple

import numpy as np

from housefly.numeric import FloatArray, compiled
from housefly.pilot.planning.live import gap
from housefly.pilot.planning.space.clearance import height_gap_of


class OrientedHull(NamedTuple):
    """An upright box with a heading.

    Attributes:
        half_length: [m].
        half_width: [m].
        half_height: [m].
    """

    half_length: float
    half_width: float
    half_height: float


@compiled
def _overlap_on(
    ax: float, ay: float, dx: float, dy: float, row: Any, hull: Any, c: float, s: float
) -> bool:
    """Return whether hull and row overlap seen along an axis (ax, ay)."""
    mine = hull.half_length * abs(ax * c + ay * s) + hull.half_width * abs(ay * c - ax * s)
    its = row[2] * abs(ax * row[4] + ay * row[5]) + row[3] * abs(ay * row[4] - ax * row[5])
    return bool(abs(dx * ax + dy * ay) <= mine + its)


@compiled
def _to_hull(x: float, y: float, hull: OrientedHull, c: float, s: float) -> float:
    """Return the distance [m] from a point, seen from the hull's middle, to the hull."""
    u = max(abs(x * c + y * s) - hull.half_length, 0.0)
    v = max(abs(y * c - x * s) - hull.half_width, 0.0)
    return sqrt(u * u + v * v)


@compiled
def plan_gap(row: Any, x: float, y: float, yaw: float, hull: OrientedHull) -> float:
    """Return the gap in the plane [m] between the hull at a place [m] and heading [rad] and a row.

    A row that moves counts where it begins and all along its way, as the hull's disc would find it.
    """
    c, s = cos(yaw), sin(yaw)
    if row[7] != 0.0 or row[8] != 0.0:
        radius = sqrt(hull.half_length**2 + hull.half_width**2)
        return max(gap(row, x, y) - radius, 0.0)
    dx, dy = row[0] - x, row[1] - y
    if (
        _overlap_on(c, s, dx, dy, row, hull, c, s)
        and _overlap_on(-s, c, dx, dy, row, hull, c, s)
        and _overlap_on(row[4], row[5], dx, dy, row, hull, c, s)
        and _overlap_on(-row[5], row[4], dx, dy, row, hull, c, s)
    ):
        return 0.0
    best = np.inf
    # Two convex bodies apart are nearest at a corner of one of them.
    for a in (-1.0, 1.0):
        for b in (-1.0, 1.0):
            u, v = a * hull.half_length, b * hull.half_width
            best = min(best, gap(row, x + u * c - v * s, y + u * s + v * c))
            u, v = a * row[2], b * row[3]
            its_x, its_y = dx + u * row[4] - v * row[5], dy + u * row[5] + v * row[4]
            best = min(best, max(_to_hull(its_x, its_y, hull, c, s) - row[6], 0.0))
    return best


@compiled
def _fill_oriented(rows: Any, poses: Any, hull: OrientedHull, cap: float, out: Any) -> None:
    radius = sqrt(hull.half_length**2 + hull.half_width**2)
    for n in range(poses.shape[0]):
        x, y, z, yaw = poses[n, 0], poses[n, 1], poses[n, 2], poses[n, 3]
        best = cap
        for k in range(rows.shape[0]):
            above = height_gap_of(rows[k], z, hull.half_height)
            if above >= best or gap(rows[k], x, y) - radius >= best:
                continue
            aside = plan_gap(rows[k], x, y, yaw, hull)
            best = min(best, sqrt(aside * aside + above * above))
        out[n] = best


def oriented_clearances(
    rows: FloatArray, poses: FloatArray, hull: OrientedHull, cap: float
) -> FloatArray:
    """Return the distance [m] from the hull to the nearest row at each pose, at most ``cap``.

    Args:
        rows: shape (n, 11).
        poses: middle [m] and heading [rad] of the hull, shape (m, 4).
        hull: of the drone.
        cap: farther is as good [m].

    Returns:
        Shape (m,).
    """
    out = np.empty(len(poses))
    _fill_oriented(rows, poses, hull, cap, out)
    return out
