"""Viewpoints that together see the floor of a room, and the order in which to fly them.

Each step takes the view that shows most of what none has shown yet (greedy cover, at most ln n + 1
times as many views as there must be: V. Chvatal, Mathematics of Operations Research 4, 1979), as
long as a view shows something worth a flight; what others show as well is left out again. The order
is the shortest round that exchanging ends finds.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import combinations, pairwise
from math import atan2, cos, hypot, sin

import numpy as np

from housefly.geometry import Vec2, Vec3, distance
from housefly.messages import Obstacle
from housefly.numeric import FloatArray, running_sum
from housefly.pilot.planning.dijkstra import CellDistances, distances
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.reach import Mask
from housefly.tasks.vantage.camera_views import CameraViews, camera_views, lattice, shown_from
from housefly.tasks.vantage.viewing_room import ReachableMap, ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint

FLOOR, WHOLE_FLOOR = "floor", "whole floor"
"""What the viewpoints of a round are called, with their numbers."""
_FLOOR_EDGE = 0.4
_FLOOR_HEIGHT = 0.2
"""The floor is looked at in points so far apart, at the height of somebody who lies there [m]."""
_LEAST = 0.03
"""A view that adds a smaller share of the floor is not flown, but on a round over all of it."""
_MOST, WHOLE_MOST = 8, 30
"""Most viewpoints of a round, and of one over all of the floor."""


def patrol_viewpoints(
    viewing: ViewingRoom,
    drone: Vec3 | None = None,
    obstacles: Iterable[Obstacle] = (),
    now: float = 0.0,
    most: int = _MOST,
    *,
    whole: bool = False,
) -> tuple[Viewpoint, ...]:
    """Return viewpoints that together see the floor, in flying order; () when there are none.

    Args:
        viewing: the room.
        drone: where the round begins [m]; None is home.
        obstacles: people and things that no map shows.
        now: time [s], for their ages.
        most: no more viewpoints than this.
        whole: every part of the floor that can be seen is, by up to WHOLE_MOST views.
    """
    start = viewing.room.home if drone is None else drone[:2]
    known = tuple(obstacles)
    there = viewing.reachable(start, known, viewing.site.people.comfort_distance, now)
    views = _floor_views(viewing, there, known)
    visible = max(1, int(views.shown.any(axis=0).sum()))
    chosen = (
        _cover(views.shown, WHOLE_MOST, 1) if whole else _cover(views.shown, most, _LEAST * visible)
    )
    order = _round(there, start, [_point(views.places[n]) for n, _ in chosen])
    name = WHOLE_FLOOR if whole else FLOOR
    return tuple(
        _viewpoint(views, *chosen[n], f"{name} {number}", visible)
        for number, n in enumerate(order, 1)
    )


def floor_share(views: Iterable[Viewpoint], viewing: ViewingRoom) -> float:
    """Return the share of the floor, of what can be seen at all, that viewpoints show."""
    poses = (
        (
            view.position,
            atan2(view.look_at[1] - view.position[1], view.look_at[0] - view.position[0]),
        )
        for view in views
    )
    return shown_share(poses, viewing)


def shown_share(poses: Iterable[tuple[Vec2, float]], viewing: ViewingRoom) -> float:
    """Return the share of the floor, of what can be seen at all, that pictures showed.

    Args:
        poses: of the drone at each picture: world xy [m], heading [rad].
        viewing: the room.
    """
    floor, visible = visible_floor(viewing)
    known = tuple(poses)
    if not known or not visible.any():
        return 0.0
    places = np.array([place for place, _ in known])
    headings = np.array([heading for _, heading in known])
    seen = shown_from(viewing, places, headings, floor).any(axis=0)
    return float((seen & visible).sum() / visible.sum())


@lru_cache(maxsize=4)
def visible_floor(viewing: ViewingRoom) -> tuple[FloatArray, Mask]:
    """Return the points of the floor [m], and which of them can be seen at all, nobody in it."""
    there = viewing.reachable(viewing.room.home, (), 0.0, 0.0)
    views = _floor_views(viewing, there, ())
    return views.points, np.asarray(views.shown.any(axis=0), dtype=np.bool_)


def _cover(shown: Mask, most: int, least: float) -> list[tuple[int, Mask]]:
    """Return views that show most together, and what each shows that the ones before do not.

    Args:
        shown: which views show which points, shape (views, points).
        most: no more views than this.
        least: a view that adds fewer points than this is left out.
    """
    rows: list[int] = []
    seen = np.zeros(shown.shape[1], dtype=np.bool_)
    while len(rows) < most and len(shown):
        gains = (shown & ~seen).sum(axis=1)
        best = int(np.argmax(gains))
        if gains[best] < least or gains[best] == 0:
            break
        rows.append(best)
        seen |= shown[best]
    times = shown[rows].sum(axis=0)
    for row in tuple(rows):
        if not np.any(shown[row] & (times == 1)):
            rows.remove(row)
            times = shown[rows].sum(axis=0)
    fresh, seen = [], np.zeros(shown.shape[1], dtype=np.bool_)
    for row in rows:
        fresh.append((row, shown[row] & ~seen))
        seen |= shown[row]
    return fresh


def _floor_views(
    viewing: ViewingRoom, there: ReachableMap, obstacles: tuple[Obstacle, ...]
) -> CameraViews:
    floor = lattice(there.grid, there.grid.cells != Cell.OUTSIDE, _FLOOR_EDGE)
    points = np.column_stack([floor, np.full(len(floor), _FLOOR_HEIGHT)])
    return camera_views(viewing, there, points, obstacles)


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
    return float(running_sum(ways[a, b] for a, b in pairwise([*order, order[0]])))


def _viewpoint(views: CameraViews, row: int, fresh: Mask, name: str, visible: int) -> Viewpoint:
    """Return a view that faces the middle of what it shows first, in its own heading."""
    x, y = _point(views.places[row])
    middle = views.points[fresh].mean(axis=0)
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
