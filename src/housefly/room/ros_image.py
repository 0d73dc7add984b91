"""Reads a ROS map (image and yaml) into occupied, free and unknown pixels in world axes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.messages.words import Words, figure
from housefly.room.reach import Mask
from housefly.room.ros_yaml import RosMapFile, RosMapMode, read_ros_yaml

MAP_SIDE_MAX = 4096
"""Longest side of a map that is read [px]."""
_DEPTH_16 = 65535
_UNSEEN = 50 / 255
"""Darkness of grey 205, which map_saver writes for what was never seen."""
_SPIKE = 4.0
"""Grey 205 stands for that when it is so many times as frequent as the greys beside it."""


@dataclass(frozen=True, slots=True, eq=False)
class RosMap:
    """A map as ROS's map server stores it.

    Attributes:
        origin: world position of the lower left corner [m].
        resolution: edge of a pixel [m].
        occupied: shape (nx, ny), x to the right of the picture, y to its top.
        free: likewise; a pixel that is neither is unknown.
        notes: what was read although it is unusual, a sentence each.
    """

    origin: Vec2
    resolution: float
    occupied: Mask
    free: Mask
    notes: tuple[Words, ...] = ()


def read_ros_map(yaml_path: Path) -> RosMap:
    """Read ``map.yaml`` and the picture that it names.

    Occupancy is as in map_server, but for one thing: in mode trinary grey 205 is unknown whatever
    free_thresh says. map_saver writes it for what was never seen, and nav2's usual 0.25 would call
    it free.

    Raises:
        RoomError: saying which key or file is bad and what would be right.
    """
    described = read_ros_yaml(yaml_path)
    grey, is_known = _picture(described.picture)
    occupancy = grey if described.negate else 1.0 - grey
    occupied_from, free_to, notes = described.occupied_from, described.free_to, described.notes
    if described.mode is RosMapMode.RAW:
        # The grey is the percentage itself; beyond 100 it is unknown.
        occupancy = np.round(grey * 255.0) / 100.0
        is_known = is_known & (occupancy <= 1.0)
        occupied, free = occupancy >= occupied_from, occupancy <= free_to
    else:
        occupied, free = occupancy > occupied_from, occupancy < free_to
    unseen = _unseen(occupancy, described)
    if (free & unseen).any():
        free = free & ~unseen
        notes += (
            Words(
                "grey 205 counts as never seen, although free_thresh ({a}) calls it free:"
                " map_saver writes it for that",
                a=figure(free_to, "g"),
            ),
        )
    return RosMap(
        described.origin,
        described.resolution,
        _turned(occupied & is_known),
        _turned(free & is_known),
        notes,
    )


def _unseen(occupancy: NDArray[np.float64], described: RosMapFile) -> Mask:
    """Return where the picture has the grey that stands for never seen.

    In a picture with all greys, such as a map of probabilities, it is one grey of many.
    """
    near = np.rint((occupancy - _UNSEEN) * 255.0)
    unseen = np.asarray(near == 0.0, dtype=np.bool_)
    beside = np.count_nonzero(np.abs(near) <= 2.0) - np.count_nonzero(unseen)
    stands_out = np.count_nonzero(unseen) > _SPIKE * beside
    if described.mode is RosMapMode.TRINARY and stands_out:
        return unseen
    return np.zeros_like(unseen)


def _turned(rows: Mask) -> Mask:
    """Return picture rows (top first) as cells (x, y)."""
    return np.ascontiguousarray(rows[::-1].T)


def _picture(path: Path) -> tuple[NDArray[np.float64], Mask]:
    """Return brightness from 0 to 1 and which pixels are opaque, rows from the top."""
    try:
        if path.exists() and not path.is_file():
            raise OSError("no ordinary file")
        with Image.open(path) as image:
            if max(image.size) > MAP_SIDE_MAX:
                raise RoomError(
                    Words(
                        "{name} is {n} x {m} pixels; at most {p} a side can be imported",
                        name=str(path),
                        n=figure(image.size[0]),
                        m=figure(image.size[1]),
                        p=figure(MAP_SIDE_MAX),
                    )
                )
            return _brightness(image, path)
    except (OSError, UnidentifiedImageError, ValueError, Image.DecompressionBombError) as error:
        raise RoomError(
            Words(
                "the map's picture {name} cannot be read: {why}; allowed: pgm or png",
                name=str(path),
                why=str(error),
            )
        ) from error


def _brightness(image: Image.Image, path: Path) -> tuple[NDArray[np.float64], Mask]:
    if image.mode.startswith("I"):  # one channel of 16 bits
        deep = np.asarray(image, dtype=np.float64)
        if deep.min(initial=0) < 0 or deep.max(initial=0) > _DEPTH_16:
            raise RoomError(
                Words(
                    "{name} has more than 16 bits a pixel; save it as png or pgm with 8",
                    name=str(path),
                )
            )
        return deep / _DEPTH_16, np.ones(deep.shape, dtype=np.bool_)
    if image.mode == "F":
        raise RoomError(
            Words(
                "{name} has decimals for pixels; save it as png or pgm with 8 bits each",
                name=str(path),
            )
        )
    pixels = np.asarray(image.convert("RGBA"))
    # As map_server does: the mean of the colours, not what an eye takes for bright.
    return pixels[:, :, :3].mean(axis=2) / 255.0, pixels[:, :, 3] > 127
