"""Things that site and room model define: furniture, places, tracking cameras, the drone."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import atan2
from pathlib import Path

from housefly.config.furniture import FurnitureConfig
from housefly.config.site import Site
from housefly.geometry import Vec3, quaternion_from_euler
from housefly.hub.things.catalogue import load_catalogue
from housefly.hub.things.thing import Thing, ThingKind, Viewpoint
from housefly.room.model import Room, Solid

_BUILDING_WORDS = (
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
"""Words in the names of solids that belong to the building."""


def things_of(site: Site, room: Room) -> tuple[Thing, ...]:
    """Return the things of a room; ids are their names in lower case with dashes."""
    found = {
        thing.id: thing
        for thing in (*_furniture(room), *_places(room, site.map.flight_height), *_sensors(room))
    }
    for piece in site.furniture:
        known = found.get(
            furniture_id(piece), Thing(furniture_id(piece), piece.name, ThingKind.FURNITURE)
        )
        names = tuple(
            name for name in (piece.name, piece.body) if name not in (known.name, known.id)
        )
        found[known.id] = replace(known, aliases=tuple(dict.fromkeys((*known.aliases, *names))))
    body = site.tracking.body
    found.setdefault(body, Thing(body, "the drone", ThingKind.ROBOT, ("drone",), (*room.home, 0.0)))
    if room.visitor is not None:
        found.setdefault(
            site.tracking.visitor,
            Thing(site.tracking.visitor, "the visitor", ThingKind.PERSON, ("visitor",)),
        )
    return tuple(found.values())


def catalogue_of(site: Site, room: Room, folder: Path) -> tuple[Thing, ...]:
    """Return the things of room and catalogue; raises ConfigError for a bad catalogue."""
    own = load_catalogue(folder / site.hub.things) if site.hub.things else ()
    return (*things_of(site, room), *own)


def furniture_id(piece: FurnitureConfig) -> str:
    """Return the id of a tracked piece of furniture."""
    return _id(piece.model or piece.name)


def _furniture(room: Room) -> Iterator[Thing]:
    parts: dict[str, list[Solid]] = {}
    for solid in room.solids:
        parts.setdefault(solid.thing, []).append(solid)
    for name, solids in parts.items():
        slug = _id(name)
        is_building = any(word in name for word in _BUILDING_WORDS)
        middle = _middle(solids)
        yaw = solids[0].yaw
        kind = ThingKind.STRUCTURE if is_building else ThingKind.FURNITURE
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
            ThingKind.PLACE,
            (place.name,),
            place.look_at,
            viewpoints=(view,),
        )


def _sensors(room: Room) -> Iterator[Thing]:
    for camera in room.cameras:
        yield Thing(
            _id(f"camera {camera.name}"),
            f"tracking camera {camera.name}",
            ThingKind.SENSOR,
            (),
            camera.position,
        )


def _id(name: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _middle(solids: Iterable[Solid]) -> Vec3:
    """Return the middle of the bounding box of the solids' positions [m]."""
    places = [solid.position for solid in solids]
    x, y, z = (0.5 * (min(axis) + max(axis)) for axis in zip(*places, strict=True))
    return x, y, z
