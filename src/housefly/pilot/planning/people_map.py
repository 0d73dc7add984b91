"""Everybody who is known in one room: how near they come, where to make way, where to land."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator

import numpy as np

from housefly.config.site import Site
from housefly.geometry import Vec2, distance
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.messages.words import UNSAID, Words
from housefly.numeric import FloatArray
from housefly.pilot.planning.column import StaticColumns, column_fault, spots_around
from housefly.pilot.planning.people import NOBODY, ObservedPeople, people_at
from housefly.pilot.planning.separation import (
    Refuge,
    Separation,
    refuge,
    separation,
    separation_along,
)
from housefly.room.distance import half_diagonal
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.model import Room

HULL_MARGIN = 0.05
"""A column must be wider than the hull by this [m]."""
TAKE_OFF_LEAD = 2.0
"""Nobody may come near a drone within this time when it takes off [s] ..."""
LANDING_LEAD = 1.5
"""... or lands [s]."""
DRONE_PASSING_TIME = 6.0
"""Another drone may not come past a take-off within this time [s]: in half of it this one is up,
and until then gives up for who comes near within the other half. One that has just come up, or to
hover, may set off this way as it likes.
"""
ON_PAD = 0.3
"""So near to the pad it is landed on, whatever stands there [m]."""
UNMOVED_TIME = 30.0
"""Who has not moved for so long is landed beside, as a thing is [s] ..."""
UNMOVED_RADIUS = 0.1
"""... which is not to leave this distance from a place [m] ..."""
UNMOVED_DISTANCE = 0.25
"""... but no nearer to the hull than this [m]."""
UNSEEN_DISTANCE = 0.9
"""Something that only the drone's own sensor shows is left behind by at least this [m]."""
SPOT_APART = 0.35
"""Where no way leads to one place to land, those within this distance of it are left out [m]."""

ThingsMap = Callable[[float | None], OccupancyGrid]
"""Makes the map of things at a height of the drone [m], at the usual one for None."""


