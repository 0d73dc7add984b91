"""Rooms as files: ``room.toml`` read with every value checked, and written.

Lengths in metres, angles in radians, colours from 0 to 1; a solid is one line.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from math import sqrt
from pathlib import Path
from typing import Annotated, Any, Self

from pydantic import Field, ValidationError, model_validator

from housefly.config.rectangle import check_floor
from housefly.config.section import Section
from housefly.config.text import read_text_file
from housefly.config.toml import parse_toml
from housefly.config.validation import dotted, explain
from housefly.errors import ConfigError, RoomError
from housefly.geometry import Quaternion, normalized
from housefly.numeric import running_sum
from housefly.room.bsen import bsen
from housefly.room.model import Place, Room, Shape, Solid, TrackingCamera

_BUILT_IN_ROOMS = {"bsen": bsen}
_FILE_NAME = "room.toml"
_UNITS: dict[int | str, str] = {
    **dict.fromkeys(
        (
            "bounds",
            "height",
            "home",
            "visitor",
            "position",
            "size",
            "viewpoint",
            "look_at",
            "reach",
        ),
        "m",
    ),
    **dict.fromkeys(("home_yaw", "visitor_yaw", "yaw", "field_of_view"), "rad"),
}

_Coordinate = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
_Extent = Annotated[float, Field(gt=0.0, le=1000.0, allow_inf_nan=False)]
_Angle = Annotated[float, Field(ge=-6.3, le=6.3, allow_inf_nan=False)]
_Fraction = Annotated[float, Field(ge=0.0, le=1.0, allow_inf_nan=False)]
_Name = Annotated[str, Field(min_length=1, max_length=80)]


class _SolidEntry(Section):
    """One solid of ``room.toml``."""

    name: _Name
    thing: _Name
    shape: Shape = Shape.BOX
    position: tuple[_Coordinate, _Coordinate, _Coordinate]
    size: tuple[_Extent, _Extent, _Extent]
    yaw: _Angle = 0.0
    colour: tuple[_Fraction, _Fraction, _Fraction, _Fraction] = (0.7, 0.7, 0.7, 1.0)
    collides: bool = True
    texture: str = Field(default="", max_length=40)


class _PlaceEntry(Section):
    """One place of ``room.toml``."""

    name: str = Field(pattern=r"^[a-z0-9][a-z0-9 _-]{0,39}$")
    viewpoint: tuple[_Coordinate, _Coordinate]
    look_at: tuple[_Coordinate, _Coordinate, _Coordinate]
    title: str = Field(default="", max_length=60)


class _CameraEntry(Section):
    """One tracking camera of ``room.toml``."""

    name: _Name
    position: tuple[_Coordinate, _Coordinate, _Coordinate]
    orientation: tuple[_Coordinate, _Coordinate, _Coordinate, _Coordinate]
    field_of_view: tuple[
        Annotated[float, Field(gt=0.0, lt=3.1, allow_inf_nan=False)],
        Annotated[float, Field(gt=0.0, lt=3.1, allow_inf_nan=False)],
    ]
    reach: _Extent = 12.0


class _RoomEntry(Section):
    """The whole of ``room.toml``."""

    name: str = Field(min_length=1, max_length=60)
    bounds: tuple[_Coordinate, _Coordinate, _Coordinate, _Coordinate]
    height: Annotated[float, Field(ge=1.0, le=100.0, allow_inf_nan=False)]
    home: tuple[_Coordinate, _Coordinate]
    home_yaw: _Angle = 0.0
    visitor: tuple[_Coordinate, _Coordinate] | None = None
    visitor_yaw: _Angle = 0.0
    solids: tuple[_SolidEntry, ...] = ()
    places: tuple[_PlaceEntry, ...]
    cameras: tuple[_CameraEntry, ...] = ()

    @model_validator(mode="after")
    def _combinations(self) -> Self:
        x_min, y_min, x_max, y_max = self.bounds
        if not (x_min < x_max and y_min < y_max):
            raise ValueError(
                "bounds are x_min, y_min, x_max, y_max [m] with x_min < x_max and y_min < y_max"
            )
        check_floor(self.bounds)
        if not (x_min <= self.home[0] <= x_max and y_min <= self.home[1] <= y_max):
            raise ValueError(f"home {self.home} m must lie within bounds {self.bounds} m")
        if "home" not in {place.name for place in self.places}:
            raise ValueError('places must contain one called "home"')
        for kind, names in (
            ("solids", [s.name for s in self.solids]),
            ("places", [p.name for p in self.places]),
        ):
            twice = (
                sorted({name for name in names if names.count(name) > 1})
                if len(set(names)) < len(names)
                else []
            )
            if twice:
                raise ValueError(f"names of {kind} must differ; used twice: {twice[0]!r}")
        return self


def load_room(model: str, base: Path | None = None) -> Room:
    """Return a built-in room by name, or the room of a directory that holds ``room.toml``.

    Args:
        model: "bsen", or the path of a directory, relative to ``base``.
        base: directory of the site file.

    Raises:
        RoomError: there is no such room.
        ConfigError: a value of ``room.toml`` is bad; names the key and what is allowed.
    """
    if model in _BUILT_IN_ROOMS:
        return _BUILT_IN_ROOMS[model]()
    path = (base or Path()) / model / _FILE_NAME
    try:
        text = read_text_file(path)
    except (OSError, UnicodeDecodeError) as error:
        known = ", ".join(sorted(_BUILT_IN_ROOMS))
        raise RoomError(
            f"room.model {model!r} is neither a built-in room ({known}) nor a directory with a"
            f" readable {_FILE_NAME}: {error}"
        ) from error
    return room_from_toml(text, str(path))


def room_from_toml(text: str, source: str = "") -> Room:
    """Return the room of a ``room.toml``; raises ConfigError for the first bad value."""
    tree = parse_toml(text, _FILE_NAME, source, "is not valid TOML")
    try:
        entry = _RoomEntry.model_validate(tree)
    except ValidationError as error:
        # A misspelt key also leaves the right one missing: name the misspelt one.
        first = min(error.errors(), key=lambda problem: problem["type"] != "extra_forbidden")
        key = dotted(first["loc"]) or _FILE_NAME
        raise ConfigError(key, explain(first, units=_UNITS), source) from error
    return Room(
        name=entry.name,
        bounds=entry.bounds,
        height=entry.height,
        solids=tuple(Solid(**dict(solid)) for solid in entry.solids),
        places=tuple(Place(**dict(place)) for place in entry.places),
        cameras=tuple(_camera(n, camera, source) for n, camera in enumerate(entry.cameras)),
        home=entry.home,
        home_yaw=entry.home_yaw,
        visitor=entry.visitor,
        visitor_yaw=entry.visitor_yaw,
    )


def room_to_toml(room: Room) -> str:
    """Return the text of a ``room.toml``; ``room_from_toml`` makes the same room of it."""
    return "\n".join(_lines(room)) + "\n"


def save_room(room: Room, directory: Path) -> Path:
    """Write ``room.toml`` into a directory and return its path; raises RoomError on failure."""
    path = directory / _FILE_NAME
    try:
        directory.mkdir(parents=True, exist_ok=True)
        path.write_text(room_to_toml(room), encoding="utf-8")
    except OSError as error:
        raise RoomError(f"{path} cannot be written: {error.strerror}") from error
    return path


def _lines(room: Room) -> Iterator[str]:
    yield (
        "# A room for Housefly. Metres, radians; sizes are full extents; colours are red, green,"
        " blue, alpha from 0 to 1."
    )
    for key in ("name", "bounds", "height", "home", "home_yaw", "visitor", "visitor_yaw"):
        value = getattr(room, key)
        if value is not None:
            yield f"{key} = {_toml(value)}"
    for key, entries in (
        ("places", room.places),
        ("cameras", room.cameras),
        ("solids", room.solids),
    ):
        yield f"{key} = ["
        for entry in entries:
            fields = ", ".join(
                f"{name} = {_toml(getattr(entry, name))}"
                for name in type(entry).__dataclass_fields__
            )
            yield f"  {{ {fields} }},"
        yield "]"


def _toml(value: Any) -> str:
    if isinstance(value, Shape):
        return json.dumps(value.value)
    if isinstance(value, tuple):
        return "[" + ", ".join(_toml(item) for item in value) + "]"
    if isinstance(value, float):
        return repr(value)
    return toml_string(value) if isinstance(value, str) else json.dumps(value)


def toml_string(text: str) -> str:
    """Return a TOML string; JSON's escapes are TOML's, except for the delete character."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _camera(number: int, entry: _CameraEntry, source: str) -> TrackingCamera:
    fields = dict(entry)
    fields["orientation"] = _unit(entry.orientation, f"cameras.{number}.orientation", source)
    return TrackingCamera(**fields)


def _unit(q: Quaternion, key: str, source: str) -> Quaternion:
    length = sqrt(running_sum(part * part for part in q))
    if abs(length - 1.0) > 0.01:
        raise ConfigError(
            key,
            f"is {q!r}; allowed: a unit quaternion w, x, y, z (its length is {length:.3g})",
            source,
        )
    return q if abs(length - 1.0) < 1e-9 else normalized(q)
