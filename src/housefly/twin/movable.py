"""Movable things of the simulated room: those that no map shows, and furniture with markers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import cos, sin
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.geometry import Vec3, rotate, wrap_angle
from housefly.messages import Pose
from housefly.room.mjcf import geom
from housefly.room.model import Room, Solid
from housefly.room.tracked import body_pose_of, solids_of, stand_of
from housefly.twin.contracts import AWAY_Z

MOVABLE_PREFIX = "movable "
"""Prefix of the names of movable bodies."""
_MARKER_HEIGHT = 0.02
"""How far markers stand out [m]."""
_MARKER_RADIUS = 0.25
"""Radius of the markers on furniture around its body [m]."""
AWAY_POSE = Pose((0.0, 0.0, AWAY_Z))


@dataclass(frozen=True, slots=True)
class Movable:
    """A thing that can be put anywhere.

    Attributes:
        name: of the thing; it carries markers if the site's furniture has a body of this name.
        radius: of the circle of its markers [m]; without solids, also that of an upright cylinder.
        height: of its top, where the markers are [m].
        solids: its parts, in its own frame.
        start: its first pose.
    """

    name: str
    radius: float = _MARKER_RADIUS
    height: float = 1.5
    solids: tuple[Solid, ...] = ()
    start: Pose = AWAY_POSE


def movable_furniture(site: Site, room: Room) -> Iterator[Movable]:
    """Yield the furniture of the room model that tracking sees, each where the model has it."""
    for piece in site.furniture:
        stand = stand_of(room, piece)
        if stand is not None:
            pose = body_pose_of(piece, stand.middle, stand.yaw)
            solids = tuple(_seen_from(pose, solid) for solid in solids_of(room, piece.model))
            yield Movable(piece.body, _MARKER_RADIUS, stand.top, solids, pose)


def marker_positions(movable: Movable, pose: Pose) -> NDArray[np.float64]:
    """Return the world positions [m] of the four markers on top of a thing, shape (4, 3)."""
    out, up = 0.8 * movable.radius, movable.height + _MARKER_HEIGHT
    corners: tuple[Vec3, ...] = ((out, 0.0, up), (0.0, out, up), (-out, 0.0, up), (0.0, -out, up))
    positions: NDArray[np.float64] = (
        np.array([rotate(pose.orientation, corner) for corner in corners]) + pose.position
    )
    return positions


def movable_body(movable: Movable) -> str:
    """Return the MJCF of a movable thing as a mocap body."""
    (x, y, z), quaternion = movable.start.position, movable.start.orientation
    turn = " ".join(f"{number:.9g}" for number in quaternion)
    cylinder = (
        f'<geom type="cylinder" pos="0 0 {movable.height / 2:.9g}" size="{movable.radius:.9g}'
        f' {movable.height / 2:.9g}" rgba="0.35 0.42 0.55 1" material="cloth"/>'
    )
    parts = "".join(geom(solid) for solid in movable.solids) or cylinder
    name = quoteattr(MOVABLE_PREFIX + movable.name)
    return (
        f'<body name={name} mocap="true" pos="{x:.9g} {y:.9g} {z:.9g}" quat="{turn}">{parts}</body>'
    )


def _seen_from(pose: Pose, solid: Solid) -> Solid:
    """Return a solid of the room in the frame of a pose on the floor."""
    (x, y, z), (px, py, _), yaw = solid.position, pose.position, pose.yaw
    dx, dy = x - px, y - py
    own = (cos(yaw) * dx + sin(yaw) * dy, cos(yaw) * dy - sin(yaw) * dx, z)
    return replace(solid, position=own, yaw=wrap_angle(solid.yaw - yaw))
