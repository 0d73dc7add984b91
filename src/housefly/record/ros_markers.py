"""Solids, obstacles and names as visualization_msgs/Marker, for RViz and Foxglove."""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum
from typing import Any
from zlib import crc32

import numpy as np

from housefly.geometry import IDENTITY, Quaternion, Vec3
from housefly.messages import Obstacle, ObstacleKind
from housefly.record.ros_messages import (
    WORLD_FRAME,
    about_z,
    header,
    message,
    nanoseconds,
    pose_message,
)
from housefly.room.model import Colour, Shape, Solid


class MarkerShape(IntEnum):
    """``type`` of visualization_msgs/Marker."""

    CUBE = 1
    SPHERE = 2
    CYLINDER = 3
    TEXT = 9


class MarkerAction(IntEnum):
    """``action`` of visualization_msgs/Marker."""

    ADD = 0
    DELETE = 2
    DELETE_ALL = 3


KIND_COLOURS: dict[ObstacleKind, Colour] = {
    ObstacleKind.PERSON: (0.85, 0.25, 0.55, 0.8),
    ObstacleKind.DRONE: (0.2, 0.5, 0.9, 0.8),
    ObstacleKind.THING: (0.9, 0.6, 0.2, 0.7),
    ObstacleKind.UNKNOWN: (0.6, 0.6, 0.6, 0.7),
}
LABEL_COLOUR: Colour = (1.0, 1.0, 1.0, 1.0)
_SHAPES = {Shape.BOX: MarkerShape.CUBE, Shape.CYLINDER: MarkerShape.CYLINDER}
_NO_BYTES = np.zeros(0, dtype=np.uint8)


def marker(
    at: float,
    namespace: str,
    number: int,
    shape: MarkerShape,
    position: Vec3,
    size: Vec3,
    colour: Colour,
    turn: Quaternion = IDENTITY,
    *,
    text: str = "",
    life: float = 0.0,
    action: MarkerAction = MarkerAction.ADD,
    frame: str = WORLD_FRAME,
    is_locked: bool = False,
) -> Any:
    """Return visualization_msgs/Marker.

    Args:
        at: its stamp [s].
        namespace: with the number its name: another marker of that name replaces it.
        number: within the namespace.
        shape: of the marker.
        position: of its middle [m].
        size: full extents [m]; of a text only the height of the letters.
        colour: red, green, blue, alpha, 0 to 1.
        turn: its orientation.
        text: of a text.
        life: after which it goes by itself [s]; 0 stays.
        action: what is done with it.
        frame: that it is in.
        is_locked: whether it moves with the frame.
    """
    return message(
        "visualization_msgs/msg/Marker",
        header(at, frame),
        namespace,
        number,
        int(shape),
        int(action),
        pose_message(position, turn),
        message("geometry_msgs/msg/Vector3", *size),
        message("std_msgs/msg/ColorRGBA", *colour),
        message("builtin_interfaces/msg/Duration", *divmod(nanoseconds(life), 1_000_000_000)),
        is_locked,
        [],
        [],
        "",
        message("sensor_msgs/msg/CompressedImage", header(0.0, ""), "", _NO_BYTES),
        [],
        text,
        "",
        message("visualization_msgs/msg/MeshFile", "", _NO_BYTES),
        False,
    )


def marker_array(markers: Iterable[Any]) -> Any:
    """Return visualization_msgs/MarkerArray."""
    return message("visualization_msgs/msg/MarkerArray", list(markers))


def solid_marker(at: float, number: int, solid: Solid, frame: str = WORLD_FRAME) -> Any:
    """Return a wall or a piece of furniture; the namespace is its thing."""
    return marker(
        at,
        solid.thing,
        number,
        _SHAPES[solid.shape],
        solid.position,
        solid.size,
        solid.colour,
        about_z(solid.yaw),
        frame=frame,
    )


def obstacle_marker(at: float, seen: Obstacle, life: float, frame: str = WORLD_FRAME) -> Any:
    """Return an obstacle as it was seen; one that is gone is taken away."""
    height = max(seen.top - seen.bottom, 0.01)
    length, width = (max(side + 2.0 * seen.radius, 0.02) for side in seen.size)
    is_disc = seen.size == (0.0, 0.0)
    return marker(
        at,
        seen.source or "obstacles",
        marker_number(seen.id),
        MarkerShape.CYLINDER if is_disc else MarkerShape.CUBE,
        (*seen.position, seen.bottom + height / 2.0),
        (length, width, height),
        KIND_COLOURS[seen.kind],
        about_z(seen.yaw),
        life=life,
        action=MarkerAction.ADD if seen.confidence > 0.0 else MarkerAction.DELETE,
        frame=frame,
    )


def marker_number(name: str) -> int:
    """Return a name as a marker's number, the same in each message."""
    return crc32(name.encode()) & 0x7FFFFFFF