class PeopleMap:
    """Distances from people and free columns; without people it costs nothing.

    Attributes:
        config: distances to keep.
        hull: radius of the disc around the drone [m].
    """

    def __init__(self, site: Site, room: Room, grid: OccupancyGrid) -> None:
        self.config = site.people
        self.hull = half_diagonal(site.drone.hull_length, site.drone.hull_width)
        self._static = StaticColumns(room, site.map.flight_height + site.map.half_band)
        self._grid, self._pad = grid, None if site.mode == "paper" else room.home
        reaches = {drone.name: drone.reach for drone in site.all_drones}
        self._other_pads = tuple(
            (name, pad[:2], reaches[name] + self.hull) for name, pad in room.other_pads
        )
        self._drones: frozenset[str] = frozenset()
        self._restless: frozenset[str] = frozenset()
        self._cruise = site.limits.speed
        self._obstacles: tuple[Obstacle, ...] = ()
        self._things: ThingsMap = lambda height: grid
        self._people: ObservedPeople = NOBODY
        self._later: tuple[float, ObservedPeople] | None = None
        self._stood: dict[str, tuple[Vec2, float]] = {}
        self._at = 0.0

    def __len__(self) -> int:
        return len(self._people)

    def update(
        self,
        obstacles: Iterable[Obstacle],
        things: ThingsMap,
        now: float,
        restless: frozenset[str] = frozenset(),
    ) -> None:
        """Take in what is known at a time [s].

        Args:
            obstacles: everybody and everything.
            things: makes the map without people.
            now: time [s].
            restless: names of other drones that may set off at any moment.
        """
        self._obstacles, self._things, self._at = tuple(obstacles), things, now
        self._restless = restless
        self._people, self._later = people_at(self._obstacles, now, self._grid), None
        self._drones = frozenset(
            one.id for one in self._obstacles if one.kind is ObstacleKind.DRONE
        )
        self._stood = {
            name: self._stood_since(name, (x, y), now)
            for name, (x, y) in zip(
                self._people.names, self._people.rows[:, :2].tolist(), strict=True
            )
        }

    def _stood_since(self, name: str, place: Vec2, now: float) -> tuple[Vec2, float]:
        """Return around which place somebody stands [m], and since when [s]."""
        before = self._stood.get(name)
        has_moved = before is None or distance(before[0], place) > UNMOVED_RADIUS
        return (place, now) if before is None or has_moved else before

    def is_still(self, name: str, now: float) -> bool:
        """Return whether somebody has stood still for so long that they may be a thing.

        A drone that hovers never is one.
        """
        stood = self._stood.get(name)
        return stood is not None and name not in self._drones and now - stood[1] >= UNMOVED_TIME

    def separation(
        self, place: Vec2, velocity: Vec2, now: float, horizon: float, *, walking: bool = False
    ) -> Separation:
        """Return how near people come to a drone that goes on with its velocity [m, m/s, s].

        With ``walking`` only those count who walk.
        """
        if not len(self._people):
            return Separation()
        people = self._now(now)
        people = people.walking() if walking else people
        return separation(people, place, velocity, self.hull, horizon)

    def separation_along(self, places: FloatArray, now: float) -> Separation:
        """Return how near who walks comes to a drone on its way.

        Args:
            places: where it is now and every ``separation.STEP`` from then on [m], shape (n, 2).
            now: time [s].
        """
        return separation_along(self.walking(now), places, self.hull)

    def walking(self, now: float) -> ObservedPeople:
        """Return everybody who walks, where they are at a time [s]."""
        return self._now(now).walking() if len(self._people) else NOBODY

    def refuge(
        self,
        place: Vec2,
        velocity: Vec2,
        now: float,
        speed: float,
        kept: Vec2 | None,
        height: float | None = None,
    ) -> Refuge:
        """Return where to make way to from a place [m], with a velocity and up to a speed [m/s].

        The drone keeps its height [m]; None stands for the usual one.
        """
        enough = self.config.comfort_distance + 0.2
        people = self._now(now)
        return refuge(people, self._things(height), place, velocity, self.hull, speed, enough, kept)

    def landing_fault(self, place: Vec2, now: float, lead: float = LANDING_LEAD) -> Words:
        """Return who or what stands below or beside a landing at a place [m], or UNSAID."""
        if not self._obstacles:
            return UNSAID
        least = self.config.min_distance
        people = self._now(now)
        still = np.array([self.is_still(name, now) for name in people.names], dtype=bool)
        distances = np.where(still, min(UNMOVED_DISTANCE, least), least)
        return column_fault(self._obstacles, people, place, self.hull, distances, lead)

    def ground_fault(self, place: Vec2) -> Words:
        """Return why a place of the room [m] is no floor to land on, in words, or UNSAID.

        The pad may lie on a thing; mode paper lands where it is, as the paper's drone.
        """
        if self._pad is None or distance(place, self._pad) < ON_PAD:
            return UNSAID
        for name, pad, apart in self._other_pads:
            if distance(place, pad) < apart + HULL_MARGIN:
                return Words("the pad of {who} is there", who=name)
        is_clear = self._static.clearance(place) > self.hull + HULL_MARGIN
        return UNSAID if is_clear else Words("furniture or a wall stands below or beside it")

    def is_above_furniture(self, place: Vec2, within: float) -> bool:
        """Return whether the map has something low so near to a place [m]; the pad is floor."""
        is_pad = self._pad is not None and distance(place, self._pad) < ON_PAD
        return not is_pad and self._static.clearance(place) < within

    def landing_spot(
        self,
        place: Vec2,
        now: float,
        found: Collection[Vec2] = (),
        unreachable: Collection[Vec2] = (),
    ) -> Vec2 | None:
        """Return the nearest place within 2 m where a landing hurts nobody and nothing [m].

        It is far enough from where the sonar found something, and not beside those to which no
        way was found.
        """
        return next(
            (
                spot
                for spot in self._landing_spots(place, now, found)
                if all(distance(spot, other) >= SPOT_APART for other in unreachable)
            ),
            None,
        )

    def _landing_spots(
        self, place: Vec2, now: float, found: Collection[Vec2] = ()
    ) -> Iterator[Vec2]:
        """Yield where a landing hurts nobody and nothing, nearest first [m]."""
        grid, wide = self._things(None), self.hull + HULL_MARGIN
        for spot in spots_around(place):
            is_open = grid.is_free(grid.cell_of(spot)) and self._static.clearance(spot) > wide
            is_open = is_open and not self._is_other_pad(spot)
            is_new = all(distance(spot, other) >= UNSEEN_DISTANCE for other in found)
            if is_open and is_new and not self.landing_fault(spot, now):
                yield spot

    def _is_other_pad(self, place: Vec2) -> bool:
        return any(distance(place, pad) < apart + HULL_MARGIN for _, pad, apart in self._other_pads)

    def clear_floor(
        self,
        place: Vec2,
        height: float,
        now: float,
        farthest: float,
        speed: float,
        found: Collection[Vec2] = (),
    ) -> Vec2 | None:
        """Return the nearest clear floor straight beside a place over furniture or people [m].

        It is far enough from where the sonar found something. None where the place itself is clear,
        unless something was found, and where the drone would meet something, or somebody, on the
        straight way at its height [m] and a speed [m/s].
        """
        is_clear = not (self.ground_fault(place) or self.landing_fault(place, now))
        if is_clear and not found:
            return None
        grid = self._things(height)
        for spot in self._landing_spots(place, now, found):
            far = distance(place, spot)
            if far > farthest:
                return None
            share = speed / far
            velocity = share * (spot[0] - place[0]), share * (spot[1] - place[1])
            met = self.separation(place, velocity, now, 1.0 / share)
            keeps_away = met.closest >= min(met.now, self.config.min_distance)
            if keeps_away and _is_open_way(grid, place, spot):
                return spot
        return None

    def open_air(self, place: Vec2, height: float) -> float:
        """Return how far things are from a place at a height of the drone [m]; 0 outside."""
        grid = self._things(height)
        cell = grid.cell_of(place)
        return grid.clearance_at(place) if grid.kind(cell) is not Cell.VIRTUAL else 0.0

    def take_off_fault(self, place: Vec2, now: float) -> Words:
        """Return why not to take off from a place [m], in words, or UNSAID."""
        if self._grid.kind(self._grid.cell_of(place)) is Cell.VIRTUAL:
            return Words("the drone stands in a no-fly area: carry it out")
        if self._static.overhang(place) < self.hull + HULL_MARGIN:
            return Words("something hangs over the drone: carry it to where the air above is free")
        return self.landing_fault(place, now, TAKE_OFF_LEAD) or self._passing_fault(place, now)

    def _passing_fault(self, place: Vec2, now: float) -> Words:
        """Return which of the other drones comes near a place [m] soon, in words, or UNSAID."""
        if not self._drones:
            return UNSAID
        people = self._now(now)
        walking = people.walking()
        coming = _among(walking, self._drones)
        least = self.config.min_distance
        found = separation(coming, place, (0.0, 0.0), self.hull, DRONE_PASSING_TIME)
        if found.closest < least:
            return Words("{who} comes near", who=found.name)
        waiting = _among(people, self._restless - frozenset(walking.names))
        found = separation(waiting, place, (0.0, 0.0), self.hull, 0.0)
        is_reached = found.now - self._cruise * DRONE_PASSING_TIME < least
        return Words("{thing} is near", thing=found.name) if is_reached else UNSAID

    def _now(self, now: float) -> ObservedPeople:
        if now - self._at < 1e-9:
            return self._people
        if self._later is None or self._later[0] != now:
            self._later = now, people_at(self._obstacles, now, self._grid)
        return self._later[1]


def _among(people: ObservedPeople, names: Collection[str]) -> ObservedPeople:
    """Return those that have one of the names."""
    chosen = np.array([name in names for name in people.names], dtype=bool)
    return ObservedPeople(people.rows[chosen], tuple(n for n in people.names if n in names))


def _is_open_way(grid: OccupancyGrid, start: Vec2, end: Vec2) -> bool:
    """Return whether a straight way [m] is free, or comes nowhere nearer to things than its start.

    Just above a sofa nothing is free, and the way off it is wanted.
    """
    least = grid.clearance_at(start) - grid.resolution
    count = max(2, round(2.0 * distance(start, end) / grid.resolution))
    for share in np.linspace(0.0, 1.0, count).tolist():
        point = start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])
        kind = grid.kind(grid.cell_of(point))
        is_passable = kind is Cell.INFLATED and grid.clearance_at(point) >= least
        if not (kind is Cell.FREE or is_passable):
            return False
    return True
