"""Places and no-fly zones that people edit: checked against the room, and applied.

Whoever reads a site gets them with it (``site.edits``): ``room_of`` applies the places,
``room.grid`` the zones. Mode ``paper`` flies the paper's own map and knows no edits.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import hypot
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from housefly.config.edits import NAME_MAX, Edits, NoFlyZone, PlaceEdit
from housefly.config.site import Site
from housefly.config.validation import explain
from housefly.errors import EditsError
from housefly.geometry import Vec2
from housefly.messages.words import Words, figure
from housefly.room.files import load_room
from housefly.room.grid import Cell, OccupancyGrid, build_grid, inflation
from housefly.room.home_pad import HOME_PAD_RADIUS, with_pads
from housefly.room.model import Place, Room
from housefly.room.reach import Mask, flood

_MIN_ZONE = 0.2
"""Shortest side of a zone [m]; never less than a grid cell, so that no zone misses all cells."""
_HOME = "home"
_MAX_SHOWN = 160
"""A refused value is quoted up to this many characters."""


def room_of(site: Site, base: Path | None = None) -> Room:
    """Return the room of a site with the pads of its drones and the places of its edits.

    Raises RoomError or ConfigError as ``load_room`` and ``with_pads``.
    """
    return with_places(with_pads(load_room(site.room.model, base), site), site)


def with_places(room: Room, site: Site) -> Room:
    """Return the room with the places changed by its site's edits."""
    if site.mode == "paper" or not (site.edits.places or site.edits.removed):
        return room
    changed = {
        edit.name: Place(edit.name, edit.viewpoint, edit.look_at, edit.title)
        for edit in site.edits.places
    }
    own = {place.name for place in room.places}
    kept = tuple(
        changed.get(place.name, place)
        for place in room.places
        if place.name not in site.edits.removed
    )
    return replace(
        room, places=(*kept, *(place for name, place in changed.items() if name not in own))
    )


def edits_from_tree(tree: Any) -> Edits:
    """Return edits from plain values; raises EditsError for the first bad one."""
    try:
        return Edits.model_validate(tree)
    except ValidationError as error:
        first = error.errors()[0]
        location = [str(part) for part in first["loc"]]
        words = "edits are places, removed and zones" if not location else explain(first, Edits)
        if location[-1:] == ["reason"] and first["type"] != "string_too_long":
            words = "say why: the reason is shown on the map"
        if location[-1:] == ["name"] and first["type"].startswith("string"):
            words = (
                f"is {first['input']!r}; allowed: 1 to {NAME_MAX} of a-z, 0-9, space, - and _, a"
                " letter or digit first"
            )
        where = f"{'.'.join(location)}: " if location else ""
        raise EditsError(
            where + (words if len(words) <= 2 * _MAX_SHOWN else f"{words[:_MAX_SHOWN]} ..."),
            ".".join(location[:2]),
        ) from error


def edited(room: Room, site: Site, edits: Edits) -> tuple[Room, Site]:
    """Return room and site with the edits applied.

    Args:
        room: the room as its file has it.
        site: its site; edits that it holds already are replaced.
        edits: what people want changed.

    Raises:
        EditsError: naming the item, what is allowed with its unit, and what would be cut off.
    """
    if site.mode == "paper" and edits != Edits():
        raise EditsError(
            "mode paper flies the paper's own map: places and zones can be edited in mode default"
            " only"
        )
    site = site.model_copy(update={"edits": edits})
    changed = with_places(room, site)
    _check_names(room, changed, edits)
    bare = build_grid(room, site.model_copy(update={"edits": Edits()}))
    reached = reached_from(bare, room.home)
    for number, edit in enumerate(edits.places):
        _check_place(edit, f"places.{number}", room, site, bare, reached)
    for number, zone in enumerate(edits.zones):
        _check_zone(zone, f"zones.{number}", room, bare.resolution)
    _check_ways(changed, site, bare, reached)
    return changed, site


def _check_names(room: Room, changed: Room, edits: Edits) -> None:
    own = {place.name: place for place in room.places}
    if _HOME in edits.removed:
        raise EditsError(
            "home cannot be removed: the drone starts and lands there",
            f"removed.{edits.removed.index(_HOME)}",
        )
    for number, name in enumerate(edits.removed):
        if name not in own:
            raise EditsError(
                f"no place called {name!r} to remove; the room has: {', '.join(own)}",
                f"removed.{number}",
            )
    names: set[str] = set()
    for number, edit in enumerate(edits.places):
        item = f"places.{number}"
        if edit.name == _HOME:
            raise EditsError("home cannot be changed: the pad stands where it stands", item)
        if edit.name in names:
            raise EditsError(f"two places are called {edit.name!r}: names must differ", item)
        if edit.name in edits.removed:
            raise EditsError(f"{edit.name!r} is removed and changed at once", item)
        if _shares_title(edit, changed):
            raise EditsError(
                f"two places are shown as {edit.title or edit.name!r}: choose another name", item
            )
        names.add(edit.name)


def _shares_title(edit: PlaceEdit, room: Room) -> bool:
    shown = (edit.title or edit.name).casefold()
    return any(
        place.name != edit.name and (place.title or place.name).casefold() == shown
        for place in room.places
    )


