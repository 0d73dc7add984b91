"""What the solids of the simulated room are: which geom belongs to the walls, a chair, a person."""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any

from housefly.room.model import BUILDING_PARTS, Room
from housefly.twin.movable import MOVABLE_PREFIX
from housefly.twin.people.bodies import PERSON_PREFIX
from housefly.twin.scene_mjcf import CEILING

_VISITOR = "visitor"
_ROOM_PARTS = BUILDING_PARTS | {"partition"}


class SolidKind(Enum):
    """What a drone can touch."""

    ROOM = "room"
    CEILING = "ceiling"
    FURNITURE = "furniture"
    MOVABLE = "movable"
    PERSON = "person"
    DRONE = "drone"


@dataclass(frozen=True, slots=True)
class SolidOwner:
    """Whom a geom belongs to.

    Attributes:
        kind: wall, furniture, person and so on.
        name: of the thing, the movable, the person, or the drone.
    """

    kind: SolidKind
    name: str


def owners_of_geoms(
    model: Any,
    room: Room,
    tracked: Container[str],
    floors: Container[int],
    drones: Mapping[str, str],
) -> tuple[SolidOwner | None, ...]:
    """Return whom each geom of a model belongs to, as one of its drones meets them.

    None for the floor, for that drone itself, and for what cannot be touched.

    Args:
        model: MuJoCo model of the scene.
        room: gives the things that the solids are parts of.
        tracked: names of movables that are furniture with markers.
        floors: geom ids of the floor.
        drones: names of the other drones, by those of their bodies.
    """
    things = {solid.name: solid.thing for solid in room.solids}
    return tuple(
        _owner(model, number, things, tracked, drones)
        if number not in floors and model.geom_contype[number]
        else None
        for number in range(model.ngeom)
    )


def _owner(
    model: Any,
    number: int,
    things: dict[str, str],
    tracked: Container[str],
    drones: Mapping[str, str],
) -> SolidOwner | None:
    geom, body = model.geom(number).name, model.body(model.geom_bodyid[number]).name
    if body in drones:
        return SolidOwner(SolidKind.DRONE, drones[body])
    if body.startswith(PERSON_PREFIX):
        return SolidOwner(SolidKind.PERSON, body.removeprefix(PERSON_PREFIX))
    if body == _VISITOR:
        return SolidOwner(SolidKind.PERSON, body)
    if body.startswith(MOVABLE_PREFIX):
        name = body.removeprefix(MOVABLE_PREFIX)
        kind = SolidKind.FURNITURE if name in tracked else SolidKind.MOVABLE
        return SolidOwner(kind, name)
    if geom == CEILING:
        return SolidOwner(SolidKind.CEILING, CEILING)
    if geom not in things:
        return None
    thing = things[geom]
    return SolidOwner(SolidKind.ROOM if thing in _ROOM_PARTS else SolidKind.FURNITURE, thing)
