"""Remembers where the drone's own sonar found something below while a landing was tried.

A thin thing shows at one height only: the beam is a cone. Where it was found no landing is tried
again, until the floor shows from the same place and height for a while.
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
FORGOTTEN_AFTER = 1.0
"""... once the floor has shown there for so long [s]."""


@dataclass(frozen=True, slots=True)
class FoundThing:
    """Something that the sonar found.

    Attributes:
        place: of the drone, which found it [m].
        lowest, highest: heights of the drone from which it showed [m].
        floor_since: since when the floor shows instead [s]; infinite while it does not.
    """

    place: Vec2
    lowest: float
    highest: float
    floor_since: float = inf

    def shown(self, height: float) -> FoundThing:
        """Return the thing, shown from another height [m] as well."""
        lowest, highest = min(self.lowest, height), max(self.highest, height)
        return FoundThing(self.place, lowest, highest)

    def looked_at(self, position: Vec3, now: float) -> FoundThing:
        """Return the thing after the floor has shown from a position [m] at a time [s]."""
        x, y, z = position
        is_level = self.lowest - _SAME_HEIGHT < z < self.highest + _SAME_HEIGHT
        if not (is_level and distance(self.place, (x, y)) < _SAME_PLACE):
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

    def show(self, position: Vec3) -> None:
        """Take in that something shows below the drone at a position [m]."""
        x, y, z = position
        near = [thing for thing in self._things if distance(thing.place, (x, y)) < _MERGED]
        others = (thing for thing in self._things if thing not in near)
        shown = [thing.shown(z) for thing in near] or [FoundThing((x, y), z, z)]
        self._things = (*others, *shown)

    def look(self, position: Vec3, now: float) -> None:
        """Take in that the floor shows below the drone at a position [m] and a time [s]."""
        looked = (thing.looked_at(position, now) for thing in self._things)
        self._things = tuple(
            thing for thing in looked if not now - thing.floor_since >= FORGOTTEN_AFTER
        )

    def forget(self) -> None:
        """Begin anew: the drone stands."""
        self._things = ()
