"""Remembers where the drone's own sonar found something below while a landing was tried.

A thin thing shows at one height only, and one beside the drone from one place: the beam is a cone.
Where it was found no landing is tried again. Only what showed for a while below a drone at rest is
believed to be gone, when the floor shows from the same place and height for as long again.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import inf

from housefly.geometry import Vec2, Vec3, distance

NEAR = 0.8
"""What was found may stand below a drone nearer than this to where it found it [m]: the radius of
the beam, half the hull, and what a place may be off by.
"""
_MERGED = 0.3
"""Places nearer to each other than this are one [m]."""
_SAME_PLACE, _SAME_HEIGHT = 0.15, 0.1
"""From so near to where it was found its absence is believed [m] ..."""
FORGOTTEN_AFTER = 2.0
"""... once the floor has shown there for so long [s] ..."""
_AT_REST, STEADY_AFTER = 0.06, 1.0
"""... where it had shown for so long [s] to a drone that moved no farther [m]."""


@dataclass(frozen=True, slots=True)
class FoundThing:
    """Something that the sonar found.

    Attributes:
        place: of the drone, which found it [m].
        lowest, highest: heights of the drone from which it showed [m].
        rest: where the drone has been at rest while it shows [m], and since when [s].
        is_steady: it has shown for a while to a drone at rest.
        floor_since: since when the floor shows instead [s]; infinite while it does not.
    """

    place: Vec2
    lowest: float
    highest: float
    rest: tuple[Vec2, float]
    is_steady: bool = False
    floor_since: float = inf

    def shown(self, position: Vec3, now: float) -> FoundThing:
        """Return the thing, shown from another position [m] as well."""
        x, y, z = position
        rest = self.rest if distance(self.rest[0], (x, y)) < _AT_REST else ((x, y), now)
        return FoundThing(
            place=self.place,
            lowest=min(self.lowest, z),
            highest=max(self.highest, z),
            rest=rest,
            is_steady=self.is_steady or now - rest[1] >= STEADY_AFTER,
        )

    def looked_at(self, position: Vec3, now: float) -> FoundThing:
        """Return the thing after the floor has shown from a position [m] at a time [s]."""
        x, y, z = position
        is_level = self.lowest - _SAME_HEIGHT < z < self.highest + _SAME_HEIGHT
        is_there = self.is_steady and distance(self.place, (x, y)) < _SAME_PLACE
        if not (is_level and is_there):
            return replace(self, floor_since=inf)
        return replace(self, floor_since=min(self.floor_since, now))


class FoundBelow:
    """The places of one flight where something was found below."""

    def __init__(self) -> None:
        self._things: tuple[FoundThing, ...] = ()

    def __iter__(self) -> Iterator[Vec2]:
        return (thing.place for thing in self._things)

    def is_near(self, place: Vec2) -> bool:
        """Return whether something that was found may stand below a place [m]."""
        return any(distance(place, found) < NEAR for found in self)

    def show(self, position: Vec3, now: float) -> None:
        """Take in that something shows below the drone at a position [m] and a time [s]."""
        x, y, z = position
        near = [thing for thing in self._things if distance(thing.place, (x, y)) < _MERGED]
        others = (thing for thing in self._things if thing not in near)
        shown = [thing.shown(position, now) for thing in near]
        self._things = (*others, *(shown or [FoundThing((x, y), z, z, ((x, y), now))]))

    def look(self, position: Vec3, now: float) -> None:
        """Take in that the floor shows below the drone at a position [m] and a time [s]."""
        looked = (thing.looked_at(position, now) for thing in self._things)
        self._things = tuple(
            thing for thing in looked if not now - thing.floor_since >= FORGOTTEN_AFTER
        )

    def forget(self) -> None:
        """Begin anew: the drone stands."""
        self._things = ()
