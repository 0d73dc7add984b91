"""The yaml file of a ROS map: where its picture is, and how greys become walls and floor."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Any

import yaml

from housefly.config.text import is_file, read_text_file, shortened
from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.messages.words import UNSAID, Words, figure

RESOLUTIONS = 0.005, 1.0
"""Edges that a pixel or cell may have [m]."""
_NUMBER_MAX = 1e9
"""Largest number that a key may have; what is larger, or not finite, is none."""
_TEXT_MAX = 64 * 1024
"""Longest yaml that is read [characters]; a real one has about 150."""
_DEPTH_MAX = 8
_BRACKETS_MAX = 40
"""With a thousand of them nested the yaml library needs minutes."""
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_YES_NO = {0: False, 1: True, "no": False, "yes": True, "false": False, "true": True}


_IS_MISSING = Words("is missing")


class RosMapMode(Enum):
    """How the map server stores occupancy: by two thresholds, or as the grey itself."""

    TRINARY = "trinary"
    SCALE = "scale"
    RAW = "raw"


@dataclass(frozen=True, slots=True)
class RosMapFile:
    """What the yaml says.

    Attributes:
        picture: the file of the picture.
        resolution: edge of a pixel [m].
        origin: world position of the lower left corner [m].
        mode: how occupancy is stored.
        negate: whether white is occupied.
        occupied_from, free_to: a pixel is occupied above the one, free below the other; 0 to 1.
        notes: what was read although it is unusual.
    """

    picture: Path
    resolution: float
    origin: Vec2
    mode: RosMapMode
    negate: bool
    occupied_from: float
    free_to: float
    notes: tuple[Words, ...]


def read_ros_yaml(path: Path) -> RosMapFile:
    """Read the yaml file of a map; raises RoomError for the first key that is bad."""
    keys = _Keys(_tree(path), path)
    resolution = keys.number("resolution", *RESOLUTIONS, Words("m per pixel"))
    origin = keys.origin()
    mode = keys.mode()
    occupied_from = keys.number("occupied_thresh", 0.0, 1.0)
    free_to = keys.number("free_thresh", 0.0, 1.0)
    if free_to >= occupied_from:
        raise RoomError(
            Words(
                "{name}: free_thresh ({a}) must be below occupied_thresh ({b})",
                name=str(path),
                a=figure(free_to),
                b=figure(occupied_from),
            )
        )
    negate, picture = keys.negate(), keys.picture()
    return RosMapFile(
        picture, resolution, origin, mode, negate, occupied_from, free_to, tuple(keys.notes)
    )


class _Keys:
    """The keys of one yaml file; what they are not is refused with key, value and what is allowed.

    Attributes:
        notes: of values that were read although they are unusual.
    """

    def __init__(self, tree: dict[str, Any], path: Path) -> None:
        self._tree, self._path = tree, path
        self.notes: list[Words] = []

    def number(self, key: str, low: float, high: float, unit: Words = UNSAID) -> float:
        value = self._plain(key, self._tree.get(key))
        if not _is_number(value) or not low <= value <= high:
            raise self._refusal(key, _range(low, high, unit))
        return float(value)

    def origin(self) -> Vec2:
        value = self._tree.get("origin")
        if isinstance(value, list):
            value = [self._plain("origin", part) for part in value]
        if not (isinstance(value, list) and len(value) == 3 and all(map(_is_number, value))):
            raise self._refusal("origin", Words("a list x, y, yaw of three numbers [m, m, rad]"))
        if abs(value[2]) > 1e-6:
            raise RoomError(
                Words(
                    "{name}: origin has yaw {a} rad; only 0 can be imported: turn the picture and"
                    " set yaw to 0",
                    name=str(self._path),
                    a=figure(value[2]),
                )
            )
        return float(value[0]), float(value[1])

    def mode(self) -> RosMapMode:
        value = self._tree.get("mode", "trinary")
        try:
            return RosMapMode(value.lower() if isinstance(value, str) else value)
        except ValueError:
            allowed = ", ".join(mode.value for mode in RosMapMode)
            raise self._refusal(
                "mode", Words("{names} (save the map again)", names=allowed)
            ) from None

    def negate(self) -> bool:
        value = self._plain("negate", self._tree.get("negate", 0))
        value = value.lower() if isinstance(value, str) else value
        if not isinstance(value, int | float | str) or value not in _YES_NO:
            raise self._refusal("negate", Words("0 or 1"))
        return _YES_NO[value]

    def picture(self) -> Path:
        value = self._tree.get("image")
        if not isinstance(value, str) or not value:
            raise self._refusal("image", Words("the name of a pgm or png file beside the yaml"))
        folder = self._path.parent
        beside = folder / re.split(r"[/\\]", value)[-1]
        if is_file(folder / value) or not is_file(beside):
            return folder / value
        self.notes.append(
            Words(
                "image is {thing}, which is not there: {name} beside the yaml was read",
                thing=_shown(value),
                name=beside.name,
            )
        )
        return beside

    def _plain(self, key: str, value: Any) -> Any:
        """Return a number that stands in quotes as a number."""
        if not isinstance(value, str) or not _NUMBER.fullmatch(value.strip()):
            return value
        number = float(value)
        self.notes.append(
            Words(
                "{name} has the text {thing}, read as the number {n}",
                name=key,
                thing=_shown(value),
                n=figure(number, "g"),
            )
        )
        return number

    def _refusal(self, key: str, allowed: Words) -> RoomError:
        return RoomError(
            Words(
                "{name}: {key} {found}; allowed: {words}",
                name=str(self._path),
                key=key,
                found=self._found(key),
                words=allowed,
            )
        )

    def _found(self, key: str) -> Words:
        value = self._tree.get(key)
        if isinstance(value, str):
            return Words("is the text {thing}", thing=_shown(value))
        return Words("is {thing}", thing=_shown(value)) if key in self._tree else _IS_MISSING


def _range(low: float, high: float, unit: Words) -> Words:
    a, b = figure(low, "g"), figure(high, "g")
    if not unit:
        return Words("a number from {a} to {b}", a=a, b=b)
    return Words("a number from {a} to {b} {unit}", a=a, b=b, unit=unit)


class _PlainLoader(yaml.SafeLoader):
    """Reads what maps are made of.

    With aliases a few lines would stand for gigabytes, and deep nesting takes the parser minutes.
    """

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self._depth = 0

    def compose_node(self, parent: Any, index: Any) -> Any:
        """Compose a node that is no alias and not nested deeply."""
        if self.check_event(yaml.AliasEvent):
            raise yaml.YAMLError("aliases (*name) are not read")
        if self._depth > _DEPTH_MAX:
            raise yaml.YAMLError(f"it is nested deeper than {_DEPTH_MAX} levels")
        self._depth += 1
        node = super().compose_node(parent, index)
        self._depth -= 1
        return node


def _tree(path: Path) -> dict[str, Any]:
    try:
        text = read_text_file(path)
        if len(text) > _TEXT_MAX or text.count("[") + text.count("{") > _BRACKETS_MAX:
            raise RoomError(
                Words(
                    "{name} is no map's yaml: allowed are {n} characters, and {m} brackets",
                    name=str(path),
                    n=figure(_TEXT_MAX),
                    m=figure(_BRACKETS_MAX),
                )
            )
        tree = yaml.load(text, _PlainLoader)
    except (OSError, UnicodeDecodeError) as error:
        raise RoomError(
            Words(
                "{name} cannot be read: {why}; give the map's yaml file",
                name=str(path),
                why=str(error),
            )
        ) from error
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise RoomError(
            Words("{name} is not a yaml file: {why}", name=str(path), why=str(error))
        ) from error
    if not isinstance(tree, dict):
        raise RoomError(
            Words(
                "{name} is not a map's yaml file: it has no keys image, resolution, origin",
                name=str(path),
            )
        )
    return tree


def _is_number(value: Any) -> bool:
    return (
        isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= _NUMBER_MAX
    )


def _shown(value: Any) -> str:
    return shortened(repr(value), 80)
