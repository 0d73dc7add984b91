"""How well one leg was flown: pure functions of its true course and of its reference.

A course has the columns of ``flown_track.COLUMNS``. Metres, seconds.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, nan

import numpy as np

from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.oriented_hull import OrientedHull, oriented_clearances

TIME, SPEEDS = 0, slice(4, 7)
PLACE, WANTED = slice(1, 4), slice(7, 10)
ARRIVAL_RADIUS = 0.15
"""A drone is there when it stays nearer to its goal than this [m] ..."""
ARRIVAL_SPEED = 0.15
"""... and slower than this [m/s]."""
_APPROACH = 0.3
"""The last part of the way tells in which direction the goal is reached [m]."""
_CLEARANCE_CAP = 1.0
"""Farther from everything is as good [m]."""


@dataclass(frozen=True, slots=True)
class LegMeasures:
    """How well a leg was flown.

    Attributes:
        told_after: until the pilot said it has arrived [s]; infinite if it did not.
        there_after: until it truly was there, for good [s]; infinite if it was not.
        off_goal: at the end, true and horizontal [m].
        overshoot: how far past the goal, in the direction of the way's end [m].
        reference_rms, reference_max: distance from the moving reference [m].
        path_rms, path_max: distance from the line that the reference draws [m].
        height_max: largest difference from the wanted height [m].
        height_end: that of the last moment [m].
        clearance: smallest, from the drone's middle to a solid beside it [m]: the gap of the
            upright cylinder around the hull, plus its radius.
        gap: smallest, from the hull as it was turned to a solid [m].
        top_speed: [m/s].
        length: of the true course [m].
    """

    told_after: float
    there_after: float
    off_goal: float
    overshoot: float
    reference_rms: float
    reference_max: float
    path_rms: float
    path_max: float
    height_max: float
    height_end: float
    clearance: float
    gap: float
    top_speed: float
    length: float


def there_after(course: FloatArray, goal: tuple[float, float]) -> float:
    """Return when the drone was at its goal for good, counted from the first row [s]."""
    off = np.hypot(course[:, 1] - goal[0], course[:, 2] - goal[1])
    speed = np.linalg.norm(course[:, SPEEDS], axis=1)
    away = np.flatnonzero((off > ARRIVAL_RADIUS) | (speed > ARRIVAL_SPEED))
    if not len(away):
        return 0.0
    if away[-1] == len(course) - 1:
        return inf
    return float(course[away[-1] + 1, TIME] - course[0, TIME])


def overshoot(course: FloatArray, goal: tuple[float, float]) -> float:
    """Return how far the drone came past its goal, in the direction of the way's end [m]."""
    wanted = course[:, WANTED][:, :2]
    far = np.flatnonzero(np.hypot(*(wanted - goal).T) > _APPROACH)
    if not len(far) or far[-1] == len(course) - 1:
        return nan
    along = np.array(goal) - wanted[far[-1]]
    along /= np.hypot(*along)
    past = (course[far[-1] + 1 :, 1:3] - goal) @ along
    return float(max(0.0, past.max()))


def off_reference(course: FloatArray) -> FloatArray:
    """Return the distance of each row from the reference of the same moment [m], shape (n,)."""
    has = ~np.isnan(course[:, 7])
    off = course[has][:, PLACE] - course[has][:, WANTED]
    return np.asarray(np.linalg.norm(off, axis=1))


def off_polyline(points: FloatArray, line: FloatArray) -> FloatArray:
    """Return the distance of points from a line of corners [m], shape (n,).

    Args:
        points: shape (n, k).
        line: shape (m, k), m >= 1.
    """
    if len(line) == 1:
        return np.asarray(np.linalg.norm(points - line[0], axis=1))
    starts, legs = line[:-1], np.diff(line, axis=0)
    squared = np.maximum((legs * legs).sum(axis=1), 1e-12)
    best = np.full(len(points), inf)
    for start, leg, square in zip(starts, legs, squared, strict=True):
        offset = points - start
        along = np.clip(offset @ leg / square, 0.0, 1.0)
        best = np.minimum(best, np.linalg.norm(offset - along[:, None] * leg, axis=1))
    return best


def thinned(points: FloatArray, step: float = 0.02) -> FloatArray:
    """Return the points of a line that lie at least a step apart [m], and the last one."""
    kept = [0]
    for n in range(1, len(points)):
        if np.linalg.norm(points[n] - points[kept[-1]]) >= step:
            kept.append(n)
    return np.vstack((points[kept], points[-1:]))


def leg_measures(
    course: FloatArray,
    told_at: float,
    goal: tuple[float, float],
    solids: FloatArray,
    hull: OrientedHull,
    line: FloatArray | None = None,
) -> LegMeasures:
    """Return how well a leg was flown.

    Args:
        course: from the order to some time after the arrival, so that overshooting shows.
        told_at: when the pilot said that it has arrived [s]; infinite if it did not.
        goal: [m].
        solids: rows of the room's solids.
        hull: of the drone.
        line: that the drone should keep to, shape (n, 3) [m]; None for what the reference draws.
    """
    began = course[0, TIME]
    moving = course[course[:, TIME] <= told_at]
    off = off_reference(moving)
    wanted = moving[:, WANTED][~np.isnan(moving[:, 7])]
    if line is None and len(wanted):
        line = thinned(wanted)
    across = np.array([nan]) if line is None else off_polyline(moving[:, PLACE], line)
    tall = np.abs(course[:, 3] - course[:, 9])
    disc, gap = _clearances(course, solids, hull)
    return LegMeasures(
        told_after=float(told_at - began),
        there_after=there_after(course, goal),
        off_goal=float(np.hypot(course[-1, 1] - goal[0], course[-1, 2] - goal[1])),
        overshoot=overshoot(course, goal),
        reference_rms=rms(off),
        reference_max=float(off.max(initial=0.0)),
        path_rms=rms(across),
        path_max=float(across.max(initial=0.0)),
        height_max=float(np.nanmax(tall, initial=0.0)),
        height_end=float(tall[-1]),
        clearance=disc,
        gap=gap,
        top_speed=float(np.linalg.norm(course[:, SPEEDS], axis=1).max()),
        length=float(np.linalg.norm(np.diff(moving[:, PLACE], axis=0), axis=1).sum()),
    )


def _clearances(course: FloatArray, solids: FloatArray, hull: OrientedHull) -> tuple[float, float]:
    """Return the smallest distance from the drone's middle, and from its hull [m]."""
    radius = float(np.hypot(hull.half_length, hull.half_width))
    cylinder = HullCylinder(radius, hull.half_height)
    places = np.ascontiguousarray(course[:, PLACE])
    poses = np.ascontiguousarray(course[:, [1, 2, 3, 10]])
    disc = hull_clearances(solids, places, cylinder, _CLEARANCE_CAP)
    turned = oriented_clearances(solids, poses, hull, _CLEARANCE_CAP)
    return float(disc.min()) + radius, float(turned.min())


def rms(values: FloatArray) -> float:
    """Return the root of the mean square."""
    return float(np.sqrt(np.mean(values * values))) if len(values) else nan
