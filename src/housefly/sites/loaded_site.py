"""Finds a site, loads its room and builds its map."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from housefly import sites
from housefly.config.site import Site, changed, site_from_file
from housefly.config.state import edits_folder
from housefly.config.text import did_you_mean, is_file, shortened
from housefly.errors import ConfigError, EditsError
from housefly.geometry import Vec2
from housefly.messages import PlanAnswer
from housefly.room.edit_versions import EditVersions
from housefly.room.edits import edited, room_of
from housefly.room.files import load_room
from housefly.room.grid import OccupancyGrid, build_grid
from housefly.room.model import Room
from housefly.room.tracked import untracked


@dataclass(frozen=True, slots=True)
class LoadedSite:
    """A checked site, the room it names, and the occupancy grid of its mode."""

    site: Site
    room: Room
    grid: OccupancyGrid

    def for_drone(self, name: str) -> LoadedSite:
        """Return site, room and map as one drone has them; raises ConfigError as the site."""
        site = self.site.for_drone(name)
        return self if site is self.site else open_site(site)

    def plan(self, goal: str | Vec2, start: str | Vec2 = "home") -> PlanAnswer:
        """Return the way from a start to a goal, or the reason why there is none.

        Both are the name of a place, or world xy [m]. Points are told to a nanometre: 1.45, not
        1.4500000000000002. Raises ConfigError for an unknown place.
        """
        from housefly.pilot.navigator import RoomNavigator

        navigator = RoomNavigator(self.site, self.room, self.grid)
        return _readable(navigator.route(self.point_of(start), self.point_of(goal)))

    def point_of(self, place: str | Vec2) -> Vec2:
        """Return where the drone hovers at a place [m]; raises ConfigError for an unknown one."""
        if not isinstance(place, str):
            return place
        try:
            return self.room.place(place).viewpoint
        except KeyError as error:
            raise ConfigError("place", str(error.args[0])) from error


def _readable(answer: PlanAnswer) -> PlanAnswer:
    path, nearest = answer.path, answer.suggestion
    if path is not None:
        path = replace(path, waypoints=tuple(_rounded(point) for point in path.waypoints))
    return replace(answer, path=path, suggestion=None if nearest is None else _rounded(nearest))


def _rounded(point: Vec2) -> Vec2:
    return round(point[0], 9), round(point[1], 9)


def load_site(name: str = "bsen", **changes: Any) -> LoadedSite:
    """Load a site with its room and map.

    Args:
        name: a site file, a folder with ``site.toml``, or the name of a shipped site.
        changes: of its keys (``docs/site.md``), with two underscores for the dot:
            ``twin__seed=7``.

    Raises:
        ConfigError: naming the key, the value and what is allowed.
        RoomError: the room cannot be read.
    """
    return open_site(read_site(name, **changes))


def site_file(name: str) -> Path:
    """Return the path of a site: a file, a folder with ``site.toml``, or a shipped site's name.

    Raises:
        ConfigError: naming the sites that are shipped.
    """
    path = Path(name)
    for file in (path, path / "site.toml"):
        if is_file(file):
            return file
    shipped = Path(sites.__file__).parent
    if is_file(shipped / f"{name}.toml"):
        return shipped / f"{name}.toml"
    known = sorted(
        p.stem for p in shipped.glob("*.toml") if not p.stem.endswith(("_scene", "_things"))
    )
    raise ConfigError(
        "--site",
        f"no file {shortened(name)!r}, and no site of that name is shipped"
        f"{did_you_mean(name, known)} (shipped: {', '.join(known)})",
    )


def read_site(name: str, **changes: Any) -> Site:
    """Read a site and apply changes by key (``twin__seed=3``); its paths become absolute."""
    path = site_file(name)
    site = site_from_file(path)
    model = site.room.model
    if is_file(path.parent / model / "room.toml"):
        changes.setdefault("room__model", str((path.parent / model).resolve()))
    if site.twin.scene and is_file(path.parent / site.twin.scene):
        changes.setdefault("twin__scene", str((path.parent / site.twin.scene).resolve()))
    if site.hub.things:
        changes.setdefault("hub__things", str((path.parent / site.hub.things).resolve()))
    for key in ("tls_certificate", "tls_key", "users"):
        if (name := getattr(site.web, key)) and not name.startswith("~"):
            changes.setdefault(f"web__{key}", str((path.parent / name).absolute()))
    for key in ("documents", "rules"):
        if name := getattr(site.tasks, key):
            changes.setdefault(f"tasks__{key}", str((path.parent / name).absolute()))
    return changed(site, **changes) if changes else site


def open_site(site: Site) -> LoadedSite:
    """Load the room of a site and build its map; raises RoomError or ConfigError."""
    room = room_of(site)
    untracked(room, site)  # furniture that the room does not have is refused before anything starts
    return LoadedSite(site, room, build_grid(room, site))


def with_newest_edits(site: Site) -> tuple[Site, str]:
    """Return a site with the newest edits of the ROOM screen, and a line that says so, or "".

    Raises:
        ConfigError: the edits no longer fit the room, so a no-fly zone might be missing.
    """
    if not site.hub.edits or site.mode == "paper":
        return site, ""
    versions = EditVersions(edits_folder(site))
    try:
        newest = versions.newest()
        if newest.number == 0:
            return site, versions.problem
        _, site = edited(load_room(site.room.model), site, newest.edits)
    except EditsError as error:
        raise ConfigError(
            "edits",
            f"{error}; mend the room, or start without edits: hub.edits = false in the site file",
            str(versions.folder),
        ) from error
    return site, "; ".join(
        filter(None, (f"places and zones as edited, version {newest.number}", versions.problem))
    )
