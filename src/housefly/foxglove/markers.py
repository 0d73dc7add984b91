"""Solids, obstacles, people and drones as visualization_msgs/MarkerArray in the frame ``world``."""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, sin
from typing import Any
from zlib import crc32

import numpy as np

from housefly.bus.interfaces import type_store
from housefly.config.drone import DroneConfig
from housefly.config.furniture import FurnitureConfig
from housefly.geometry import IDENTITY, Quaternion, Vec3
from housefly.messages import Obstacle, ObstacleKind, Sighting
from housefly.record.ros_messages import nanoseconds
from housefly.room.model import Colour, Room, Shape, Solid
from housefly.room.tracked import footprint_of

WORLD = "world"
_CUBE, _CYLINDER, _TEXT = 1, 3, 9
_ADD, _DELETE = 0, 2
_FOREVER = 0.0
_NO_BYTES = np.zeros(0, dtype=np.uint8)
_OBSTACLE_LIFE, _BODY_LIFE = 2.0, 2.0
"""A thing that nobody sees any longer leaves the picture after this [s]."""
_TALL = 1.7
"""Height at which a person is drawn [m]."""
_COLOURS: dict[ObstacleKind, Colour] = {
    ObstacleKind.PERSON: (0.85, 0.25, 0.55, 0.8),
    ObstacleKind.DRONE: (0.2, 0.5, 0.9, 0.8),
    ObstacleKind.THING: (0.9, 0.6, 0.2, 0.7),
    ObstacleKind.UNKNOWN: (0.6, 0.6, 0.6, 0.7),
}
_FURNITURE: Colour = (0.75, 0.6, 0.4, 0.9)
_DRONE: Colour = (0.15, 0.45, 0.85, 0.9)
_LABEL: Colour = (1.0, 1.0, 1.0, 1.0)


def solid_markers(at: float, room: Room) -> Any:
    """Return the walls and the furniture that stand, and the names of the places."""
    solids = [_solid(at, number, solid) for number, solid in enumerate(room.solids)]
    labels = [
        _marker(
            at, "places", number, _TEXT, (*place.viewpoint, 0.1), (0.0, 0.0, 0.2), _LABEL,
            text=place.title or place.name,
        )
        for number, place in enumerate(room.places)
    ]  # fmt: skip
    return _array([*solids, *labels])


def obstacle_markers(at: float, obstacle: Obstacle) -> Any:
    """Return an obstacle as it was seen at a time [s]; one that is gone is taken away."""
    height = max(obstacle.top - obstacle.bottom, 0.01)
    size = tuple(side + 2.0 * obstacle.radius for side in obstacle.size)
    is_disc = obstacle.size == (0.0, 0.0)
    marker = _marker(
        at,
        obstacle.source or "obstacles",
        _number(obstacle.id),
        _CYLINDER if is_disc else _CUBE,
        (*obstacle.position, obstacle.bottom + height / 2.0),
        (max(size[0], 0.02), max(size[1], 0.02), height),
        _COLOURS[obstacle.kind],
        _about_z(obstacle.yaw),
        life=_OBSTACLE_LIFE,
        action=_ADD if obstacle.confidence > 0.0 else _DELETE,
    )
    return _array([marker])


def tracked_markers(
    at: float,
    sightings: Iterable[Sighting],
    furniture: dict[str, FurnitureConfig],
    people: dict[str, float],
) -> Any:
    """Return furniture and people where tracking sees them.

    Args:
        at: Unix time [s].
        sightings: of one frame.
        furniture: by the names of their bodies.
        people: radius [m] by the names of their bodies.
    """
    return _array(
        [
            _furniture(at, furniture[one.body], one)
            if one.body in furniture
            else _person(at, one, people[one.body])
            for one in sightings
            if one.body in furniture or one.body in people
        ]
    )


def drone_markers(at: float, drone: DroneConfig, frame: str) -> Any:
    """Return the hull of a drone, fixed to its frame."""
    size = (drone.hull_length, drone.hull_width, drone.hull_height)
    hull = _marker(at, frame, 0, _CUBE, (0.0, 0.0, 0.0), size, _DRONE, frame=frame)
    name = _marker(
        at, frame, 1, _TEXT, (0.0, 0.0, 0.3), (0.0, 0.0, 0.15), _LABEL, text=drone.name, frame=frame
    )
    return _array([hull, name])


def _solid(at: float, number: int, solid: Solid) -> Any:
    shape = _CYLINDER if solid.shape is Shape.CYLINDER else _CUBE
    turn = _about_z(solid.yaw)
    return _marker(at, solid.thing, number, shape, solid.position, solid.size, solid.colour, turn)


def _furniture(at: float, piece: FurnitureConfig, seen: Sighting) -> Any:
    (x, y), yaw = footprint_of(piece, seen.pose)
    height = piece.top - piece.bottom
    return _marker(
        at,
        "furniture",
        _number(piece.body),
        _CUBE,
        (x, y, piece.bottom + height / 2.0),
        (piece.length, piece.width, height),
        _FURNITURE,
        _about_z(yaw),
        life=_BODY_LIFE,
    )


def _person(at: float, seen: Sighting, radius: float) -> Any:
    x, y, _ = seen.pose.position
    size, colour = (2.0 * radius, 2.0 * radius, _TALL), _COLOURS[ObstacleKind.PERSON]
    place = (x, y, _TALL / 2.0)
    number = _number(seen.body)
    return _marker(at, "people", number, _CYLINDER, place, size, colour, life=_BODY_LIFE)


def _number(name: str) -> int:
    """Return a name as a marker's number, the same in each message."""
    return crc32(name.encode()) & 0x7FFFFFFF


def _about_z(yaw: float) -> Quaternion:
    return cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)


def _marker(
    at: float,
    namespace: str,
    number: int,
    shape: int,
    position: Vec3,
    size: Vec3,
    colour: Colour,
    turn: Quaternion = IDENTITY,
    *,
    text: str = "",
    life: float = _FOREVER,
    action: int = _ADD,
    frame: str = WORLD,
) -> Any:
    w, x, y, z = turn
    stamp = _new("builtin_interfaces/msg/Time", *divmod(nanoseconds(at), 1_000_000_000))
    epoch = _new("builtin_interfaces/msg/Time", 0, 0)
    no_image = _new(
        "sensor_msgs/msg/CompressedImage",
        _new("std_msgs/msg/Header", epoch, ""),
        "",
        _NO_BYTES,
    )
    return _new(
        "visualization_msgs/msg/Marker",
        _new("std_msgs/msg/Header", stamp, frame),
        namespace,
        number,
        shape,
        action,
        _new(
            "geometry_msgs/msg/Pose",
            _new("geometry_msgs/msg/Point", *position),
            _new("geometry_msgs/msg/Quaternion", x, y, z, w),
        ),
        _new("geometry_msgs/msg/Vector3", *size),
        _new("std_msgs/msg/ColorRGBA", *colour),
        _new("builtin_interfaces/msg/Duration", *divmod(nanoseconds(life), 1_000_000_000)),
        frame != WORLD,
        [],
        [],
        "",
        no_image,
        [],
        text,
        "",
        _new("visualization_msgs/msg/MeshFile", "", _NO_BYTES),
        False,
    )


def _array(markers: list[Any]) -> Any:
    return _new("visualization_msgs/msg/MarkerArray", markers)


def _new(name: str, *values: Any) -> Any:
    return type_store().types[name](*values)
