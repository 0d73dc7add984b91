"""How near people come to the drone, now and soon, and where it could get out of their way."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, inf, pi, sin

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2
from housefly.numeric import FloatArray
from housefly.pilot.planning.people import ObservedPeople
from housefly.room.grid import Cell, OccupancyGrid

STEP = 0.1
"""Predictions are looked at every so often [s] ..."""
MOTION_STEP = 0.2
"""... and ways to a refuge every so often [s]: there are many of them."""
FORESIGHT = 6.0
"""Where to go is decided by what happens within this time [s]."""
UNAVOIDABLE = 0.3
"""What happens within this time no motion can change any more [s]."""
YIELD_ACCELERATION = 1.6
"""How quickly the drone can be counted on to get going [m/s^2] ..."""
YIELD_DECELERATION = 1.0
"""... and to stop at its refuge [m/s^2]."""
APPROACH_GAIN = 1.2
"""Nearer to the refuge it is slower by this for every metre [1/s]."""
YIELD_DELAY = 0.1
"""From deciding to the first motion [s]."""
ROOM_MARGIN = 0.2
"""Making way keeps the hull this far from walls and things [m]."""
_BEARINGS = tuple(2.0 * pi * n / 32 for n in range(32))
_DISTANCES = (0.3, 0.6, 1.0, 1.5, 2.2, 3.0, 4.0)
_SAMPLES = 25
"""The way to a refuge is looked at this often."""
_PREFERENCE = 0.04
"""A refuge must be this much better for every metre that it is farther away [m/m]."""
_LATER = 0.4
"""Where no place is good, being met a second later is as good as being met this much farther off
[m/s]: the drone may find another place until then, and whoever comes may turn.
"""
_GOOD = 0.25
"""A place is good if it keeps this distance [m]: in a dead end whoever is met later is met as well.
"""
_LASTING = 0.2
"""Share of the distance at the end in the worth of a place: who stands beside the drone is left,
although nothing makes the beginning any better.
"""
_CLOSED = frozenset({Cell.VIRTUAL, Cell.OUTSIDE, Cell.OCCUPIED})


@dataclass(frozen=True, slots=True)
class Separation:
    """How near somebody comes to the hull.

    Attributes:
        now: distance from hull to body [m]; infinite when nobody is known.
        closest: the smallest within the horizon, if the drone goes on as asked [m].
        name: of who comes nearest.
    """

    now: float = inf
    closest: float = inf
    name: str = ""


@dataclass(frozen=True, slots=True)
class Refuge:
    """Where to make way to.

    Attributes:
        place: [m].
        separation: the smallest distance from hull to body on the way there and after it [m].
    """

    place: Vec2
    separation: float


def separation(
    people: ObservedPeople, place: Vec2, velocity: Vec2, hull: float, horizon: float
) -> Separation:
    """Return how near people come to a drone that goes on with its velocity.

    Args:
        people: everybody.
        place: of the drone [m].
        velocity: of the drone [m/s].
        hull: half the diagonal of its hull [m].
        horizon: how far to look ahead [s].
    """
    if not len(people):
        return Separation()
    times = np.arange(0.0, horizon + STEP / 2, STEP)
    return separation_along(people, np.array(place) + times[:, None] * np.array(velocity), hull)


def separation_along(people: ObservedPeople, places: FloatArray, hull: float) -> Separation:
    """Return how near people come to a drone whose way is known.

    Args:
        people: everybody.
        places: of the drone, now and every ``STEP`` [m], shape (n, 2).
        hull: half the diagonal of its hull [m].
    """
    if not len(people):
        return Separation()
    times = np.arange(len(places), dtype=np.float64) * STEP
    apart = people.distances_along(places, times)
    who = int(np.argmin(apart.min(axis=0)))
    return Separation(float(apart[0].min()) - hull, float(apart.min()) - hull, people.names[who])


def refuge(
    people: ObservedPeople,
    grid: OccupancyGrid,
    place: Vec2,
    velocity: Vec2,
    hull: float,
    speed: float,
    enough: float,
    kept: Vec2 | None = None,
) -> Refuge:
    """Return the free place from which the drone stays farthest from everybody.

    To stay is one of the answers. Among places that keep ``enough`` distance the nearest wins.

    Args:
        people: everybody, at least one.
        grid: walls and things, without people.
        place: of the drone [m].
        velocity: of the drone [m/s].
        hull: half the diagonal of its hull [m].
        speed: the fastest to go there [m/s].
        enough: more distance than this counts for nothing [m].
        kept: a refuge chosen before, which stays unless another is clearly better [m].
    """
    offers = [place, *([kept] if kept is not None else [])]
    offers.extend(
        (place[0] + far * cos(bearing), place[1] + far * sin(bearing))
        for far in _DISTANCES
        for bearing in _BEARINGS
    )
    open_ = _are_open(grid, place, np.array(offers), hull + ROOM_MARGIN)
    open_[0] = True
    ends = np.array(offers)[open_]
    apart, worth, last = (found - hull for found in _smallest(people, place, velocity, ends, speed))
    far = np.hypot(ends[:, 0] - place[0], ends[:, 1] - place[1])
    rank = np.minimum(apart if apart.max() >= _GOOD else worth, enough)
    score = rank + _LASTING * np.minimum(last, enough) - _PREFERENCE * far
    if kept is not None and open_[1]:
        score[1] += 0.1
    score[rank < rank[0] - 1e-9] = -inf
    best = int(np.argmax(score))
    x, y = ends[best].tolist()
    return Refuge((x, y), float(apart[best]))


def _smallest(
    people: ObservedPeople, place: Vec2, velocity: Vec2, ends: FloatArray, speed: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the smallest distance from the drone's middle to a body on the way to each end [m].

    And the same with ``_LATER`` added for every second ahead, and the distance at the end.
    """
    at = np.repeat(np.array([place]), len(ends), axis=0)
    v = np.repeat(np.array([velocity]), len(ends), axis=0)
    smallest: FloatArray = np.full(len(ends), inf)
    worth = apart = smallest
    for n in range(1, round(FORESIGHT / MOTION_STEP) + 1):
        left = ends - at
        away = np.hypot(left[:, 0], left[:, 1])
        pace = approach_speed(away, speed)
        change = left * (pace / np.maximum(away, 1e-6))[:, None] - v
        most = np.hypot(change[:, 0], change[:, 1])
        reach = YIELD_ACCELERATION * (MOTION_STEP - (YIELD_DELAY if n == 1 else 0.0))
        v = v + change * np.minimum(1.0, reach / np.maximum(most, 1e-9))[:, None]
        at = at + MOTION_STEP * v
        if n * MOTION_STEP >= UNAVOIDABLE:
            apart = people.distances(at, n * MOTION_STEP).min(axis=1)
            smallest = np.minimum(smallest, apart)
            worth = np.minimum(worth, apart + _LATER * n * MOTION_STEP)
    return smallest, worth, apart


