"""Things that site and room model define: furniture and its tops, places, cameras, the drone."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import atan2
from pathlib import Path

from housefly import sites
from housefly.config.furniture import FurnitureConfig
from housefly.config.site import Site
from housefly.geometry import Vec3, quaternion_from_euler
from housefly.hub.things.catalogue import load_catalogue
from housefly.hub.things.surfaces import Surface
from housefly.hub.things.thing import NamedPose, Thing, ThingKind
from housefly.room.model import Place, Room, Shape, Solid

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
_SHELF_WORDS = ("shelf", "rack")
"""What has one of them in its name only hangs on the building."""
_SEAT_WORDS = frozenset({"seat", "mattress"})
"""Words in the names of solids that make their thing a seat."""
_LOWEST_TOP, _HIGHEST_TOP = 0.3, 1.5
"""Whoever walks past leaves nothing lower or higher than this [m]."""
_NARROWEST_TOP = 0.18
"""A narrower top is a leg, a handle, an edge [m]."""


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
    for row in site.mqtt.sensors:
        name = row.thing or row.id
        found.setdefault(name, Thing(name, f"the {name.replace('-', ' ')}"))
    for name in site.drone_names:
        own, several = site.for_drone(name), len(site.drone_names) > 1
        body, pad = own.tracking.body, (*(own.drone.pad or room.home)[:2], 0.0)
        title, alias = (f"the drone {name}", name) if several else ("the drone", "drone")
        found.setdefault(body, Thing(body, title, ThingKind.ROBOT, (alias,), pad))
    if room.visitor is not None:
        found.setdefault(
            site.tracking.visitor,
            Thing(site.tracking.visitor, "the visitor", ThingKind.PERSON, ("visitor",)),
        )
    return tuple(found.values())


def catalogue_of(site: Site, room: Room, folder: Path) -> tuple[Thing, ...]:
    """Return the things of room, shipped scene and catalogue; of one id the catalogue's counts.

    Raises ConfigError for a bad catalogue.
    """
    own = load_catalogue(folder / site.hub.things) if site.hub.things else ()
    known = {thing.id for thing in own}
    played = things_of_scene(site.twin.scene) if site.twin.enabled else ()
    return (*things_of(site, room), *(one for one in played if one.id not in known), *own)


def things_of_scene(scene: str) -> tuple[Thing, ...]:
    """Return the things that a shipped scene brings; none for a file, which has no names."""
    shipped = Path(sites.__file__).parent / f"{scene}_things.toml"
    return load_catalogue(shipped) if scene and shipped.is_file() else ()


def surfaces_of(room: Room) -> tuple[Surface, ...]:
    """Return the tops of furniture on which a thing can be left, where the room has them."""
    seats = {solid.thing for solid in room.solids if _SEAT_WORDS & set(solid.name.split())}
    return tuple(
        Surface(
            _id(solid.thing),
            solid.thing,
            solid.position[:2],
            (solid.size[0] / 2, solid.size[1] / 2),
            _top(solid),
            solid.yaw,
            solid.shape is Shape.CYLINDER,
            solid.thing in seats,
        )
        for solid in room.solids
        if solid.collides
        and not _is_building(solid.thing)
        and min(solid.size[:2]) >= _NARROWEST_TOP
        and _LOWEST_TOP <= _top(solid) <= _HIGHEST_TOP
    )


def furniture_id(piece: FurnitureConfig) -> str:
    """Return the id of a tracked piece of furniture."""
    return _id(piece.model or piece.name)


def place_id(place: Place) -> str:
    """Return the id of a place."""
    return _id(f"place {place.name}")


def _furniture(room: Room) -> Iterator[Thing]:
    parts: dict[str, list[Solid]] = {}
    for solid in room.solids:
        parts.setdefault(solid.thing, []).append(solid)
    for name, solids in parts.items():
        slug = _id(name)
        middle = _middle(solids)
        yaw = solids[0].yaw
        kind = ThingKind.STRUCTURE if _is_building(name) else ThingKind.FURNITURE
        yield Thing(slug, name, kind, (), middle, quaternion_from_euler(0.0, 0.0, yaw))


def _is_building(name: str) -> bool:
    return any(word in name for word in _BUILDING_WORDS) and not any(
        word in name for word in _SHELF_WORDS
    )


def _top(solid: Solid) -> float:
    return solid.position[2] + solid.size[2] / 2


def _places(room: Room, height: float) -> Iterator[Thing]:
    for place in room.places:
        x, y = place.viewpoint
        look_x, look_y, _ = place.look_at
        view = NamedPose("hover", (x, y, height), atan2(look_y - y, look_x - x))
        title = place.title or place.name
        yield Thing(
            place_id(place),
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
