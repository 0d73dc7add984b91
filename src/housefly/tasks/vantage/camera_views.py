"""Everything that the drone's camera can show of some points, from places all over the room."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from housefly.geometry import Vec2
from housefly.messages import Obstacle
from housefly.numeric import FloatArray
from housefly.pilot.planning.dijkstra import UNREACHED
from housefly.room.grid import OccupancyGrid
from housefly.room.reach import Mask
from housefly.room.sight import in_sight
from housefly.tasks.vantage.viewing_room import ReachableMap, ViewingRoom

PLACE_EDGE = 0.6
"""Views are tried from places so far apart [m] ..."""
HEADINGS = 12
"""... in so many directions."""
VIEW_RANGE = 7.0
"""Nothing is judged from farther away [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class CameraViews:
    """What could be seen: one row a place and heading.

    Attributes:
        places: world xy [m], shape (n, 2).
        headings: [rad], shape (n,).
        shown: which points are in sight and in the picture, shape (n, points).
        points: world [m], shape (points, 3).
    """

    places: FloatArray
    headings: FloatArray
    shown: Mask
    points: FloatArray


def camera_views(
    viewing: ViewingRoom,
    there: ReachableMap,
    points: FloatArray,
    obstacles: Iterable[Obstacle] = (),
) -> CameraViews:
    """Return what the camera shows of points from all places that can be reached.

    Args:
        viewing: the room.
        there: where the drone can hover now.
        points: world [m], shape (points, 3).
        obstacles: people and things that no map shows; they hide what is behind them.
    """
    places = lattice(there.grid, there.moves != UNREACHED, PLACE_EDGE)
    turns = np.arange(HEADINGS) * 2.0 * pi / HEADINGS
    places, headings = np.repeat(places, HEADINGS, axis=0), np.tile(turns, len(places))
    shown = shown_from(viewing, places, headings, points, obstacles)
    return CameraViews(places, headings, shown, points)


def shown_from(
    viewing: ViewingRoom,
    places: FloatArray,
    headings: FloatArray,
    points: FloatArray,
    obstacles: Iterable[Obstacle] = (),
) -> Mask:
    """Return which views show which points; views from one place share their lines of sight.

    Args:
        viewing: the room.
        places: of the drone, world xy [m], shape (n, 2).
        headings: [rad], shape (n,).
        points: world [m], shape (points, 3).
        obstacles: they hide what is behind them.

    Returns:
        shape (n, points).
    """
    shown = np.zeros((len(places), len(points)), dtype=np.bool_)
    hiding = viewing.hiding(frozenset(), obstacles, (np.inf, np.inf), 0.0)
    clear: dict[Vec2, Mask] = {}
    for row, (place, heading) in enumerate(zip(places.tolist(), headings.tolist(), strict=True)):
        here = np.array([[*place, viewing.height]])
        ahead = here[0] + (cos(heading), sin(heading), 0.0)
        eye = viewing.camera.eyes(here, ahead)
        framed = viewing.camera.frames(eye, ahead, points)[0]
        at = place[0], place[1]
        if at not in clear:
            near = np.hypot(*(points[:, :2] - np.array(at)).T) <= VIEW_RANGE
            clear[at] = near & in_sight(hiding, here, points)[0]
        shown[row] = framed & clear[at]
    return shown


def lattice(grid: OccupancyGrid, cells: Mask, edge: float) -> FloatArray:
    """Return the middles of some cells, about ``edge`` [m] apart, shape (n, 2)."""
    step = max(1, round(edge / grid.resolution))
    ix, iy = np.nonzero(cells)
    kept = (ix % step == step // 2) & (iy % step == step // 2)
    index = np.column_stack([ix[kept], iy[kept]])
    middles: FloatArray = np.array(grid.origin) + (index + 0.5) * grid.resolution
    return middles
