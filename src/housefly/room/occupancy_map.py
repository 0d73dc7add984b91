"""Turns the values of nav_msgs/OccupancyGrid into occupied, free and unknown cells. Pure."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, hypot, isfinite, pi

import numpy as np
from numpy.typing import NDArray

from housefly.errors import RoomError
from housefly.geometry import Quaternion, Vec2
from housefly.room.ros_image import MAP_SIDE_MAX, RosMap
from housefly.room.ros_yaml import RESOLUTIONS

OCCUPIED_FROM, FREE_TO = 65, 25
"""A cell is occupied from the one on, free up to the other [%]: as nav2's map_saver has it."""
_PLACE_MAX = 1e6
_YAW_MAX, _TILT_MAX = 1e-3, 1e-3
"""A map that is turned, or leans, by more is refused [rad]: cells lie along the axes."""


@dataclass(frozen=True, slots=True, eq=False)
class OccupancyMessage:
    """What a map's message says.

    Attributes:
        size: cells along x and y.
        resolution: edge of a cell [m].
        origin: world position of the lower left corner [m].
        orientation: of the map (w, x, y, z); all zeros, as nobody set it, is none.
        values: -1 for unknown, else the probability that a cell is occupied [%]; rows along x, the
            lowest first.
    """

    size: tuple[int, int]
    resolution: float
    origin: Vec2
    orientation: Quaternion
    values: NDArray[np.int8]


def ros_map_of(told: OccupancyMessage, name: str) -> RosMap:
    """Return the map of a message.

    Args:
        told: the message.
        name: of where it came from.

    Raises:
        RoomError: saying which value is bad and what is allowed.
    """
    _check_size(told, name)
    _check_place(told, name)
    columns, rows = told.size
    cells = told.values.reshape(rows, columns).T
    outside = (cells < -1) | (cells > 100)
    if outside.any():
        raise RoomError(
            f"{name}: {np.count_nonzero(outside)} cells have values such as {cells[outside][0]};"
            " allowed: -1 (unknown) and 0 to 100 %"
        )
    occupied, free = cells >= OCCUPIED_FROM, (cells >= 0) & (cells <= FREE_TO)
    return RosMap(
        told.origin,
        told.resolution,
        np.ascontiguousarray(occupied),
        np.ascontiguousarray(free),
    )


def _check_size(told: OccupancyMessage, name: str) -> None:
    columns, rows = told.size
    if not (1 <= columns <= MAP_SIDE_MAX and 1 <= rows <= MAP_SIDE_MAX):
        raise RoomError(f"{name} has {columns} x {rows} cells; allowed: 1 to {MAP_SIDE_MAX} a side")
    if len(told.values) != columns * rows:
        raise RoomError(f"{name} has {len(told.values)} values for {columns} x {rows} cells")
    low, high = RESOLUTIONS
    if not low <= told.resolution <= high:
        raise RoomError(
            f"{name}: its resolution is {told.resolution:g}; allowed: {low:g} to {high:g} m per"
            " cell"
        )


def _check_place(told: OccupancyMessage, name: str) -> None:
    x, y = told.origin
    if not all(isfinite(part) and abs(part) <= _PLACE_MAX for part in (x, y)):
        raise RoomError(
            f"{name}: its origin is ({x:g}, {y:g}) m; allowed: finite numbers up to {_PLACE_MAX:g}"
        )
    w, qx, qy, qz = told.orientation
    if not any(told.orientation):
        return
    yaw, tilt = 2.0 * atan2(qz, w), hypot(qx, qy)
    yaw = (yaw + pi) % (2.0 * pi) - pi
    if not (abs(yaw) <= _YAW_MAX and tilt <= _TILT_MAX and isfinite(hypot(w, qz))):
        raise RoomError(
            f"{name}: it is turned by {yaw:.3f} rad; only 0 can be imported: let its node publish"
            " it unturned"
        )
