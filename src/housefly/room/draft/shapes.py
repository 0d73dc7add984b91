"""The walls, boxes, pad and places of a draft as the room that is flown in."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import atan2, cos, hypot, sin

from housefly.errors import ConfigError
from housefly.geometry import Vec2, Vec3
from housefly.messages.words import Words
from housefly.room.draft.model import DraftBox, DraftPlace, DraftWall, SiteDraft
from housefly.room.home_pad import home_pad
from housefly.room.model import BUILDING_PARTS, Colour, Place, Room, Shape, Solid
from housefly.room.spots import LOOK_DISTANCE

_WALL: Colour = (0.86, 0.83, 0.77, 1.0)
_UNEXPLORED: Colour = (0.60, 0.63, 0.66, 1.0)
_FURNITURE: Colour = (0.72, 0.53, 0.34, 1.0)
_MIN_EXTENT = 0.01
ENTRANCE = "entrance"
"""The place where who rings is looked at; the services that are shipped know it by this name."""
VISITOR_DISTANCE, VISITOR_SPACE = 1.5, 0.4
"""Who rings stands so far before where the drone looks from, and so far from door and walls [m]."""


def shell_of_draft(draft: SiteDraft) -> Room:
    """Return the room without pad and places; raises ConfigError while its size is unknown."""
    if draft.bounds is None:
        raise ConfigError(
            "bounds", Words("the room has no size yet: give its length and width, or a file")
        )
    x_min, y_min, x_max, y_max = draft.bounds
    if not (x_min < x_max and y_min < y_max):
        raise ConfigError("bounds", Words("x_min must be below x_max, and y_min below y_max [m]"))
    solids = _named_apart(
        (
            *(_of_wall(wall, f"wall {n}", draft.height) for n, wall in enumerate(draft.walls)),
            *(_of_box(box) for box in (*draft.furniture, *draft.scanned)),
        )
    )
    return Room(draft.name or "my room", draft.bounds, draft.height, solids, (), (), (x_min, y_min))


def room_of_draft(draft: SiteDraft) -> Room:
    """Return the room of a draft; without a pad it lies in the middle of the floor.

    Raises:
        ConfigError: the size is unknown.
    """
    shell = shell_of_draft(draft)
    x_min, y_min, x_max, y_max = shell.bounds
    home = draft.pad or ((x_min + x_max) / 2, (y_min + y_max) / 2)
    places = tuple(_place(place, home, draft) for place in draft.places if place.name != "home")
    room = replace(
        shell,
        solids=(*shell.solids, *home_pad(home)),
        places=(Place("home", home, _away(home, home, draft), "Home"), *places),
        home=home,
        home_yaw=draft.pad_yaw,
    )
    entrance = next((place for place in places if place.name == ENTRANCE), None)
    return _with_visitor(room, entrance) if entrance is not None else room


def _with_visitor(room: Room, entrance: Place) -> Room:
    """Return a room where who rings stands before the door, inside, and faces the drone."""
    (x, y), (u, v) = entrance.viewpoint, entrance.look_at[:2]
    away = max(1e-6, hypot(u - x, v - y))
    share = max(0.0, min(VISITOR_DISTANCE, away - VISITOR_SPACE)) / away
    x_min, y_min, x_max, y_max = room.bounds
    place = (
        round(min(max(x + share * (u - x), x_min + VISITOR_SPACE), x_max - VISITOR_SPACE), 3),
        round(min(max(y + share * (v - y), y_min + VISITOR_SPACE), y_max - VISITOR_SPACE), 3),
    )
    return replace(room, visitor=place, visitor_yaw=round(atan2(y - v, x - u), 3))


def _place(place: DraftPlace, home: Vec2, draft: SiteDraft) -> Place:
    spot = place.x, place.y
    look_at = place.look_at or _away(spot, home, draft)
    return Place(place.name, spot, look_at, place.title or place.name.capitalize())


def _away(spot: Vec2, home: Vec2, draft: SiteDraft) -> Vec3:
    """Return a point beyond the spot as seen from home; ahead of the pad for home itself [m]."""
    dx, dy = spot[0] - home[0], spot[1] - home[1]
    length = hypot(dx, dy)
    yaw = draft.pad_yaw if length < 1e-6 else atan2(dy, dx)
    return (
        round(spot[0] + LOOK_DISTANCE * cos(yaw), 3),
        round(spot[1] + LOOK_DISTANCE * sin(yaw), 3),
        draft.flight_height,
    )


def _of_wall(wall: DraftWall, name: str, ceiling: float) -> Solid:
    (x0, y0), (x1, y1) = wall.start, wall.end
    top = ceiling if wall.top is None else wall.top
    height = max(_MIN_EXTENT, top - wall.bottom)
    return Solid(
        name=name,
        thing="wall",
        shape=Shape.BOX,
        position=(round((x0 + x1) / 2, 4), round((y0 + y1) / 2, 4), wall.bottom + height / 2),
        # Half a thickness more at each end closes the corners.
        size=(round(hypot(x1 - x0, y1 - y0) + wall.thickness, 4), wall.thickness, height),
        yaw=round(atan2(y1 - y0, x1 - x0), 6),
        colour=_WALL,
        texture="wall",
    )


def _of_box(box: DraftBox) -> Solid:
    thing = box.thing or box.name
    is_building = thing in BUILDING_PARTS
    height = max(_MIN_EXTENT, box.top - box.bottom)
    colour = _UNEXPLORED if thing == "unexplored" else _WALL if is_building else _FURNITURE
    return Solid(
        name=box.name,
        thing=thing,
        shape=Shape.BOX,
        position=(box.x, box.y, round(box.bottom + height / 2, 4)),
        size=(box.length, box.width, round(height, 4)),
        yaw=box.yaw,
        colour=colour,
        texture="wall" if is_building else "wood",
    )


def _named_apart(solids: Iterable[Solid]) -> tuple[Solid, ...]:
    """Return the solids with a number behind each name that an earlier one has already."""
    used: dict[str, int] = {}
    apart: list[Solid] = []
    names: set[str] = set()
    for solid in solids:
        name = solid.name
        while name in names:
            used[solid.name] = used.get(solid.name, 1) + 1
            name = f"{solid.name} {used[solid.name]}"
        names.add(name)
        apart.append(replace(solid, name=name))
    return tuple(apart)
