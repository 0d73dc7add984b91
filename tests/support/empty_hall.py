"""A room with nothing in it, for tests of the simulated world."""

from __future__ import annotations

from housefly.geometry import Vec2
from housefly.room.model import Place, Room, Solid, TrackingCamera

HOME: Vec2 = (2.0, 2.5)


def empty_hall(
    solids: tuple[Solid, ...] = (),
    cameras: tuple[TrackingCamera, ...] = (),
    visitor: Vec2 | None = None,
) -> Room:
    """Return a room 12 m by 5 m with nothing in it unless asked."""
    place = Place("home", HOME, (3.0, 2.5, 1.0))
    return Room("hall", (0.0, 0.0, 12.0, 5.0), 2.6, solids, (place,), cameras, HOME, 0.0, visitor)
