"""The things that site and room model already know: furniture, places, tracking cameras, the drone."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import atan2

from housefly.config.furniture import FurnitureConfig
from housefly.config.site import Site
from housefly.geometry import Vec3, quaternion_from_euler
from housefly.hub.things.thing import Kind, Thing, Viewpoint
from housefly.room.model import Room, Solid

BUILDING = (
    "wall",
    "floor",
    "ceiling",
    "partition",
    "window",
    "outside",
    "home pad",
    "carpet",
    "door",
)
"""Solids of things with these words in their names are parts of the building."""


def things_of(site: Site, room: Room) -> tuple[Thing, ...]:
    """Return the catalogue that a room brings along; ids are their names in lower case with dashes."""
    found = {
        thing.id: thing
        for thing in (*_furniture(room), *_places(room, site.map.flight_height), *_sensors(room))
    }
    for piece in site.furniture:
        known = found.get(thing_of(piece), Thing(thing_of(piece), piece.name, Kind.FURNITURE))
        names = tuple(
            name for name in (piece.name, piece.body) if name not in (known.name, known.id)
        )
        found[known.id] = replace(known, aliases=tuple(dict.fromkeys((*known.aliases, *names))))
    body = site.tracking.body
    found.setdefault(body, Thing(body, "the drone", Kind.ROBOT, ("drone",), (*room.home, 0.0)))
    if room.visitor is not None:
        found.setdefault(
            site.tracking.visitor,
            Thing(site.tracking.visitor, "the visitor", Kind.PERSON, ("visitor",)),
        )
    return tuple(found.values())


def thing_of(piece: FurnitureConfig) -> str:
    """Return the id of a thing that the tracking system sees."""
    return _id(piece.model or piece.name)


def _furniture(room: Room) -> Iterator[Thing]:
    parts: dict[str, list[Solid]] = {}
    for solid in room.solids:
        parts.setdefault(solid.thing, []).append(solid)
    for name, solids in parts.items():
        slug = _id(name)
        is_building = any(word in name for word in BUILDING)
        middle = _middle(solids)
        yaw = solids[0].yaw
        kind = Kind.STRUCTURE if is_building else Kind.FURNITURE
        yield Thing(slug, name, kind, (), middle, quaternion_from_euler(0.0, 0.0, yaw))


def _places(room: Room, height: float) -> Iterator[Thing]:
    for place in room.places:
        x, y = place.viewpoint
        look_x, look_y, _ = place.look_at
        view = Viewpoint("hover", (x, y, height), atan2(look_y - y, look_x - x))
        title = place.title or place.name
        yield Thing(
            _id(f"place {place.name}"),
            title,
            Kind.PLACE,
            (place.name,),
            place.look_at,
            viewpoints=(view,),
        )


def _sensors(room: Room) -> Iterator[Thing]:
    for camera in room.cameras:
        yield Thing(
            _id(f"camera {camera.name}"),
            f"tracking camera {camera.name}",
            Kind.SENSOR,
            (),
            camera.position,
        )


def _id(name: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _middle(solids: Iterable[Solid]) -> Vec3:
    """Return the middle of what the solids reach over, each taken unturned [m]."""
    places = [solid.position for solid in solids]
    x, y, z = (0.5 * (min(axis) + max(axis)) for axis in zip(*places, strict=True))
    return x, y, z
