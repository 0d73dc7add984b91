"""How near people come to the drone, now and soon, and where it could get out of their way."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, inf, pi, sin

import numpy as np

from housefly.geometry import Vec2
from housefly.numeric import FloatArray
from housefly.pilot.planning.people import People
from housefly.room.grid import Cell, OccupancyGrid

STEP = 0.1
"""Predictions are looked at every so often [s] ..."""
MOTION_STEP = 0.2
"""... and ways to a refuge every so often [s]: there are many of them."""
FORESIGHT = 6.0
"""Where to go is decided by what happens within this time [s]."""
UNAVOIDABLE = 0.3
"""What happens within this time no motion can change any more [s]."""
YIELD_ACCELERATION = 1.0
"""How quickly the drone can be counted on to get going and to stop [m/s^2]."""
ROOM_MARGIN = 0.2
"""Making way keeps the hull this far from walls and things [m]."""
_BEARINGS = tuple(2.0 * pi * n / 12 for n in range(12))
_DISTANCES = (0.5, 1.0, 1.5, 2.2, 3.0)
_SAMPLE = 0.2
"""The way to a refuge is looked at every so often [m]."""
_PREFERENCE = 0.04
"""A refuge must be this much better for every metre that it is farther away [m/m]."""
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
    people: People, place: Vec2, velocity: Vec2, hull: float, horizon: float
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
    places = np.array(place) + times[:, None] * np.array(velocity)
    apart = np.array(
        [people.distances(places[n : n + 1], at)[0] for n, at in enumerate(times.tolist())]
    )
    who = int(np.argmin(apart.min(axis=0)))
    return Separation(float(apart[0].min()) - hull, float(apart.min()) - hull, people.names[who])


def refuge(
    people: People,
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
    open_ = np.array([_is_open(grid, place, offer, hull + ROOM_MARGIN) for offer in offers])
    open_[0] = True
    ends = np.array(offers)[open_]
    apart = _smallest(people, place, velocity, ends, speed) - hull
    far = np.hypot(ends[:, 0] - place[0], ends[:, 1] - place[1])
    score = np.minimum(apart, enough) - _PREFERENCE * far
    if kept is not None and open_[1]:
        score[1] += 0.1
    best = int(np.argmax(score))
    x, y = ends[best].tolist()
    return Refuge((x, y), float(apart[best]))


def _smallest(
    people: People, place: Vec2, velocity: Vec2, ends: FloatArray, speed: float
) -> FloatArray:
    """Return the smallest distance from the drone's middle to a body on the way to each end."""
    at = np.repeat(np.array([place]), len(ends), axis=0)
    v = np.repeat(np.array([velocity]), len(ends), axis=0)
    smallest: FloatArray = np.full(len(ends), inf)
    for n in range(1, round(FORESIGHT / MOTION_STEP) + 1):
        left = ends - at
        away = np.hypot(left[:, 0], left[:, 1])
        pace = np.minimum(speed, np.sqrt(2.0 * YIELD_ACCELERATION * away))
        change = left * (pace / np.maximum(away, 1e-6))[:, None] - v
        most = np.hypot(change[:, 0], change[:, 1])
        v = (
            v
            + change
            * np.minimum(1.0, YIELD_ACCELERATION * MOTION_STEP / np.maximum(most, 1e-9))[:, None]
        )
        at = at + MOTION_STEP * v
        if n * MOTION_STEP >= UNAVOIDABLE:
            smallest = np.minimum(smallest, people.distances(at, n * MOTION_STEP).min(axis=1))
    return smallest


def _is_open(grid: OccupancyGrid, start: Vec2, end: Vec2, keep: float) -> bool:
    """Return whether the hull may go straight there: no wall, no thing, no no-fly zone."""
    count = max(1, int(hypot(end[0] - start[0], end[1] - start[1]) / _SAMPLE))
    least = min(keep, grid.clearance_at(start))
    closed = _CLOSED - {grid.kind(grid.cell_of(start))}
    for n in range(1, count + 1):
        point = (
            start[0] + (end[0] - start[0]) * n / count,
            start[1] + (end[1] - start[1]) * n / count,
        )
        if grid.clearance_at(point) < least or grid.kind(grid.cell_of(point)) in closed:
            return False
    return True
