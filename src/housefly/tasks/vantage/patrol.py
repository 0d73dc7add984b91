"""Viewpoints that together see the floor of a room, and the order in which to fly them.

Each step takes the view that shows most of what none has shown yet (greedy cover), as long as a
view shows something worth a flight. The order is the shortest round that exchanging ends finds.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import combinations, pairwise
from math import atan2, cos, hypot, pi, sin

import numpy as np

from housefly.geometry import Vec2, Vec3, distance
from housefly.messages import Obstacle
from housefly.numeric import FloatArray
from housefly.pilot.planning.dijkstra import UNREACHED, CellDistances, distances
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.reach import Mask
from housefly.room.sight import in_sight
from housefly.tasks.vantage.camera import FRONT_CAMERA
from housefly.tasks.vantage.viewing_room import ReachableMap, ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint

_FLOOR_EDGE = 0.4
_FLOOR_HEIGHT = 0.2
"""The floor is looked at in points so far apart, at the height of somebody who lies there [m]."""
_PLACE_EDGE = 0.6
"""Views are tried from places so far apart [m] ..."""
_HEADINGS = 12
"""... in so many directions."""
_VIEW_RANGE = 7.0
"""The floor is not judged from farther away [m]."""
_LEAST = 0.03
"""A view that adds less than this share of the floor is not flown."""


@dataclass(frozen=True, slots=True, eq=False)
class FloorViews:
    """Everything that could be seen: one row a place and heading.

    Attributes:
        places: world xy [m], shape (n, 2).
        headings: [rad], shape (n,).
        shown: which points of the floor, shape (n, points).
        floor: the points, world [m], shape (points, 3).
    """

    places: FloatArray
    headings: FloatArray
    shown: Mask
    floor: FloatArray


def patrol_viewpoints(
    viewing: ViewingRoom,
    drone: Vec3 | None = None,
    obstacles: Iterable[Obstacle] = (),
    now: float = 0.0,
    most: int = 8,
) -> tuple[Viewpoint, ...]:
    """Return viewpoints that together see the floor, in flying order; () when there are none.

    Args:
        viewing: the room.
        drone: where the round begins [m]; None is home.
        obstacles: people and things that no map shows.
        now: time [s], for their ages.
        most: no more viewpoints than this.
    """
    start = viewing.room.home if drone is None else drone[:2]
    known = tuple(obstacles)
    there = viewing.reachable(start, known, viewing.site.people.comfort_distance, now)
    views = _floor_views(viewing, there, known)
    seen = np.zeros(len(views.floor), dtype=np.bool_)
    visible = max(1, int(views.shown.any(axis=0).sum()))
    chosen: list[tuple[int, Mask]] = []
    while len(chosen) < most and len(views.places):
        gains = (views.shown & ~seen).sum(axis=1)
        best = int(np.argmax(gains))
        if gains[best] < _LEAST * visible:
            break
        chosen.append((best, views.shown[best] & ~seen))
        seen |= views.shown[best]
    order = _round(there, start, [_point(views.places[n]) for n, _ in chosen])
    return tuple(
        _viewpoint(views, *chosen[n], f"floor {number}", visible)
        for number, n in enumerate(order, 1)
    )


def floor_share(views: Iterable[Viewpoint], viewing: ViewingRoom) -> float:
    """Return the share of the floor, of what can be seen at all, that viewpoints show."""
    there = viewing.reachable(viewing.room.home, (), 0.0, 0.0)
    all_views = _floor_views(viewing, there, ())
    visible = all_views.shown.any(axis=0)
    seen = np.zeros(len(all_views.floor), dtype=np.bool_)
    for view in views:
        heading = atan2(view.look_at[1] - view.position[1], view.look_at[0] - view.position[0])
        places, headings = np.array([view.position]), np.array([heading])
        seen |= _shown(viewing, places, headings, all_views.floor, ())[0]
    return float((seen & visible).sum() / max(1, visible.sum()))


def _floor_views(
    viewing: ViewingRoom, there: ReachableMap, obstacles: tuple[Obstacle, ...]
) -> FloorViews:
    grid = there.grid
    floor = _lattice(grid, grid.cells != Cell.OUTSIDE, _FLOOR_EDGE)
    places = _lattice(grid, there.moves != UNREACHED, _PLACE_EDGE)
    turns = np.arange(_HEADINGS) * 2.0 * pi / _HEADINGS
    points = np.column_stack([floor, np.full(len(floor), _FLOOR_HEIGHT)])
    places, headings = np.repeat(places, _HEADINGS, axis=0), np.tile(turns, len(places))
    return FloorViews(
        places, headings, _shown(viewing, places, headings, points, obstacles), points
    )


def _shown(
    viewing: ViewingRoom,
    places: FloatArray,
    headings: FloatArray,
    floor: FloatArray,
    obstacles: tuple[Obstacle, ...],
) -> Mask:
    """Return which views show which points; consecutive views from one place share their rays."""
    shown = np.zeros((len(places), len(floor)), dtype=np.bool_)
    hiding = viewing.hiding(frozenset(), obstacles, (np.inf, np.inf), 0.0)
    clear: dict[Vec2, Mask] = {}
    for row, (place, heading) in enumerate(zip(places.tolist(), headings.tolist(), strict=True)):
        here = np.array([[*place, viewing.height]])
        ahead = here[0] + (cos(heading), sin(heading), 0.0)
        eye = FRONT_CAMERA.eyes(here, ahead)
        framed = FRONT_CAMERA.frames(eye, ahead, floor)[0]
        at = place[0], place[1]
        if at not in clear:
            near = np.hypot(*(floor[:, :2] - np.array(at)).T) <= _VIEW_RANGE
            clear[at] = near & in_sight(hiding, here, floor)[0]
        shown[row] = framed & clear[at]
    return shown


def _lattice(grid: OccupancyGrid, cells: Mask, edge: float) -> FloatArray:
    """Return the middles of some cells, about ``edge`` [m] apart, shape (n, 2)."""
    step = max(1, round(edge / grid.resolution))
    ix, iy = np.nonzero(cells)
    kept = (ix % step == step // 2) & (iy % step == step // 2)
    index = np.column_stack([ix[kept], iy[kept]])
    middles: FloatArray = np.array(grid.origin) + (index + 0.5) * grid.resolution
    return middles


def _round(there: ReachableMap, start: Vec2, places: list[Vec2]) -> list[int]:
    """Return the order of a short round from a start over all places and back."""
    stops = [start, *places]
    free = there.grid.cells == Cell.FREE
    ways = np.array(
        [
            [_far(there.grid, moves, b) for b in stops]
            for moves in (distances(free, there.grid.cell_of(a)) for a in stops)
        ]
    )
    order = [0]
    while len(order) < len(stops):
        left = [n for n in range(len(stops)) if n not in order]
        order.append(min(left, key=lambda n: ways[order[-1], n]))
    improved = True
    while improved:
        improved = False
        for i, j in combinations(range(1, len(order)), 2):
            turned = order[:i] + order[i : j + 1][::-1] + order[j + 1 :]
            if _length(ways, turned) < _length(ways, order) - 1e-9:
                order, improved = turned, True
    return [n - 1 for n in order[1:]]


def _far(grid: OccupancyGrid, moves: CellDistances, place: Vec2) -> float:
    return float(moves[grid.cell_of(place)]) * grid.resolution


def _length(ways: FloatArray, order: list[int]) -> float:
    return float(sum(ways[a, b] for a, b in pairwise([*order, order[0]])))


def _viewpoint(views: FloorViews, row: int, fresh: Mask, name: str, visible: int) -> Viewpoint:
    """Return a view that faces the middle of what it shows first, in its own heading."""
    x, y = _point(views.places[row])
    middle = views.floor[fresh].mean(axis=0)
    away = max(1.0, hypot(middle[0] - x, middle[1] - y))
    heading = float(views.headings[row])
    look_at = (
        round(x + away * cos(heading), 3),
        round(y + away * sin(heading), 3),
        _FLOOR_HEIGHT,
    )
    share = 100.0 * float(fresh.sum()) / visible
    words = f"sees {share:.0f} % more of the floor"
    eye = (x, y)
    return Viewpoint(name, eye, look_at, distance(eye, look_at[:2]), words)


def _point(row: FloatArray) -> Vec2:
    x, y = (round(value, 3) for value in row.tolist())
    return x, y
