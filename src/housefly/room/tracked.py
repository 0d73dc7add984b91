"""Furniture of the room model that carries markers: its pose comes from tracking.

The pilot's map and perception take such a thing out of the room; ``planning.furniture`` puts it
back where it is.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, pi, sin

import numpy as np

from housefly.config.furniture import FurnitureConfig
from housefly.config.site import Site
from housefly.errors import ConfigError
from housefly.geometry import Vec2, quaternion_from_euler, wrap_angle
from housefly.messages import Pose
from housefly.room.grid import OccupancyGrid, build_grid
from housefly.room.model import Room, Solid
from housefly.room.outline import outline

_TOLERANCE = 0.05
"""A footprint in the site file may be smaller than the model's by this [m]."""


@dataclass(frozen=True, slots=True)
class Stand:
    """Where a thing stands in the room model.

    Attributes:
        middle: of its footprint, the rectangle around everything of it that can be touched [m].
        yaw: of its length [rad].
        size: length and width, in the order of the site file's [m].
        bottom, top: heights above the floor [m].
    """

    middle: Vec2
    yaw: float
    size: Vec2
    bottom: float
    top: float


def solids_of(room: Room, name: str) -> tuple[Solid, ...]:
    """Return the solids of the thing with this name, else those whose own names begin with it."""
    solids = tuple(solid for solid in room.solids if solid.thing == name)
    return solids or tuple(
        solid for solid in room.solids if f"{solid.name} ".startswith(f"{name} ")
    )


def untracked(room: Room, site: Site) -> Room:
    """Return the room without the things that tracking sees; the same room when it sees none.

    Raises:
        ConfigError: the room has no such thing, or its footprint in the site file is too small for
            it.
    """
    gone = {
        solid.name for piece in site.furniture if piece.model for solid in _checked(room, piece)
    }
    return (
        replace(room, solids=tuple(solid for solid in room.solids if solid.name not in gone))
        if gone
        else room
    )


def untracked_grid(room: Room, site: Site, grid: OccupancyGrid) -> OccupancyGrid:
    """Return the grid without the things that tracking sees; ``grid`` itself when it sees none."""
    bare = untracked(room, site)
    return grid if bare is room else build_grid(bare, site)


def stand_of(room: Room, piece: FurnitureConfig) -> Stand | None:
    """Return where a piece stands in the room model, or None.

    Raises ConfigError as ``untracked``.
    """
    return _stand(_checked(room, piece), piece) if piece.model else None


def footprint_of(piece: FurnitureConfig, pose: Pose) -> tuple[Vec2, float]:
    """Return the middle [m] and yaw [rad] of the footprint of a thing whose body has this pose."""
    (x, y, _), yaw = pose.position, pose.yaw
    middle = (
        x + cos(yaw) * piece.x - sin(yaw) * piece.y,
        y + sin(yaw) * piece.x + cos(yaw) * piece.y,
    )
    return middle, wrap_angle(yaw + piece.yaw)


def body_pose_of(piece: FurnitureConfig, middle: Vec2, yaw: float) -> Pose:
    """Return the body pose of a thing whose footprint has this middle [m] and yaw [rad]."""
    turn = wrap_angle(yaw - piece.yaw)
    x, y = cos(turn) * piece.x - sin(turn) * piece.y, sin(turn) * piece.x + cos(turn) * piece.y
    return Pose((middle[0] - x, middle[1] - y, 0.0), quaternion_from_euler(0.0, 0.0, turn))


def _checked(room: Room, piece: FurnitureConfig) -> tuple[Solid, ...]:
    solids, key = solids_of(room, piece.model), f"furniture ({piece.name})"
    if not any(solid.collides for solid in solids):
        things = ", ".join(sorted({solid.thing for solid in room.solids if solid.collides}))
        raise ConfigError(
            key, f"model {piece.model!r} is nothing that the room model has; it has: {things}"
        )
    stand = _stand(solids, piece)
    if min(piece.length - stand.size[0], piece.width - stand.size[1]) < -_TOLERANCE:
        size = f"{stand.size[0]:.2f} m long and {stand.size[1]:.2f} m wide"
        raise ConfigError(
            key, f"{piece.model!r} is {size} in the room model: length and width must be as large"
        )
    if piece.bottom > stand.bottom + _TOLERANCE or piece.top < stand.top - _TOLERANCE:
        heights = f"{stand.bottom:.2f} to {stand.top:.2f} m"
        raise ConfigError(
            key,
            f"{piece.model!r} stands at heights of {heights} in the room model: bottom and top must"
            " include them",
        )
    return solids


def _stand(solids: tuple[Solid, ...], piece: FurnitureConfig) -> Stand:
    """Return the rectangle around solids, along the first; its longer side is the site file's."""
    touched = [solid for solid in solids if solid.collides]
    yaw = touched[0].yaw
    along, aside = np.array((cos(yaw), sin(yaw))), np.array((-sin(yaw), cos(yaw)))
    corners = np.array([corner for solid in touched for corner in outline(solid)])
    (low_u, high_u), (low_v, high_v) = (
        (float(reach.min()), float(reach.max()))
        for reach in (np.einsum("nk,k->n", corners, axis) for axis in (along, aside))
    )
    x, y = (along * (low_u + high_u) + aside * (low_v + high_v)) / 2.0
    length, width = high_u - low_u, high_v - low_v
    if (length >= width) != (piece.length >= piece.width):
        length, width, yaw = width, length, wrap_angle(yaw + pi / 2)
    bottom = min(solid.position[2] - solid.size[2] / 2 for solid in touched)
    top = max(solid.position[2] + solid.size[2] / 2 for solid in touched)
    return Stand((float(x), float(y)), yaw, (length, width), bottom, top)
