"""A room as a value: solids, places, tracking cameras, home pad, visitor.

The same value becomes the occupancy grid (``room.grid``), the MuJoCo model (``room.mjcf``) and the
drawing (``room.draw``). World frame, metres, radians.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.config.text import names_like
from housefly.geometry import Quaternion, Vec2, Vec3
from housefly.messages.words import Words


class Shape(Enum):
    """Primitive shapes; sizes are full extents."""

    BOX = "box"
    CYLINDER = "cylinder"


Colour = tuple[float, float, float, float]
BUILDING_PARTS = frozenset({"wall", "unexplored", "window", "entrance door", "room door"})
"""What ``Solid.thing`` is where a solid belongs to the building."""


@dataclass(frozen=True, slots=True)
class Solid:
    """One primitive of the room.

    Attributes:
        name: unique name; parts of one thing share ``thing``.
        thing: the piece of furniture or building part that it belongs to ("sofa", "wall", ...).
        shape: BOX with size (length x, width y, height z) or CYLINDER with size (diameter,
            diameter, height) [m].
        position: centre [m].
        yaw: rotation about z [rad].
        size: full extents before rotation [m].
        colour: red, green, blue, alpha from 0 to 1.
        collides: whether the drone can touch it (carpets and pads do not count).
        texture: name of a texture of ``room.mjcf`` or "".
    """

    name: str
    thing: str
    shape: Shape
    position: Vec3
    size: Vec3
    yaw: float = 0.0
    colour: Colour = (0.7, 0.7, 0.7, 1.0)
    collides: bool = True
    texture: str = ""


@dataclass(frozen=True, slots=True)
class Place:
    """A named place with its viewpoint.

    Attributes:
        name: short lower-case name ("entrance").
        viewpoint: where to hover, world xy [m].
        look_at: what to look at [m].
        title: shown to people ("Entrance").
    """

    name: str
    viewpoint: Vec2
    look_at: Vec3
    title: str = ""


@dataclass(frozen=True, slots=True)
class TrackingCamera:
    """One camera of the motion capture system: a pinhole looking along its own +z.

    See ``room.coverage``.

    Attributes:
        name: for people.
        position: world [m].
        orientation: (w, x, y, z), camera to world; the camera looks along +z, x right in the image,
            y down.
        field_of_view: full horizontal and vertical angle [rad].
        reach: farthest distance at which it sees a marker [m].
    """

    name: str
    position: Vec3
    orientation: Quaternion
    field_of_view: Vec2
    reach: float = 12.0


@dataclass(frozen=True, slots=True)
class Room:
    """Everything known about a room in advance.

    Attributes:
        name: for people.
        bounds: x_min, y_min, x_max, y_max of the floor plan [m].
        height: ceiling height [m].
        solids: walls, door, furniture.
        places: named places; always contains "home".
        cameras: motion capture cameras; empty means that tracking sees everywhere.
        home: position of the home pad on the floor, where the drone starts and lands [m].
        home_yaw: heading of the drone on the pad [rad].
        visitor: where a visitor stands (feet), or None.
        visitor_yaw: where the visitor faces [rad].
        other_pads: where other drones start and land, by their names [m].
    """

    name: str
    bounds: tuple[float, float, float, float]
    height: float
    solids: tuple[Solid, ...]
    places: tuple[Place, ...]
    cameras: tuple[TrackingCamera, ...]
    home: Vec2
    home_yaw: float = 0.0
    visitor: Vec2 | None = None
    visitor_yaw: float = 0.0
    other_pads: tuple[tuple[str, Vec2], ...] = ()

    def place(self, name: str) -> Place:
        """Return the place with this name; raises KeyError with the known names."""
        for place in self.places:
            if place.name == name.lower():
                return place
        known = [place.name for place in self.places]
        raise KeyError(unknown_place(name, known))


def unknown_place(name: str, known: list[str]) -> Words:
    """Return that no place has this name, and which there are."""
    places = ", ".join(known)
    if close := names_like(name, known):
        return Words(
            "no place called {name}: did you mean {place}? known places: {places}",
            name=repr(name),
            place=close,
            places=places,
        )
    return Words("no place called {name}; known places: {places}", name=repr(name), places=places)
