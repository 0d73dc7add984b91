"""Unexpected obstacles: who stands where when the way is planned, and when it is flown."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from housefly.geometry import Vec2, distance
from housefly.lab.reproduction.routes import MappedSite, service_path
from housefly.numeric import FloatArray
from housefly.pilot.planning.planner import plan
from housefly.room.distance import half_diagonal
from housefly.room.grid import Cell, build_grid
from housefly.room.model import Room, Shape, Solid

_EDGE = 0.4
"""Edge of an obstacle, square seen from above [m]: a standing person, a stool."""
PERSON, STOOL = 1.7, 0.45
"""Heights [m]."""
_SPACING = 0.5
"""Distance between the points of the way where an obstacle is put in turn [m]."""
_EVERY_CELL = 3
"""All over the room obstacles stand in the middle of every third free cell along each axis."""
_END_MARGIN = 1.0
"""No obstacle stands closer to either end of the way than this [m]: there no way can avoid it."""
_WALK = 0.6
"""How far somebody walks after the way was planned [m]: one step."""
_DIRECTIONS = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))
_SAMPLING = 0.02
"""Distance between the points of a way at which the gap is measured [m]."""


@dataclass(frozen=True, slots=True)
class UnexpectedObstacles:
    """How many obstacles the hull touches, turned its worst way, somewhere along the way.

    Attributes:
        on_way: people put on the way planned before, one after another.
        hit_static: how many of them that way touches.
        hit_updated: how many the way planned on the updated map touches; without a way, the planner
            says so.
        walked: the same people, each gone one step in each of four directions since the update.
        hit_walked: how many of them the way planned on the updated map touches.
        hit_low: how many stools at the same spots the way planned before touches.
        all_over: people put in the free cells all over the room.
        hit_all_over: how many of them the way planned before touches.
    """

    on_way: int
    hit_static: int
    hit_updated: int
    walked: int
    hit_walked: int
    hit_low: int
    all_over: int
    hit_all_over: int


def put_unexpected(
    here: MappedSite, height: float = PERSON, seen: bool = True
) -> UnexpectedObstacles:
    """Put obstacles into the room, one at a time.

    Args:
        here: room and site, whose way to the entrance is meant.
        height: of the obstacles that are not stools [m].
        seen: whether the map is updated with them; otherwise it stays as it was.
    """
    before = service_path(here).waypoints
    spots = [
        spot
        for spot in _along(before, _SPACING)
        if min(distance(spot, before[0]), distance(spot, before[-1])) >= _END_MARGIN
    ]
    all_over = _all_over(here)
    hit_updated = hit_walked = walked = 0
    for spot in spots:
        room = _with_obstacle(here.room, spot, height) if seen else here.room
        grid = build_grid(room, here.site)
        way = plan(grid, before[0], before[-1], here.site.limits.speed, shortcut=True).path
        steps = [(spot[0] + _WALK * dx, spot[1] + _WALK * dy) for dx, dy in _DIRECTIONS]
        walked += len(steps)
        if way is not None:
            hit_updated += touches(here, way.waypoints, spot, height)
            hit_walked += sum(touches(here, way.waypoints, step, height) for step in steps)
    return UnexpectedObstacles(
        on_way=len(spots),
        hit_static=sum(touches(here, before, spot, height) for spot in spots),
        hit_updated=hit_updated,
        walked=walked,
        hit_walked=hit_walked,
        hit_low=sum(touches(here, before, spot, STOOL) for spot in spots),
        all_over=len(all_over),
        hit_all_over=sum(touches(here, before, spot, height) for spot in all_over),
    )


def touches(here: MappedSite, way: tuple[Vec2, ...], spot: Vec2, height: float) -> bool:
    """Return whether an obstacle of this height [m] at a spot [m] is in the way of the hull."""
    if height < here.site.map.flight_height - here.site.map.half_band:
        return False
    hull = half_diagonal(here.site.drone.hull_length, here.site.drone.hull_width)
    outside = np.maximum(np.abs(np.array(_along(way, _SAMPLING)) - spot) - 0.5 * _EDGE, 0.0)
    return bool(np.hypot(*outside.T).min() < hull)


def _all_over(here: MappedSite) -> list[Vec2]:
    free = np.argwhere(here.grid.cells == Cell.FREE)
    return [
        here.grid.centre_of((int(ix), int(iy)))
        for ix, iy in free
        if ix % _EVERY_CELL == iy % _EVERY_CELL == 0
    ]


def _with_obstacle(room: Room, spot: Vec2, height: float) -> Room:
    solid = Solid(
        "unexpected", "unexpected", Shape.BOX, (*spot, 0.5 * height), (_EDGE, _EDGE, height)
    )
    return replace(room, solids=(*room.solids, solid))


def _along(waypoints: tuple[Vec2, ...], spacing: float) -> list[Vec2]:
    """Return points on a polyline, ``spacing`` apart, and its end [m]."""
    marks: FloatArray = np.concatenate(
        ([0.0], np.cumsum([distance(a, b) for a, b in pairwise(waypoints)]))
    )
    wanted = np.append(np.arange(0.0, marks[-1], spacing), marks[-1])
    xs, ys = (np.interp(wanted, marks, column) for column in np.array(waypoints).T)
    return [(float(x), float(y)) for x, y in zip(xs, ys, strict=True)]
