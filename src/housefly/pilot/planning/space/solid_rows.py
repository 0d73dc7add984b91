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
from housefly.pilot.planning.obstacles import obstacle_row
from housefly.pilot.planning.people import may_be_person
from housefly.room.model import BUILDING_PARTS, Room, Shape, Solid

BOTTOM, TOP = 9, 10
"""Columns of a row behind those of ``planning.live`` [m]."""
COLUMNS = 11
_SLAB = 1.0
"""Floor, ceiling and what lies beyond the bounds count as so thick [m]."""


def solid_rows(solids: Iterable[Solid]) -> FloatArray:
    """Return a row for each solid that can be touched, shape (n, 11)."""
    rows = [_row_of_solid(solid) for solid in solids if solid.collides]
    return np.array(rows, dtype=np.float64).reshape(-1, COLUMNS)


def filled_rows(room: Room, hanging: float) -> FloatArray:
    """Return the rows of a room with its furniture full from the floor up, shape (n, 11).

    A hull fits under a desk and between shelf boards, where no one wants it. Parts of the building
    stay as they are: a door is open below its lintel.

    Args:
        room: solids, floor and ceiling.
        hanging: what has no solid that begins lower hangs, and may be flown under [m].
    """
    lowest: dict[str, float] = {}
    for solid in room.solids:
        bottom = solid.position[2] - solid.size[2] / 2
        lowest[solid.thing] = min(bottom, lowest.get(solid.thing, inf))
    standing = {thing for thing, bottom in lowest.items() if bottom < hanging} - BUILDING_PARTS
    solids = [solid for solid in room.solids if solid.collides]
    rows = room_rows(room)
    is_full = np.array([solid.thing in standing for solid in solids], dtype=np.bool_)
    rows[: len(solids)][is_full, BOTTOM] = -inf
    return rows


def room_rows(room: Room) -> FloatArray:
    """Return the rows of a room: its solids, its floor, ceiling and bounds, shape (n, 11).

    The map ends at the bounds, whether or not walls stand there: beyond, nothing is known.
    """
    x_min, y_min, x_max, y_max = room.bounds
    x, y, half = (x_min + x_max) / 2, (y_min + y_max) / 2, _SLAB / 2
    length, width = (x_max - x_min) / 2, (y_max - y_min) / 2
    slabs = [
        *((x, y, length, width, bottom, bottom + _SLAB) for bottom in (-_SLAB, room.height)),
        *((at, y, half, width + _SLAB, -inf, inf) for at in (x_min - half, x_max + half)),
        *((x, at, length, half, -inf, inf) for at in (y_min - half, y_max + half)),
    ]
    rows = [(*slab[:4], 1.0, 0.0, 0.0, 0.0, 0.0, *slab[4:]) for slab in slabs]
    return np.concatenate((solid_rows(room.solids), np.array(rows)))


def live_rows(
    obstacles: Iterable[Obstacle],
    now: float,
    horizon: float,
    comfort: float = 0.0,
    hanging: float = -inf,
) -> FloatArray:
    """Return the space that obstacles may cover until a time ahead, shape (n, 11).

    Nobody is flown over, nor under: who may be a person counts at every height.

    Args:
        obstacles: what is known.
        now: time [s].
        horizon: how far ahead [s].
        comfort: people count as so much larger [m].
        hanging: what begins lower is full from the floor up [m].
    """
    rows = [
        (*obstacle_row(one, now, horizon, comfort), *_heights(one, hanging)) for one in obstacles
    ]
    return np.array(rows, dtype=np.float64).reshape(-1, COLUMNS)


def _heights(obstacle: Obstacle, hanging: float) -> tuple[float, float]:
    """Return bottom and top of what an obstacle fills [m], given from where on things hang [m]."""
    if may_be_person(obstacle):
        return -inf, inf
    return -inf if obstacle.bottom < hanging else obstacle.bottom, obstacle.top


def _row_of_solid(solid: Solid) -> tuple[float, ...]:
    (x, y, z), (length, width, height) = solid.position, solid.size
    is_round = solid.shape is Shape.CYLINDER
    extent = (0.0, 0.0) if is_round else (length / 2, width / 2)
    radius = length / 2 if is_round else 0.0
    turn = (cos(solid.yaw), sin(solid.yaw))
    return x, y, *extent, *turn, radius, 0.0, 0.0, z - height / 2, z + height / 2
