"""Whether the air below the drone, or above its pad, is free from floor to flight height."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import cos, pi, sin

import numpy as np

from housefly.geometry import Vec2
from housefly.messages.obstacles import Obstacle, called, thing_called
from housefly.messages.words import UNSAID, Words
from housefly.numeric import FloatArray
from housefly.pilot.planning.live import gap
from housefly.pilot.planning.obstacles import obstacle_rows
from housefly.pilot.planning.people import ObservedPeople, may_be_person
from housefly.room.distance import clearance_field, footprints
from housefly.room.model import Room

THING_MARGIN = 0.1
"""A column is blocked by a thing nearer to the hull than this [m]."""
OVERHANG_BOTTOM = 0.15
"""What begins higher than this above the floor may hang over a drone that stands [m]."""
_STEP = 0.25
"""People's ways are looked at every so often [s]."""
_FAR = 5.0
"""Farther than this is not measured [m]."""
_SPOT_DISTANCES = (0.5, 0.8, 1.1, 1.5, 2.0)
_SPOT_BEARINGS = tuple(2.0 * pi * n / 12 for n in range(12))


def column_fault(
    obstacles: Iterable[Obstacle],
    people: ObservedPeople,
    place: Vec2,
    hull: float,
    min_distances: FloatArray,
    lead: float,
) -> Words:
    """Return who or what is in the way of a column, in words, or UNSAID.

    Args:
        obstacles: everything known; heights do not matter.
        people: everybody among them, where they are now.
        place: middle of the column [m].
        hull: half the diagonal of the hull [m].
        min_distances: that each of the people keeps from the hull [m].
        lead: people who come this near within this time count [s].
    """
    if len(people):
        for at in np.arange(0.0, lead + _STEP / 2, _STEP).tolist():
            spare = people.distances(np.array([place]), at)[0] - hull - min_distances
            who = int(np.argmin(spare))
            if spare[who] < 0.0:
                return Words("{who} is too close", who=called(people.names[who]))
    things = [replace(o, bottom=0.0, top=9.0) for o in obstacles if not may_be_person(o)]
    rows, names = obstacle_rows(things, 0.0, 0.0, (0.0, 9.0))
    near = [(gap(row, *place), name) for row, name in zip(rows, names, strict=True)]
    distance, name = min(near, default=(9.0, ""))
    is_close = distance < hull + THING_MARGIN
    return Words("{who} is too close", who=thing_called(name)) if is_close else UNSAID


def spots_around(place: Vec2) -> tuple[Vec2, ...]:
    """Return other places to land, nearest first, at most 2 m away [m]."""
    return tuple(
        (place[0] + far * cos(bearing), place[1] + far * sin(bearing))
        for far in _SPOT_DISTANCES
        for bearing in _SPOT_BEARINGS
    )


class StaticColumns:
    """What the room model has above and below a place, at any height up to the drone's.

    Args:
        room: walls and furniture.
        top: height of the highest part of a column [m].
    """

    def __init__(self, room: Room, top: float) -> None:
        self._standing = footprints(room.solids, 0.02, top)
        over = [s for s in room.solids if s.position[2] - s.size[2] / 2 > OVERHANG_BOTTOM]
        self._over = footprints(over, OVERHANG_BOTTOM, top)

    def clearance(self, place: Vec2) -> float:
        """Return the distance from a place to the nearest solid of any height, up to 5 m."""
        return _distance_to(self._standing, place)

    def clearances(self, x: FloatArray, y: FloatArray) -> FloatArray:
        """Return the same for every pair of coordinates [m], shape (len(x), len(y))."""
        return clearance_field(self._standing, x, y, _FAR)

    def overhang(self, place: Vec2) -> float:
        """Return the distance from a place to the nearest solid above the floor, up to 5 m."""
        return _distance_to(self._over, place)


def _distance_to(rows: FloatArray, place: Vec2) -> float:
    x, y = (np.array([number]) for number in place)
    return float(clearance_field(rows, x, y, _FAR)[0, 0])
