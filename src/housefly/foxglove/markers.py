"""Solids, obstacles, people and drones as visualization_msgs/MarkerArray in the frame ``world``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from housefly.config.drone import DroneConfig
from housefly.config.furniture import FurnitureConfig
from housefly.messages import Obstacle, ObstacleKind, Sighting
from housefly.record.ros_markers import (
    KIND_COLOURS,
    LABEL_COLOUR,
    MarkerShape,
    marker,
    marker_array,
    marker_number,
    obstacle_marker,
    solid_marker,
)
from housefly.record.ros_messages import about_z
from housefly.room.model import Colour, Room
from housefly.room.tracked import footprint_of

_OBSTACLE_LIFE, _BODY_LIFE = 2.0, 2.0
"""A thing that nobody sees any longer leaves the picture after this [s]."""
_TALL = 1.7
"""Height at which a person is drawn [m]."""
_FURNITURE: Colour = (0.75, 0.6, 0.4, 0.9)
_DRONE: Colour = (0.15, 0.45, 0.85, 0.9)


def solid_markers(at: float, room: Room) -> Any:
    """Return the walls and the furniture that stand, and the names of the places."""
    solids = [solid_marker(at, number, solid) for number, solid in enumerate(room.solids)]
    labels = [
        marker(
            at,
            "places",
            number,
            MarkerShape.TEXT,
            (*place.viewpoint, 0.1),
            (0.0, 0.0, 0.2),
            LABEL_COLOUR,
            text=place.title or place.name,
        )
        for number, place in enumerate(room.places)
    ]
    return marker_array([*solids, *labels])


def obstacle_markers(at: float, obstacle: Obstacle) -> Any:
    """Return an obstacle as it was seen at a time [s]; one that is gone is taken away."""
    return marker_array([obstacle_marker(at, obstacle, _OBSTACLE_LIFE)])


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
    return marker_array(
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
    middle, above, letters = (0.0, 0.0, 0.0), (0.0, 0.0, 0.3), (0.0, 0.0, 0.15)
    cube, text = MarkerShape.CUBE, MarkerShape.TEXT
    hull = marker(at, frame, 0, cube, middle, size, _DRONE, frame=frame, is_locked=True)
    name = marker(
        at,
        frame,
        1,
        text,
        above,
        letters,
        LABEL_COLOUR,
        text=drone.name,
        frame=frame,
        is_locked=True,
    )
    return marker_array([hull, name])


def _furniture(at: float, piece: FurnitureConfig, seen: Sighting) -> Any:
    (x, y), yaw = footprint_of(piece, seen.pose)
    height = piece.top - piece.bottom
    return marker(
        at,
        "furniture",
        marker_number(piece.body),
        MarkerShape.CUBE,
        (x, y, piece.bottom + height / 2.0),
        (piece.length, piece.width, height),
        _FURNITURE,
        about_z(yaw),
        life=_BODY_LIFE,
    )


def _person(at: float, seen: Sighting, radius: float) -> Any:
    x, y, _ = seen.pose.position
    size, colour = (2.0 * radius, 2.0 * radius, _TALL), KIND_COLOURS[ObstacleKind.PERSON]
    place = (x, y, _TALL / 2.0)
    number = marker_number(seen.body)
    return marker(at, "people", number, MarkerShape.CYLINDER, place, size, colour, life=_BODY_LIFE)
