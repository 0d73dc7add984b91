"""Reads a ROS map (image and yaml) into occupied, free and unknown pixels in world axes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import yaml
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from housefly.config.text import read_text_file, shortened
from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.room.reach import Mask

_MAX_SIDE = 4096
"""Longest side of an image that is read [px]."""
_NUMBER_MAX = 1e9
"""Largest number that a key may have; what is larger, or not finite, is none."""
_TEXT_MAX = 64 * 1024
"""Longest yaml that is read [characters]; a real one has about 150."""
_DEPTH_MAX = 8
_BRACKETS_MAX = 40
"""With a thousand of them nested the yaml library needs minutes."""
_MODES = ("trinary",)


@dataclass(frozen=True, slots=True, eq=False)
class RosMap:
    """A map as ROS's map server stores it.

    Attributes:
        origin: world position of the lower left corner [m].
        resolution: edge of a pixel [m].
        occupied: shape (nx, ny), x to the right of the picture, y to its top.
        free: likewise; a pixel that is neither is unknown.
    """

    origin: Vec2
    resolution: float
    occupied: Mask
    free: Mask


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


def read_ros_map(yaml_path: Path) -> RosMap:
    """Read ``map.yaml`` and the picture that it names.

    Raises:
        RoomError: saying which key or file is bad and what would be right.
    """
    tree = _tree(yaml_path)
    resolution = _number(tree, "resolution", 0.005, 1.0, "m per pixel", yaml_path)
    origin = tree.get("origin")
    if not (isinstance(origin, list) and len(origin) == 3 and all(_is_number(v) for v in origin)):
        raise RoomError(
            f"{yaml_path}: origin is {_shown(origin)}; allowed: a list x, y, yaw of three numbers"
            " [m, m, rad]"
        )
    if abs(origin[2]) > 1e-6:
        raise RoomError(
            f"{yaml_path}: origin has yaw {origin[2]} rad; only 0 can be imported: turn the picture"
            " and set yaw to 0"
        )
    mode = tree.get("mode", "trinary")
    if mode not in _MODES:
        raise RoomError(
            f"{yaml_path}: mode is {_shown(mode)}; allowed: {', '.join(_MODES)} (save the map again"
            " in that mode)"
        )
    occupied_from = _number(tree, "occupied_thresh", 0.0, 1.0, "", yaml_path)
    free_to = _number(tree, "free_thresh", 0.0, 1.0, "", yaml_path)
    if free_to >= occupied_from:
        raise RoomError(
            f"{yaml_path}: free_thresh ({free_to}) must be below occupied_thresh ({occupied_from})"
        )
    image = tree.get("image")
    if not isinstance(image, str) or not image:
        raise RoomError(
            f"{yaml_path}: image is {_shown(image)}; allowed: the name of a pgm or png file beside"
            " the yaml"
        )
    grey, known = _picture(yaml_path.parent / image)
    darkness = grey if tree.get("negate", 0) in (1, True) else 1.0 - grey
    return RosMap(
        (float(origin[0]), float(origin[1])),
        resolution,
        _turned((darkness > occupied_from) & known),
        _turned((darkness < free_to) & known),
    )


def _turned(rows: Mask) -> Mask:
    """Return picture rows (top first) as cells (x, y)."""
    return np.ascontiguousarray(rows[::-1].T)


def _tree(path: Path) -> dict[str, Any]:
    try:
        text = read_text_file(path)
        if len(text) > _TEXT_MAX or text.count("[") + text.count("{") > _BRACKETS_MAX:
            raise RoomError(
                f"{path} is no map's yaml: allowed are {_TEXT_MAX} characters, and"
                f" {_BRACKETS_MAX} brackets"
            )
        tree = yaml.load(text, _PlainLoader)
    except (OSError, UnicodeDecodeError) as error:
        raise RoomError(f"{path} cannot be read: {error}; give the map's yaml file") from error
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise RoomError(f"{path} is not a yaml file: {error}") from error
    if not isinstance(tree, dict):
        raise RoomError(
            f"{path} is not a map's yaml file: it has no keys image, resolution, origin"
        )
    return tree


def _is_number(value: Any) -> bool:
    return (
        isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= _NUMBER_MAX
    )


def _shown(value: Any) -> str:
    return shortened(repr(value), 80)


def _number(
    tree: dict[str, Any], key: str, low: float, high: float, unit: str, path: Path
) -> float:
    value = tree.get(key)
    if not _is_number(value) or not low <= float(value) <= high:  # type: ignore[arg-type]
        raise RoomError(
            f"{path}: {key} is {_shown(value)}; allowed: a number from {low:g} to"
            f" {high:g} {unit}".rstrip()
        )
    return float(value)  # type: ignore[arg-type]


def _picture(path: Path) -> tuple[NDArray[np.float64], Mask]:
    """Return brightness from 0 to 1 and which pixels are opaque, rows from the top."""
    try:
        if path.exists() and not path.is_file():
            raise OSError("no ordinary file")
        with Image.open(path) as image:
            if max(image.size) > _MAX_SIDE:
                raise RoomError(
                    f"{path} is {image.size[0]} x {image.size[1]} pixels; at most {_MAX_SIDE} a"
                    " side can be imported"
                )
            pixels = np.asarray(image.convert("LA"), dtype=np.float64) / 255.0
    except (OSError, UnidentifiedImageError, ValueError, Image.DecompressionBombError) as error:
        raise RoomError(
            f"the map's picture {path} cannot be read: {error}; allowed: pgm or png"
        ) from error
    return pixels[:, :, 0], pixels[:, :, 1] > 0.5