def approach_speed(away: FloatArray, speed: float) -> FloatArray:
    """Return how fast to fly at a refuge that is so far away, up to a speed [m, m/s].

    Proportional near it, by the root of the way left farther off.
    """
    near = YIELD_DECELERATION / APPROACH_GAIN**2
    root = np.sqrt(2.0 * YIELD_DECELERATION * np.maximum(away - near / 2, 0.0))
    result: FloatArray = np.minimum(speed, np.where(away < near, APPROACH_GAIN * away, root))
    return result


def _are_open(grid: OccupancyGrid, start: Vec2, ends: FloatArray, keep: float) -> NDArray[np.bool_]:
    """Return whether the hull may go straight there: no wall, no thing, no no-fly zone."""
    here = grid.cell_of(start)
    closed = [kind.value for kind in _CLOSED - {grid.kind(here)}]
    shares = np.arange(1, _SAMPLES + 1)[None, :, None] / _SAMPLES
    points = np.array(start) + shares * (ends[:, None, :] - np.array(start))
    cells = np.floor((points - np.array(grid.origin)) / grid.resolution).astype(int)
    inside = ((cells >= 0) & (cells < np.array(grid.cells.shape))).all(axis=2)
    i, j = (np.where(inside, cells[:, :, axis], here[axis]) for axis in (0, 1))
    wide = grid.clearance[i, j] >= min(keep, grid.clearance_at(start))
    result: NDArray[np.bool_] = (inside & wide & ~np.isin(grid.cells[i, j], closed)).all(axis=1)
    return result
