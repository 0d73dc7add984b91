"""The paper's claims about map and planner, measured in the site's own room."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from housefly.config.site import Site, changed
from housefly.geometry import Vec2, distance
from housefly.lab.reproduction.routes import MappedSite, mapped_site, service_path
from housefly.lab.reproduction.unexpected import UnexpectedObstacles, put_unexpected
from housefly.pilot.planning.dijkstra import UNREACHED, FreeMask, distances
from housefly.pilot.planning.planner import path_length, plan
from housefly.room.distance import half_diagonal
from housefly.room.grid import Cell, build_grid

_MAX_HALF_BAND = 1.0
"""Most that a site may count below and above the flight height [m]."""


@dataclass(frozen=True, slots=True)
class MapFacts:
    """Numbers about map and planner.

    Attributes:
        cells: of the grid of mode paper, along x and y.
        free: cells that are free at the flight height, without virtual obstacles.
        free_at_every_height: those of them that are free from the floor to twice the flight height.
        resolution: edge of a cell [m].
        hull: length and width [m].
        half_diagonal: of the hull [m].
        pairs: pairs of free cells whose distance was compared with an independent Dijkstra's.
        wrong: how many of them differ.
        detour: length over four moves divided by that of the straightened way; mean over the room's
            places.
        bare_clearance: smallest gap between hull and obstacles on the paths to all places, hull
            turned its worst way, without virtual obstacles [m]; negative: it touches.
        clearance: the same with those of the site file [m].
        drawn: number of virtual obstacles.
        legs: legs of the service's way.
        legs_along_y: how many of them are neither towards +x nor -x.
        unexpected: obstacles put into the room, one at a time.
    """

    cells: tuple[int, int]
    free: int
    free_at_every_height: int
    resolution: float
    hull: Vec2
    half_diagonal: float
    pairs: int
    wrong: int
    detour: float
    bare_clearance: float
    clearance: float
    drawn: int
    legs: int
    legs_along_y: int
    unexpected: UnexpectedObstacles


def survey(site: Site) -> MapFacts:
    """Return the facts about the site's room."""
    return map_facts(mapped_site(site, "paper"), mapped_site(site, "default"))


def map_facts(paper: MappedSite, default: MappedSite) -> MapFacts:
    """Return the facts about a room, mapped in either mode."""
    free: FreeMask = paper.grid.cells == Cell.FREE
    pairs, wrong = compared_with_scipy(free, free)
    way = service_path(paper).waypoints
    bare = _without_virtual_obstacles(paper)
    hull = paper.site.drone
    return MapFacts(
        cells=paper.grid.shape,
        free=int((bare.grid.cells == Cell.FREE).sum()),
        free_at_every_height=_free_at_every_height(bare),
        resolution=paper.grid.resolution,
        hull=(hull.hull_length, hull.hull_width),
        half_diagonal=half_diagonal(hull.hull_length, hull.hull_width),
        pairs=pairs,
        wrong=wrong,
        detour=_detour(paper),
        bare_clearance=_gap(bare),
        clearance=_gap(paper),
        drawn=len(paper.site.map.paper_virtual_obstacles),
        legs=len(way) - 1,
        legs_along_y=sum(abs(b[0] - a[0]) < 1e-6 for a, b in pairwise(way)),
        unexpected=put_unexpected(default),
    )


def compared_with_scipy(free: FreeMask, believed: FreeMask) -> tuple[int, int]:
    """Return how many pairs of free cells were compared, and how many differ from scipy's.

    Args:
        free: the grid that scipy sees, shape (nx, ny).
        believed: the grid that our planner sees; the same but for tests.
    """
    index = np.full(free.shape, -1)
    index[free] = np.arange(free.sum())
    along_x = np.stack([index[:-1], index[1:]], axis=-1).reshape(-1, 2)
    along_y = np.stack([index[:, :-1], index[:, 1:]], axis=-1).reshape(-1, 2)
    edges = np.concatenate([along_x, along_y])
    edges = edges[(edges >= 0).all(axis=1)]
    size = int(free.sum())
    graph = csr_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(size, size))
    theirs = dijkstra(graph, directed=False)
    ours = np.array(
        [distances(believed, (int(ix), int(iy)))[free] for ix, iy in np.argwhere(free)], dtype=float
    )
    ours[ours == UNREACHED] = np.inf
    return size * size, int((ours != theirs).sum())


def _detour(paper: MappedSite) -> float:
    """Return the mean ratio of the path by four moves to the straightened path on the same grid."""
    ratios = []
    for place in paper.room.places:
        if distance(place.viewpoint, paper.room.home) < paper.grid.resolution:
            continue
        steps = service_path(paper, place.name).waypoints
        straight = plan(paper.grid, steps[0], steps[-1], paper.site.limits.speed, shortcut=True)
        assert straight.path is not None, "the same grid and ends had a way a moment ago"
        ratios.append(path_length(steps) / straight.path.length)
    return float(np.mean(ratios))


def _without_virtual_obstacles(here: MappedSite) -> MappedSite:
    bare = changed(here.site, map__paper_virtual_obstacles=())
    return MappedSite(bare, here.room, build_grid(here.room, bare))


def _free_at_every_height(here: MappedSite) -> int:
    whole = changed(here.site, map__half_band=min(_MAX_HALF_BAND, here.site.map.flight_height))
    free = (here.grid.cells == Cell.FREE) & (build_grid(here.room, whole).cells == Cell.FREE)
    return int(free.sum())


def _gap(here: MappedSite) -> float:
    """Return the smallest clearance of the paths from home to all places less half the hull [m]."""
    ways = (service_path(here, place.name) for place in here.room.places)
    hull = half_diagonal(here.site.drone.hull_length, here.site.drone.hull_width)
    return min(way.clearance for way in ways) - hull
