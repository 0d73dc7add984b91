"""The catalogue of a site: ``things.toml``, checked, as things.

[[thing]]
id = "cup"
name = "the red cup"
kind = "object"
aliases = ["mug"]
inside = "cabinet"

[[thing]]
id = "cabinet"
name = "the cabinet"
kind = "furniture"
position = [2.0, 1.5, 0.9]   # m
yaw = 1.57                   # rad
viewpoints = [{ name = "front", position = [2.0, 0.5, 1.2], yaw = 1.57 }]
facts = { doors = 2 }
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from pydantic import Field

from housefly.config.section import Section
from housefly.config.text import read_text_file
from housefly.config.toml import parse_toml
from housefly.config.validation import Location, validated
from housefly.errors import ConfigError, ThingError
from housefly.geometry import quaternion_from_euler
from housefly.hub.things.thing import NamedPose, Thing, ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Fact

_Coordinate = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
_Angle = Annotated[float, Field(ge=-6.3, le=6.3, allow_inf_nan=False)]
_Point = tuple[_Coordinate, _Coordinate, _Coordinate]
_Id = Annotated[str, Field(pattern=r"^[a-z0-9][a-z0-9_.-]*$", max_length=80)]
_Name = Annotated[str, Field(min_length=1, max_length=200)]


class _ViewpointEntry(Section):
    """A named pose from which a robot reaches or sees the thing."""

    name: _Name
    position: _Point
    yaw: _Angle
    pitch: _Angle = 0.0
    robot: str = ""


class _ThingEntry(Section):
    """One thing of the file."""

    id: _Id
    name: str = ""
    kind: ThingKind = ThingKind.OBJECT
    aliases: tuple[_Name, ...] = ()
    position: _Point | None = None
    yaw: _Angle | None = None
    inside: str = ""
    viewpoints: tuple[_ViewpointEntry, ...] = ()
    facts: dict[str, Fact] = Field(default_factory=dict)


class _CatalogueFile(Section):
    """The whole file."""

    thing: tuple[_ThingEntry, ...] = ()


def load_catalogue(path: Path) -> tuple[Thing, ...]:
    """Read and check a file; raises ConfigError naming thing, key, value and what is allowed."""
    try:
        text = read_text_file(path)
    except (OSError, UnicodeDecodeError) as error:
        raise ConfigError("catalogue", f"cannot be read ({error})", str(path)) from error
    return catalogue_from_toml(text, str(path))


def catalogue_from_toml(text: str, source: str = "") -> tuple[Thing, ...]:
    """Return the things of a catalogue's text; raises ConfigError as ``load_catalogue`` does."""
    tree = parse_toml(text, "catalogue", source)
    entries = validated(_CatalogueFile, tree, "", source, _key).thing
    _check_ids(entries, source)
    things = tuple(_thing(entry) for entry in entries)
    try:
        WorldModel(things)
    except ThingError as error:
        raise ConfigError("thing.inside", str(error), source) from error
    return things


def _check_ids(entries: tuple[_ThingEntry, ...], source: str) -> None:
    known: set[str] = set()
    for number, entry in enumerate(entries, 1):
        if entry.id in known:
            raise ConfigError(
                f"thing {number}.id",
                f"is {entry.id!r}, as another thing's; every id is given once",
                source,
            )
        known.add(entry.id)
    for number, entry in enumerate(entries, 1):
        if entry.inside and entry.inside not in known:
            raise ConfigError(
                f"thing {number}.inside",
                f"is {entry.inside!r}; allowed: the id of a thing in this file",
                source,
            )


def _thing(entry: _ThingEntry) -> Thing:
    return Thing(
        id=entry.id,
        name=entry.name or entry.id,
        kind=entry.kind,
        aliases=entry.aliases,
        position=entry.position,
        orientation=None if entry.yaw is None else quaternion_from_euler(0.0, 0.0, entry.yaw),
        inside=entry.inside,
        viewpoints=tuple(
            NamedPose(v.name, v.position, v.yaw, v.pitch, v.robot) for v in entry.viewpoints
        ),
        facts=tuple(entry.facts.items()),
    )


def _key(location: Location) -> str:
    """Return a key as people count: ("thing", 0, "position", 2) is "thing 1.position 3"."""
    parts: list[str] = []
    for part in location:
        if isinstance(part, int) and parts:
            parts[-1] += f" {part + 1}"
        else:
            parts.append(str(part))
    return ".".join(parts)
