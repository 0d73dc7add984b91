"""The rooms that the gate flies in: B-sen, an imported house, and halls made for one question."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import replace
from enum import Enum
from pathlib import Path
from typing import Any

from housefly.config.site import changed
from housefly.errors import ConfigError
from housefly.geometry import Vec2
from housefly.room.grid import build_grid
from housefly.room.model import Place, Room, Shape, Solid
from housefly.room.ros_map import import_ros_map
from housefly.sites.loaded_site import LoadedSite, open_site, read_site

SMALL_HOUSE_MAP = (
    Path(__file__).resolve().parents[3] / "shared" / "data" / "rooms" / "small_house" / "map.yaml"
)
"""AWS RoboMaker's small house as a ROS map; it is not part of the repository."""
_WALL, _HEIGHT = 0.2, 2.5
_HALL: Vec2 = (10.0, 6.0)
DOOR_X, DOOR_WIDTH = 5.0, 0.8
POLES: tuple[Vec2, ...] = ((3.0, 2.2), (5.0, 3.8), (7.0, 2.2))
_POLE = 0.3
TABLE_HEIGHT = 0.75


class GateRoom(Enum):
    """Where a row is flown."""

    BSEN = "bsen"
    SMALL_HOUSE = "small_house"
    HALL = "hall"
    SLALOM = "slalom"
    DOOR = "door"
    TABLE = "table"


def is_there(room: GateRoom) -> bool:
    """Return whether a room can be flown in on this machine."""
    return room is not GateRoom.SMALL_HOUSE or SMALL_HOUSE_MAP.is_file()


def gate_site(room: GateRoom, number: int = 0, **changes: Any) -> LoadedSite:
    """Load a room of the gate with B-sen's drone and tracking.

    Args:
        room: which.
        number: of the hall with a door; it decides where the door is.
        changes: of the site's keys.

    Raises:
        ConfigError: a key or value that this tree does not know, or a map that is not here.
    """
    common = {"hub__enabled": False, "twin__visitor_present": False, "twin__video": False}
    if room is GateRoom.BSEN:
        return open_site(read_site("bsen", **(common | changes)))
    if room is GateRoom.SMALL_HOUSE:
        if not is_there(room):
            raise ConfigError("--rows", f"{SMALL_HOUSE_MAP} is not here: leave small_house out")
        with tempfile.TemporaryDirectory() as folder:
            import_ros_map(SMALL_HOUSE_MAP, Path(folder))
            return open_site(read_site(folder, **(common | changes)))
    hall = _HALLS[room](number)
    empty = {
        "map__virtual_obstacles": (),
        "map__paper_virtual_obstacles": (),
        "map__paper_rectangle": hall.bounds,
    }
    site = changed(read_site("bsen"), **(empty | common | changes))
    return LoadedSite(site, hall, build_grid(hall, site))


def _box(name: str, low: Vec2, high: Vec2, top: float = _HEIGHT, thing: str = "wall") -> Solid:
    (x0, y0), (x1, y1) = low, high
    middle = ((x0 + x1) / 2, (y0 + y1) / 2, top / 2)
    return Solid(name, thing, Shape.BOX, middle, (x1 - x0, y1 - y0, top))


def _hall(number: int = 0) -> Room:
    (x, y), w = _HALL, _WALL
    walls = (
        _box("south", (0.0, 0.0), (x, w)),
        _box("north", (0.0, y - w), (x, y)),
        _box("west", (0.0, 0.0), (w, y)),
        _box("east", (x - w, 0.0), (x, y)),
    )
    home = (1.2, y / 2)
    places = (Place("home", home, (x, y / 2, 1.1)),)
    return Room("hall", (0.0, 0.0, x, y), _HEIGHT, walls, places, (), home)


def _slalom(number: int) -> Room:
    hall = _hall()
    high = tuple(
        _box(f"wing {n}", (x - 0.1, 0.0 if y < 3.0 else y), (x + 0.1, y if y < 3.0 else 6.0))
        for n, (x, y) in enumerate(POLES)
    )
    poles = tuple(
        Solid(f"pole {n}", "pole", Shape.CYLINDER, (x, y, _HEIGHT / 2), (_POLE, _POLE, _HEIGHT))
        for n, (x, y) in enumerate(POLES)
    )
    return replace(hall, name="slalom", solids=(*hall.solids, *high, *poles))


def door_y(number: int) -> float:
    """Return where the middle of a numbered hall's door is [m]: spread evenly, off the lattice."""
    return 1.5 + 3.0 * ((0.5 + 0.618034 * number) % 1.0)


def _door(number: int) -> Room:
    hall, y, w = _hall(), door_y(number), _WALL / 2
    wall = (
        _box("door south", (DOOR_X - w, 0.0), (DOOR_X + w, y - DOOR_WIDTH / 2)),
        _box("door north", (DOOR_X - w, y + DOOR_WIDTH / 2), (DOOR_X + w, _HALL[1])),
    )
    return replace(hall, name="door", solids=(*hall.solids, *wall))


def _table(number: int) -> Room:
    hall = _hall()
    top = _box("table", (4.0, _WALL), (5.5, _HALL[1] - _WALL), TABLE_HEIGHT, "table")
    return replace(hall, name="table", solids=(*hall.solids, top))


_HALLS: dict[GateRoom, Callable[[int], Room]] = {
    GateRoom.HALL: lambda number: replace(_hall(), home=(_HALL[0] / 2, _HALL[1] / 2)),
    GateRoom.SLALOM: _slalom,
    GateRoom.DOOR: _door,
    GateRoom.TABLE: _table,
}
