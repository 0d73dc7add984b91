"""Turns a ROS map into a room: occupied pixels become walls; home and places go where space is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.messages.words import Words, figure, percentage
from housefly.room.files import save_room, toml_string
from housefly.room.grid import build_grid
from housefly.room.home_pad import home_pad
from housefly.room.model import Colour, Place, Room, Shape, Solid
from housefly.room.reach import Mask
from housefly.room.rectangles import rectangles
from housefly.room.ros_image import RosMap, read_ros_map
from housefly.room.spots import (
    LOOK_DISTANCE,
    ClearanceProfile,
    places_around,
    profile_and_home,
    site_for,
)

_WALL_HEIGHT = 2.5
_WALL_COLOUR: Colour = (0.86, 0.83, 0.77, 1.0)
_UNEXPLORED_COLOUR: Colour = (0.60, 0.63, 0.66, 1.0)
_UNEXPLORED = "unexplored"
_MAX_SOLIDS = 20_000
_MAX_AREA = 40_000.0
"""Largest room [m^2]."""


def import_ros_map(
    yaml_path: Path,
    out: Path,
    *,
    name: str = "",
    wall_height: float = _WALL_HEIGHT,
    unexplored_is_free: bool = False,
    tell: Callable[[str], object] | None = None,
) -> Room:
    """Make a room of a ROS map and write ``room.toml`` and ``site.toml`` into a directory.

    Unknown pixels beside free ones become walls of their own kind ("unexplored"): what nobody saw
    may hold anything. A room made of a map has no tracking cameras, so that tracking sees
    everywhere. The whole room is moved so that it begins at (0, 0).

    Args:
        yaml_path: the map's yaml file.
        out: the directory to write; made when absent.
        name: of the room; the map's folder when empty.
        wall_height: how high the walls are [m].
        unexplored_is_free: whether floor that was never seen may be flown over; the pad never lies
            there.
        tell: is told what was found and assumed, a sentence each.

    Raises:
        RoomError: the map cannot be read, or the drone fits nowhere in it.
    """
    ros_map, _ = cropped(read_ros_map(yaml_path), yaml_path)
    title = name or yaml_path.resolve().parent.name.replace("_", " ") or "map"
    walls = _walls(ros_map, wall_height)
    shell = Room(title[:60], _bounds(ros_map), wall_height, walls, (), (), (0.0, 0.0))
    manner, home = profile_and_home(shell, ros_map, yaml_path)
    if unexplored_is_free:
        shell = replace(shell, solids=tuple(wall for wall in walls if wall.thing != _UNEXPLORED))
    site = site_for(manner)
    grid = build_grid(replace(shell, home=home), site)
    places = (
        Place("home", home, (home[0] + LOOK_DISTANCE, home[1], site.map.flight_height), "Home"),
        *places_around(grid, home),
    )
    room = replace(shell, solids=(*shell.solids, *home_pad(home)), places=places, home=home)
    if tell is not None:
        for note in ros_map.notes:
            tell(note)
    save_room(room, out)
    _write_site(out / "site.toml", room, manner, yaml_path)
    return room


def cropped(ros_map: RosMap, source: Path | str) -> tuple[RosMap, Vec2]:
    """Return the part with free pixels and a border, moved to (0, 0), and where that was [m].

    Its notes say how much of it was never seen.
    """
    columns, rows = (
        np.flatnonzero(ros_map.free.any(axis=1)),
        np.flatnonzero(ros_map.free.any(axis=0)),
    )
    if columns.size == 0:
        raise RoomError(
            Words(
                "{name}: the map has no free pixel; check negate (0 or 1) and free_thresh",
                name=str(source),
            )
        )
    part = slice(max(columns[0] - 2, 0), columns[-1] + 3), slice(max(rows[0] - 2, 0), rows[-1] + 3)
    note = unexplored_note(ros_map.occupied[part] | ros_map.free[part], ros_map.resolution)
    occupied, free = np.pad(ros_map.occupied[part], 1), np.pad(ros_map.free[part], 1)
    if occupied.size * ros_map.resolution**2 > _MAX_AREA:
        raise RoomError(
            Words(
                "{name}: the map covers more than {a} m^2; cut out the part to fly in",
                name=str(source),
                a=figure(_MAX_AREA, ".0f"),
            )
        )
    edge, (x, y) = ros_map.resolution, ros_map.origin
    corner = x + (part[0].start - 1) * edge, y + (part[1].start - 1) * edge
    return RosMap((0.0, 0.0), edge, occupied, free, (*ros_map.notes, note)), corner


def unexplored_note(seen: Mask, edge: float) -> Words:
    """Return how much of a floor was never seen; ``edge`` of a cell [m]."""
    return Words(
        "{a} % of its {b} m^2 were never seen: unexplored, not flown over (unexplored=free changes"
        " that)",
        a=percentage(1.0 - float(seen.mean())),
        b=figure(seen.size * edge**2, ".1f"),
    )


def _bounds(ros_map: RosMap) -> tuple[float, float, float, float]:
    nx, ny = ros_map.free.shape
    return 0.0, 0.0, round(nx * ros_map.resolution, 6), round(ny * ros_map.resolution, 6)


def _walls(ros_map: RosMap, height: float) -> tuple[Solid, ...]:
    unknown = ~ros_map.occupied & ~ros_map.free
    solids = (
        *_extruded("wall", ros_map.occupied, ros_map.resolution, height, _WALL_COLOUR),
        *_extruded(
            _UNEXPLORED,
            unknown & _beside(ros_map.free),
            ros_map.resolution,
            height,
            _UNEXPLORED_COLOUR,
        ),
    )
    if len(solids) > _MAX_SOLIDS:
        raise RoomError(
            f"the map needs {len(solids)} boxes, at most {_MAX_SOLIDS} are supported; clean it of"
            " single pixels"
        )
    return solids


def _beside(mask: Mask) -> Mask:
    """Return the mask grown by one pixel to all eight sides."""
    padded = np.pad(mask, 1)
    nx, ny = mask.shape
    grown = np.zeros_like(mask)
    for dx in range(3):
        for dy in range(3):
            grown |= padded[dx : dx + nx, dy : dy + ny]
    return grown


def _extruded(
    thing: str, mask: Mask, edge: float, height: float, colour: Colour
) -> tuple[Solid, ...]:
    return tuple(
        Solid(
            name=f"{thing} {n}",
            thing=thing,
            shape=Shape.BOX,
            position=(round((i0 + i1) / 2 * edge, 6), round((j0 + j1) / 2 * edge, 6), height / 2),
            size=(round((i1 - i0) * edge, 6), round((j1 - j0) * edge, 6), height),
            colour=colour,
            texture="wall",
        )
        for n, (i0, j0, i1, j1) in enumerate(rectangles(mask))
    )


def _write_site(path: Path, room: Room, manner: ClearanceProfile, source: Path) -> None:
    text = _SITE_TEXT.format(name=toml_string(room.name), source=source.name, manner=manner)
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise RoomError(f"{path} cannot be written: {error.strerror}") from error


_SITE_TEXT = """\
# A room made of the ROS map {source}. Every key and its range: docs/site.md.

name = {name}
mode = "default"

[room]
model = "."             # the room.toml beside this file

[map]
flight_height = 1.1     # a ROS map is flat: its walls reach from the floor to the ceiling
# {manner.remark}
resolution = {manner.resolution}
tracking_bound = {manner.tracking_bound}
margin = {manner.margin}

[limits]
speed = {manner.speed}

[twin]
enabled = true
visitor_present = false
"""
