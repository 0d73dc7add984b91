"""What ROS is told of the room: markers, people, things."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

from housefly.hub.api.answers import PlacedThing
from housefly.messages import Obstacle
from housefly.record.ros_markers import (
    LABEL_COLOUR,
    MarkerAction,
    MarkerShape,
    marker,
    marker_array,
    obstacle_marker,
    solid_marker,
)
from housefly.record.ros_messages import about_z, header, message, pose_message
from housefly.room.model import Colour, Solid

_THING_COLOUR: Colour = (0.20, 0.50, 0.85, 1.0)
_THING_SIZE, _TEXT_HEIGHT = 0.12, 0.12
"""How large a thing and its name are drawn [m]."""
_OBSTACLE_LIFE = 1.0
"""What nobody sees any longer leaves the picture after this [s]."""


def room_markers(at: float, frame: str, solids: Iterable[Solid]) -> Any:
    """Return visualization_msgs/MarkerArray of walls and furniture; a thing is a namespace."""
    return marker_array(
        solid_marker(at, number, solid, frame) for number, solid in enumerate(solids)
    )


def thing_markers(at: float, frame: str, things: Iterable[PlacedThing]) -> Any:
    """Return visualization_msgs/MarkerArray of things that have a place, each with its name."""
    nothing, text = (0.0, 0.0, 0.0), (0.0, 0.0, _TEXT_HEIGHT)
    gone = MarkerAction.DELETE_ALL
    markers = [
        marker(
            at, "", 0, MarkerShape.CUBE, nothing, nothing, LABEL_COLOUR, action=gone, frame=frame
        )
    ]
    for number, thing in enumerate(things):
        if thing.position is None:
            continue
        x, y, z = thing.position
        size, above = (_THING_SIZE,) * 3, (x, y, z + 1.5 * _THING_SIZE)
        markers += (
            marker(
                at,
                thing.kind,
                number,
                MarkerShape.SPHERE,
                (x, y, z),
                size,
                _THING_COLOUR,
                frame=frame,
            ),
            marker(
                at,
                "names",
                number,
                MarkerShape.TEXT,
                above,
                text,
                LABEL_COLOUR,
                text=thing.name,
                frame=frame,
            ),
        )
    return marker_array(markers)


def obstacle_markers(at: float, frame: str, obstacles: Iterable[Obstacle]) -> Any:
    """Return visualization_msgs/MarkerArray of what stands or walks in the way."""
    return marker_array(obstacle_marker(at, seen, _OBSTACLE_LIFE, frame) for seen in obstacles)


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
