"""The home pad on the floor, where the drone starts and lands; it does not collide.

Where a site has several drones, each has a pad, and the room that one of them flies in has its pad
as home.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import cos, sin

from housefly.config.drones import check_pads
from housefly.config.site import Site
from housefly.errors import ConfigError
from housefly.geometry import Vec2
from housefly.room.model import Place, Room, Solid
from housefly.room.parts import paint, pillar, place_parts

HOME_PAD_RADIUS = 0.40
"""Radius of the pad [m]."""
_PAD = (
    pillar("rim", (0.0, 0.0), 0.0, 0.004, 2 * HOME_PAD_RADIUS, paint(0.94, 0.94, 0.92)),
    pillar("disc", (0.0, 0.0), 0.004, 0.006, 0.74, paint(0.13, 0.38, 0.42)),
    pillar("dot", (0.0, 0.0), 0.006, 0.008, 0.20, paint(0.94, 0.94, 0.92)),
)


_THING = "home pad"
_LOOK_DISTANCE = 3.0
"""A drone that hovers above its pad looks this far ahead of it [m]."""


def home_pad(home: Vec2, name: str = "") -> tuple[Solid, ...]:
    """Return the pad's discs around a position [m]; a name tells those of several pads apart."""
    parts = place_parts(_THING, _PAD, *home, name=name)
    return tuple(replace(solid, collides=False) for solid in parts)


def with_pads(room: Room, site: Site) -> Room:
    """Return the room with the pads of its site's drones, and that of the site's own as home.

    Raises:
        ConfigError: a pad lies outside, or too near to the room's own, which another drone has.
    """
    if not site.drones and site.drone.pad is None:
        return room
    pads = {drone.name: drone.pad or (*room.home, room.home_yaw) for drone in site.all_drones}
    _check_pads(room, site, pads)
    home_x, home_y, yaw = site.drone.pad or (*room.home, room.home_yaw)
    home = home_x, home_y
    ahead = home_x + _LOOK_DISTANCE * cos(yaw), home_y + _LOOK_DISTANCE * sin(yaw)
    moved = home != room.home
    return replace(
        room,
        home=home,
        home_yaw=yaw,
        other_pads=tuple(
            (drone.name, pads[drone.name][:2])
            for drone in site.all_drones
            if drone.enabled and drone.name != site.drone.name
        ),
        places=tuple(
            Place(place.name, home, (*ahead, place.look_at[2]), place.title)
            if moved and place.name == "home"
            else place
            for place in room.places
        ),
        solids=(
            *(solid for solid in room.solids if solid.thing != _THING),
            *(
                solid
                for name, (x, y, _) in pads.items()
                for solid in home_pad((x, y), "" if (x, y) == home else f"{_THING} of {name}")
            ),
        ),
    )


def _check_pads(room: Room, site: Site, pads: dict[str, tuple[float, float, float]]) -> None:
    x_min, y_min, x_max, y_max = room.bounds
    for name, (x, y, _) in pads.items():
        if not (x_min <= x <= x_max and y_min <= y <= y_max):
            raise ConfigError(
                "drones",
                f"the pad of {name!r} ({x:g}, {y:g} m) lies outside the room; allowed: x from"
                f" {x_min:g} to {x_max:g} m, y from {y_min:g} to {y_max:g} m",
            )
    flown = [drone for drone in site.all_drones if drone.enabled]
    for one, other in combinations(flown, 2):
        try:
            check_pads(one, other, (pads[one.name], pads[other.name]), site.people.min_distance)
        except ValueError as error:
            raise ConfigError("drones", str(error).removeprefix("drones: ")) from error