def _check_place(
    edit: PlaceEdit, item: str, room: Room, site: Site, bare: OccupancyGrid, reached: Mask
) -> None:
    shown, (x, y) = edit.title or edit.name, edit.viewpoint
    if not _within(room, x, y):
        raise EditsError(
            f"{shown}: ({x:.2f}, {y:.2f}) m is outside the room; allowed: {_bounds(room)}", item
        )
    look_x, look_y, look_z = edit.look_at
    if not (_within(room, look_x, look_y) and 0.0 <= look_z <= room.height):
        allowed = f"{_bounds(room)}, z from 0 to {room.height:.2f} m"
        raise EditsError(
            f"{shown}: ({look_x:.2f}, {look_y:.2f}, {look_z:.2f}) m cannot be looked at; allowed:"
            f" {allowed}",
            item,
        )
    if is_reached(reached, bare, edit.viewpoint):
        return
    why = blocked_words(bare, edit.viewpoint, site)
    raise EditsError(
        f"{shown}: the drone cannot hover at ({x:.2f}, {y:.2f}) m:"
        f" {why}{_instead(bare, reached, edit.viewpoint)}",
        item,
    )


def blocked_words(grid: OccupancyGrid, point: Vec2, site: Site) -> Words:
    """Return in words why the drone cannot be at a point [m] that is not reached from home."""
    match grid.kind(grid.cell_of(point)):
        case Cell.FREE:
            return Words("no way leads there from home")
        case Cell.VIRTUAL:
            return Words("the site file keeps it free by order")
        case Cell.OUTSIDE:
            return Words("it is behind a wall or inside something")
        case _:
            return Words(
                "the nearest obstacle is {a} m away and the drone keeps {b} m",
                a=figure(grid.clearance_at(point), ".2f"),
                b=figure(inflation(site), ".2f"),
            )


def _check_zone(zone: NoFlyZone, item: str, room: Room, resolution: float) -> None:
    x_min, y_min, x_max, y_max = zone.rectangle
    shown = f"zone {zone.reason!r}"
    if not (_within(room, x_min, y_min) and _within(room, x_max, y_max)):
        raise EditsError(f"{shown} is not inside the room; allowed: {_bounds(room)}", item)
    least = max(_MIN_ZONE, resolution)
    if min(x_max - x_min, y_max - y_min) < least - 1e-9:
        size = f"{x_max - x_min:.2f} m x {y_max - y_min:.2f} m"
        raise EditsError(
            f"{shown} is too small ({size}); allowed: sides of {least:.2f} m and more", item
        )
    home_x, home_y = room.home
    away = hypot(max(x_min - home_x, 0.0, home_x - x_max), max(y_min - home_y, 0.0, home_y - y_max))
    if away < HOME_PAD_RADIUS:
        raise EditsError(
            f"{shown} covers the home pad, where the drone starts and lands; allowed:"
            f" {HOME_PAD_RADIUS:.2f} m and more from ({home_x:.2f}, {home_y:.2f}) m",
            item,
        )


def _check_ways(changed: Room, site: Site, bare: OccupancyGrid, reached: Mask) -> None:
    """Refuse zones that cut off reachable places; the error names the first such zone."""
    counted = [place for place in changed.places if is_reached(reached, bare, place.viewpoint)]
    for number, grid in _grids(changed, site, counted):
        left = reached_from(grid, changed.home)
        lost = [place for place in counted if not is_reached(left, grid, place.viewpoint)]
        if lost:
            zone = site.edits.zones[number]
            names = ", ".join(place.title or place.name for place in lost)
            count = (
                "every place"
                if len(lost) == len(counted)
                else f"{len(lost)} of {len(counted)} places"
            )
            raise EditsError(
                f"zone {zone.reason!r} cuts off {count} from home: {names}; make it smaller, move"
                " it, or remove what it cuts off",
                f"zones.{number}",
            )


def _grids(room: Room, site: Site, places: list[Place]) -> Iterator[tuple[int, OccupancyGrid]]:
    """Yield the grid with the first zone, the first two, ...; nothing when no place is cut off."""
    zones = site.edits.zones
    if not zones or _all_reached(build_grid(room, site), room, places):
        return
    for count in range(1, len(zones) + 1):
        few = site.edits.model_copy(update={"zones": zones[:count]})
        yield count - 1, build_grid(room, site.model_copy(update={"edits": few}))


def _all_reached(grid: OccupancyGrid, room: Room, places: list[Place]) -> bool:
    reached = reached_from(grid, room.home)
    return all(is_reached(reached, grid, place.viewpoint) for place in places)


def reached_from(grid: OccupancyGrid, home: Vec2) -> Mask:
    """Return the free cells that a way leads to from home [m]; none when home is not free."""
    free = grid.cells == Cell.FREE
    cell = grid.cell_of(home)
    return (
        np.asarray(flood(free, *cell), dtype=np.bool_)
        if grid.contains(cell)
        else np.zeros_like(free)
    )


def is_reached(reached: Mask, grid: OccupancyGrid, point: Vec2) -> bool:
    """Return whether the cell of a point [m] is on the grid, and among those reached."""
    cell = grid.cell_of(point)
    return grid.contains(cell) and bool(reached[cell])


def _instead(grid: OccupancyGrid, reached: Mask, point: Vec2) -> str:
    cells = np.argwhere(reached)
    if cells.size == 0:
        return ""
    middles = np.array(grid.origin) + (cells + 0.5) * grid.resolution
    x, y = middles[int(((middles - np.array(point)) ** 2).sum(axis=1).argmin())]
    return f"; the nearest free point is ({x:.2f}, {y:.2f}) m"


def _within(room: Room, x: float, y: float) -> bool:
    x_min, y_min, x_max, y_max = room.bounds
    return x_min <= x <= x_max and y_min <= y <= y_max


def _bounds(room: Room) -> str:
    x_min, y_min, x_max, y_max = room.bounds
    return f"x from {x_min:.2f} to {x_max:.2f} m, y from {y_min:.2f} to {y_max:.2f} m"
