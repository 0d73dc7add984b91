"""What stands in the room as rows of numbers: upright prisms with a bottom and a top.

A row begins as those of ``planning.live``: x, y, half length, half width, cos yaw, sin yaw, radius
by which the rectangle is rounded outwards, and the way that it moves in x and y; bottom and top
follow. A cylinder is a rectangle without extent. Lengths in metres.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, inf, sin

import numpy as np

from housefly.messages.obstacles import Obstacle
from housefly.numeric import FloatArray
from housefly.pilot.planning.obstacles import obstacle_rows
from housefly.pilot.planning.people import may_be_person
from housefly.room.model import Room, Shape, Solid

BOTTOM, TOP = 9, 10
"""Columns of a row behind those of ``planning.live`` [m]."""
COLUMNS = 11
_SLAB = 1.0
"""Floor and ceiling count as so thick [m]."""


def solid_rows(solids: Iterable[Solid]) -> FloatArray:
    """Return a row for each solid that can be touched, shape (n, 11)."""
    rows = [_row_of_solid(solid) for solid in solids if solid.collides]
    return np.array(rows, dtype=np.float64).reshape(-1, COLUMNS)


def room_rows(room: Room) -> FloatArray:
    """Return the rows of a room: its solids, its floor and its ceiling, shape (n, 11)."""
    x_min, y_min, x_max, y_max = room.bounds
    plan = ((x_min + x_max) / 2, (y_min + y_max) / 2, (x_max - x_min) / 2, (y_max - y_min) / 2)
    slabs = [
        (*plan, 1.0, 0.0, 0.0, 0.0, 0.0, bottom, bottom + _SLAB) for bottom in (-_SLAB, room.height)
    ]
    return np.concatenate((solid_rows(room.solids), np.array(slabs)))


def live_rows(
    obstacles: Iterable[Obstacle], now: float, horizon: float, comfort: float = 0.0
) -> FloatArray:
    """Return the space that obstacles may cover until a time ahead, shape (n, 11).

    Nobody is flown over, nor under: who may be a person counts at every height.

    Args:
        obstacles: what is known.
        now: time [s].
        horizon: how far ahead [s].
        comfort: people count as so much larger [m].
    """
    known = tuple(obstacles)
    rows, _ = obstacle_rows(known, now, horizon, (-inf, inf), comfort)
    heights = [(-inf, inf) if may_be_person(one) else (one.bottom, one.top) for one in known]
    return np.hstack((rows, np.array(heights, dtype=np.float64).reshape(-1, 2)))


def _row_of_solid(solid: Solid) -> tuple[float, ...]:
    (x, y, z), (length, width, height) = solid.position, solid.size
    is_round = solid.shape is Shape.CYLINDER
    extent = (0.0, 0.0) if is_round else (length / 2, width / 2)
    radius = length / 2 if is_round else 0.0
    turn = (cos(solid.yaw), sin(solid.yaw))
    return x, y, *extent, *turn, radius, 0.0, 0.0, z - height / 2, z + height / 2
