"""What ROS is told of the room: markers, people, things."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

import numpy as np

from housefly.geometry import IDENTITY, Quaternion, Vec3
from housefly.hub.api.answers import PlacedThing
from housefly.messages import Obstacle, ObstacleKind
from housefly.record.ros_messages import about_z, header, message, pose_message
from housefly.room.model import Colour, Shape, Solid

_CUBE, _SPHERE, _CYLINDER, _TEXT = 1, 2, 3, 9
_ADD, _DELETE_ALL = 0, 3
_PERSON_COLOUR: Colour = (0.93, 0.55, 0.16, 0.8)
_OBSTACLE_COLOUR: Colour = (0.80, 0.20, 0.18, 0.6)
_THING_COLOUR: Colour = (0.20, 0.50, 0.85, 1.0)
_TEXT_COLOUR: Colour = (0.95, 0.95, 0.95, 1.0)
_THING_SIZE, _TEXT_HEIGHT = 0.12, 0.12
"""How large a thing and its name are drawn [m]."""


def room_markers(at: float, frame: str, solids: Iterable[Solid]) -> Any:
    """Return visualization_msgs/MarkerArray of walls and furniture; a thing is a namespace."""
    shapes = {Shape.BOX: _CUBE, Shape.CYLINDER: _CYLINDER}
    return _array(
        _marker(
            at,
            frame,
            solid.thing,
            number,
            shapes[solid.shape],
            solid.position,
            solid.size,
            solid.colour,
            about_z(solid.yaw),
        )
        for number, solid in enumerate(solids)
    )


def thing_markers(at: float, frame: str, things: Iterable[PlacedThing]) -> Any:
    """Return visualization_msgs/MarkerArray of things that have a place, each with its name."""
    markers = [_cleared(at, frame)]
    for number, thing in enumerate(things):
        if thing.position is None:
            continue
        x, y, z = thing.position
        size = (_THING_SIZE,) * 3
        markers.append(
            _marker(at, frame, thing.kind, number, _SPHERE, (x, y, z), size, _THING_COLOUR)
        )
        above = (x, y, z + 1.5 * _THING_SIZE)
        label = _marker(
            at, frame, "names", number, _TEXT, above, (0.0, 0.0, _TEXT_HEIGHT), _TEXT_COLOUR
        )
        label.text = thing.name
        markers.append(label)
    return _array(markers)


def obstacle_markers(at: float, frame: str, obstacles: Iterable[Obstacle]) -> Any:
    """Return visualization_msgs/MarkerArray of what stands or walks in the way."""
    markers = [_cleared(at, frame)]
    for number, seen in enumerate(obstacles):
        length, width = (max(2 * seen.radius + side, 0.05) for side in seen.size)
        is_disc = not any(seen.size)
        markers.append(
            _marker(
                at,
                frame,
                seen.kind.value,
                number,
                _CYLINDER if is_disc else _CUBE,
                (*seen.position, (seen.bottom + seen.top) / 2),
                (length, width, max(seen.top - seen.bottom, 0.05)),
                _PERSON_COLOUR if seen.kind is ObstacleKind.PERSON else _OBSTACLE_COLOUR,
                about_z(seen.yaw),
            )
        )
    return _array(markers)


def people_message(at: float, frame: str, people: Iterable[PlacedThing]) -> Any:
    """Return geometry_msgs/PoseArray of the people who are somewhere."""
    poses = [
        pose_message(one.position, about_z(one.yaw or 0.0))
        for one in people
        if one.position is not None
    ]
    return message("geometry_msgs/msg/PoseArray", header(at, frame), poses)


def json_text(values: Any) -> str:
    """Return a value of the contracts, or several, as JSON; words are in English."""
    tree = [asdict(one) for one in values] if isinstance(values, tuple) else asdict(values)
    return json.dumps(tree, ensure_ascii=False, default=lambda one: one.value)


def _marker(
    at: float,
    frame: str,
    namespace: str,
    number: int,
    kind: int,
    position: Vec3,
    size: Vec3,
    colour: Colour,
    orientation: Quaternion = IDENTITY,
) -> Any:
    """Return visualization_msgs/Marker that stays until it is replaced."""
    nothing = np.array([], dtype=np.uint8)
    return message(
        "visualization_msgs/msg/Marker",
        header(at, frame),
        namespace,
        number,
        kind,
        _ADD,
        pose_message(position, orientation),
        message("geometry_msgs/msg/Vector3", *size),
        message("std_msgs/msg/ColorRGBA", *colour),
        message("builtin_interfaces/msg/Duration", 0, 0),
        False,
        [],
        [],
        "",
        message("sensor_msgs/msg/CompressedImage", header(0.0, ""), "", nothing),
        [],
        "",
        "",
        message("visualization_msgs/msg/MeshFile", "", nothing),
        False,
    )


def _cleared(at: float, frame: str) -> Any:
    """Return the marker that takes all earlier ones away."""
    marker = _marker(at, frame, "", 0, _CUBE, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), _TEXT_COLOUR)
    marker.action = _DELETE_ALL
    return marker


def _array(markers: Iterable[Any]) -> Any:
    return message("visualization_msgs/msg/MarkerArray", list(markers))
