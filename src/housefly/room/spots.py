"""Chooses wall distances, home and a few roomy places in a room made from a map."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from housefly.config.site import Site, changed
from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.room.grid import Cell, OccupancyGrid, build_grid, inflation
from housefly.room.model import Place, Room
from housefly.room.reach import Mask, flood
from housefly.room.ros_image import RosMap

_PLACE_TITLES = {
    "far": "Far end",
    "north": "North side",
    "south": "South side",
    "east": "East side",
    "west": "West side",
}
"""What people call the places that are chosen where nobody has named any."""
_PLACE_SPACING = 1.5
"""Places are at least this far apart [m]."""
LOOK_DISTANCE = 2.0
_ROOMINESS = 3.0
"""A place gives up this many metres towards its side for a metre of clearance, up to 1 m."""
_CONNECTED_SHARE = 0.6
"""Fly closer to walls while a smaller share than this of the flyable floor is connected."""


@dataclass(frozen=True, slots=True)
class ClearanceProfile:
    """How to fly in a map.

    Distances added to the hull [m], cell edge [m], speed [m/s], and a remark.
    """

    tracking_bound: float
    margin: float
    resolution: float
    speed: float
    remark: str


PROFILES = (
    ClearanceProfile(0.10, 0.05, 0.10, 0.50, "the usual distance from walls"),
    ClearanceProfile(
        0.05,
        0.02,
        0.05,
        0.35,
        "narrow: at the usual distance from walls this map falls into parts; fly slower and closer",
    ),
    ClearanceProfile(
        0.03, 0.00, 0.05, 0.25, "very narrow: hardly more than the hull fits through; fly slowly"
    ),
)


def site_for(manner: ClearanceProfile) -> Site:
    """Return a site with this profile."""
    return changed(
        Site(),
        map__tracking_bound=manner.tracking_bound,
        map__margin=manner.margin,
        map__resolution=manner.resolution,
    )


def profile_and_home(shell: Room, ros_map: RosMap, source: Path) -> tuple[ClearanceProfile, Vec2]:
    """Return the most careful profile that can fly most of the map, and the roomiest home."""
    choices = [(manner, *_flyable(shell, site_for(manner), ros_map)) for manner in PROFILES]
    for manner, home, share in choices:
        if home and share >= _CONNECTED_SHARE:
            return manner, home
    for manner, home, _ in choices:
        if home:
            return manner, home
    needed = inflation(site_for(PROFILES[-1]))
    raise RoomError(
        f"{source}: the drone fits nowhere: it keeps {needed:.2f} m from walls; check resolution in"
        " the yaml file"
    )


def _flyable(shell: Room, site: Site, ros_map: RosMap) -> tuple[Vec2 | None, float]:
    """Return the roomiest point of the largest flyable part, and its share of all parts."""
    grid = build_grid(shell, site)
    xs = [grid.centre_of((i, 0))[0] for i in range(grid.shape[0])]
    ys = [grid.centre_of((0, j))[1] for j in range(grid.shape[1])]
    flyable = (grid.clearance >= inflation(site)) & _sampled(
        ros_map.free, xs, ys, ros_map.resolution
    )
    area = largest_area(flyable)
    if area is None:
        return None, 0.0
    i, j = np.unravel_index(int(np.where(area, grid.clearance, -1.0).argmax()), grid.shape)
    return _rounded(grid.centre_of((int(i), int(j)))), float(area.sum() / flyable.sum())


def _sampled(mask: Mask, xs: list[float], ys: list[float], edge: float) -> Mask:
    i = np.minimum((np.array(xs) / edge).astype(np.int64), mask.shape[0] - 1)
    j = np.minimum((np.array(ys) / edge).astype(np.int64), mask.shape[1] - 1)
    sampled: Mask = mask[i][:, j]
    return sampled


def largest_area(open_cells: Mask) -> Mask | None:
    """Return the largest 4-connected part of a mask, or None when the mask is empty."""
    rest, best = open_cells.copy(), None
    while rest.any() and (best is None or rest.sum() > best.sum()):
        i, j = np.argwhere(rest)[0]
        part: Mask = flood(rest, int(i), int(j))
        rest &= ~part
        if best is None or part.sum() > best.sum():
            best = part
    return best


def places_around(grid: OccupancyGrid, home: Vec2) -> tuple[Place, ...]:
    """Return roomy viewpoints, reachable from home: one far away, and one towards each side."""
    i, j = grid.cell_of(home)
    area: Mask = flood(grid.cells == Cell.FREE, i, j)
    ix, iy = np.nonzero(area)
    x = grid.origin[0] + (ix + 0.5) * grid.resolution
    y = grid.origin[1] + (iy + 0.5) * grid.resolution
    room_there = _ROOMINESS * np.minimum(grid.clearance[ix, iy], 1.0)
    wishes = (np.hypot(x - home[0], y - home[1]), y, -y, x, -x)
    places: list[Place] = []
    taken = [home]
    for name, wish in zip(_PLACE_TITLES, wishes, strict=True):
        apart = np.min([np.hypot(x - u, y - v) for u, v in taken], axis=0) >= _PLACE_SPACING
        if apart.any():
            best = int(np.where(apart, wish + room_there, -np.inf).argmax())
            spot = _rounded((float(x[best]), float(y[best])))
            taken.append(spot)
            places.append(Place(name, spot, _outward(spot, home), _PLACE_TITLES[name]))
    return tuple(places)


def _outward(spot: Vec2, home: Vec2) -> tuple[float, float, float]:
    """Return a point to look at beyond the spot, seen from home [m]."""
    dx, dy = spot[0] - home[0], spot[1] - home[1]
    scale = LOOK_DISTANCE / max(1e-6, (dx * dx + dy * dy) ** 0.5)
    return round(spot[0] + dx * scale, 3), round(spot[1] + dy * scale, 3), 1.1


def _rounded(point: Vec2) -> Vec2:
    return round(point[0], 3), round(point[1], 3)
