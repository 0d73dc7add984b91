"""Names that a person would give: the entrance before the door, a place by its furniture."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import hypot

import numpy as np

from housefly.config.edits import NAME
from housefly.geometry import Vec2
from housefly.room.draft.model import DraftBox, DraftPlace, SiteDraft
from housefly.room.draft.shapes import ENTRANCE
from housefly.room.edits import reached_from
from housefly.room.grid import OccupancyGrid

BY_FURNITURE = 2.5
"""A place is called by furniture that is no farther away [m]."""
DOOR_DISTANCE = 1.6
"""The drone looks at who stands in a door from about so far [m]."""
_DOOR_SPACE = 1.0
"""Who comes in has so much space before the drone [m]."""
_FACE_HEIGHT = 1.35
_LOWEST = 0.3
"""Nobody calls a place by what is lower [m]."""
_NOT_NAMED = ("wall", "door", "window", "unexplored", "carpet", "ceiling")


def entrance_place(draft: SiteDraft, grid: OccupancyGrid, home: Vec2) -> Iterator[DraftPlace]:
    """Yield the place before the door; nothing where there is no door, or no way to it.

    Args:
        draft: what was said.
        grid: of its room.
        home: where the pad lies [m].
    """
    doors = [box for box in (*draft.furniture, *draft.scanned) if _is_door(box)]
    cells = np.argwhere(reached_from(grid, home))
    if not doors or not cells.size:
        return
    # "entrance door" before any other.
    door = min(doors, key=lambda box: ENTRANCE not in _called(box))
    spots = np.array(grid.origin) + (cells + 0.5) * grid.resolution
    away = np.hypot(spots[:, 0] - door.x, spots[:, 1] - door.y)
    off = np.where(away >= _DOOR_SPACE, np.abs(away - DOOR_DISTANCE), np.inf)
    best = int(off.argmin())
    if off[best] < DOOR_DISTANCE:
        x, y = np.round(spots[best], 3).tolist()
        yield DraftPlace(ENTRANCE, x, y, "Entrance", (door.x, door.y, _FACE_HEIGHT))


def named_by_furniture(places: Iterable[DraftPlace], draft: SiteDraft) -> Iterator[DraftPlace]:
    """Yield places; each that has furniture near it is called by that, and looks at it."""
    left = [box for box in draft.furniture if _names_a_place(box)]
    taken = {place.name for place in draft.places}
    for place in places:
        near = [box for box in left if _distance(place, box) <= BY_FURNITURE]
        box = min(near, key=lambda one: _distance(place, one), default=None)
        name = _called(box) if box is not None else ""
        if box is None or name in taken:
            yield place
            continue
        left.remove(box)
        taken.add(name)
        height = round(min(box.top, _FACE_HEIGHT), 3)
        named = replace(place, name=name, title=name[:1].upper() + name[1:])
        yield replace(named, look_at=(box.x, box.y, height))


def _distance(place: DraftPlace, box: DraftBox) -> float:
    return hypot(place.x - box.x, place.y - box.y)


def _called(box: DraftBox) -> str:
    return (box.thing or box.name).lower()


def _is_door(box: DraftBox) -> bool:
    return "door" in _called(box).split()


def _names_a_place(box: DraftBox) -> bool:
    name = _called(box)
    is_plain = re.fullmatch(NAME, name) is not None and len(name) <= 40
    is_furniture = not any(word in name.split() for word in _NOT_NAMED)
    return is_plain and is_furniture and box.top >= _LOWEST and name != "home"
