"""A site with its room and its map: what every process starts from."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from housefly import sites
from housefly.config import Site, changed, load_site
from housefly.errors import ConfigError
from housefly.room.files import load_room
from housefly.room.grid import OccupancyGrid, build_grid
from housefly.room.model import Room


@dataclass(frozen=True, slots=True)
class Premises:
    """A checked site, the room it names, and the occupancy grid of its mode."""

    site: Site
    room: Room
    grid: OccupancyGrid


def site_file(name: str) -> Path:
    """Return the path of a site: a file, a folder that holds ``site.toml``, or the name of a site shipped with Housefly.

    Raises:
        ConfigError: naming the sites that are shipped.
    """
    path = Path(name)
    if path.is_dir():
        path = path / "site.toml"
    if path.is_file():
        return path
    shipped = Path(sites.__file__).parent
    if (shipped / f"{name}.toml").is_file():
        return shipped / f"{name}.toml"
    known = ", ".join(sorted(p.stem for p in shipped.glob("*.toml") if not p.stem.endswith(("_scene", "_things"))))
    raise ConfigError("--site", f"no file {name!r}, and no site of that name is shipped (shipped: {known})")


def read_site(name: str, **changes: Any) -> Site:
    """Read a site and apply dotted changes (``twin__seed=3``); paths of room, scene and catalogue become absolute."""
    path = site_file(name)
    site = load_site(path)
    model = site.room.model
    if (path.parent / model / "room.toml").is_file():
        changes.setdefault("room__model", str((path.parent / model).resolve()))
    if site.twin.scene and (path.parent / site.twin.scene).is_file():
        changes.setdefault("twin__scene", str((path.parent / site.twin.scene).resolve()))
    if site.hub.things:
        changes.setdefault("hub__things", str((path.parent / site.hub.things).resolve()))
    return changed(site, **changes) if changes else site


def open_premises(site: Site) -> Premises:
    """Load the room of a site and build its map; raises RoomError or ConfigError."""
    room = load_room(site.room.model)
    return Premises(site, room, build_grid(room, site))
