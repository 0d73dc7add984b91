"""Seats, beds and the entrance, from the model of the room."""

from __future__ import annotations

from housefly.hub.situations.layout import Area
from housefly.room.model import Room, Shape, Solid

_LOWEST_SEAT = 0.25
"""Nobody sits lower than this [m]."""
_HIGHEST_SEAT = 0.65
"""Nobody sits higher than this [m]."""
_ENTRANCE_SIDE = 1.5
"""Side of the square at the door that counts as the entrance [m]."""


def seats_of(room: Room) -> tuple[Area, ...]:
    """Return the seats of chairs and sofas: boxes named so, at the height of a seat."""
    return tuple(_area(solid) for solid in room.solids if _is(solid, "seat"))


def beds_of(room: Room) -> tuple[Area, ...]:
    """Return the mattresses."""
    return tuple(_area(solid) for solid in room.solids if _is(solid, "mattress"))


def entrance_of(room: Room) -> Area | None:
    """Return the square around the visitor's place, None in a room without one."""
    return (
        Area("entrance", room.visitor, (_ENTRANCE_SIDE, _ENTRANCE_SIDE))
        if room.visitor is not None
        else None
    )


def _is(solid: Solid, word: str) -> bool:
    top = solid.position[2] + solid.size[2] / 2
    return (
        solid.shape is Shape.BOX
        and word in solid.name.split()
        and _LOWEST_SEAT <= top <= _HIGHEST_SEAT
    )


def _area(solid: Solid) -> Area:
    return Area(solid.name, solid.position[:2], solid.size[:2], solid.yaw)
