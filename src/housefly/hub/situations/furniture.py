"""Where one sits, lies and rings, from the model of the room."""

from __future__ import annotations

from housefly.hub.situations.layout import Area
from housefly.room.model import Room, Shape, Solid

LOWEST_SEAT = 0.25
"""Nobody sits on what is lower [m]."""
HIGHEST_SEAT = 0.65
"""Nor on what is higher [m]."""
ENTRANCE_SIDE = 1.5
"""Side of the square before the door in which somebody is at the entrance [m]."""


def seats_of(room: Room) -> tuple[Area, ...]:
    """Return the seats of chairs and sofas: the boxes that are called so and have the height of a
    seat.
    """
    return tuple(_area(solid) for solid in room.solids if _is(solid, "seat"))


def beds_of(room: Room) -> tuple[Area, ...]:
    """Return the mattresses."""
    return tuple(_area(solid) for solid in room.solids if _is(solid, "mattress"))


def entrance_of(room: Room) -> Area | None:
    """Return the square around where a visitor stands, None in a room without one."""
    return (
        Area("entrance", room.visitor, (ENTRANCE_SIDE, ENTRANCE_SIDE))
        if room.visitor is not None
        else None
    )


def _is(solid: Solid, word: str) -> bool:
    top = solid.position[2] + solid.size[2] / 2
    return (
        solid.shape is Shape.BOX
        and word in solid.name.split()
        and LOWEST_SEAT <= top <= HIGHEST_SEAT
    )


def _area(solid: Solid) -> Area:
    return Area(solid.name, solid.position[:2], solid.size[:2], solid.yaw)
