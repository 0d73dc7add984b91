"""B-sen in space, as the tests of planning in three dimensions see it."""

from __future__ import annotations

from functools import cache
from importlib import resources
from pathlib import Path

import numpy as np

from housefly.config.site import site_from_file
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.any_angle import in_metres, in_voxel_edges, taut
from housefly.pilot.planning.space.clearance import HullCylinder
from housefly.pilot.planning.space.costs import height_wish, narrowness
from housefly.pilot.planning.space.reachability import within_reach
from housefly.pilot.planning.space.search import CellSearch
from housefly.pilot.planning.space.volumes import Volume, VolumeKind, within_volumes
from housefly.pilot.planning.space.voxels import VoxelMap, voxel_map
from housefly.pilot.planning.trajectory.speed_limits import MotionLimits
from housefly.room.bsen import bsen

ARDRONE = HullCylinder(0.343, 0.065)
KEEP = 0.15
LIMITS = MotionLimits(
    speed=1.0,
    vertical_speed=0.5,
    acceleration=1.6,
    vertical_acceleration=0.6,
    jerk=12.0,
    drag=0.58,
    narrow_speed=0.8,
    wide=0.3,
)


@cache
def bsen_voxels() -> VoxelMap:
    """Return B-sen at 0.1 m with the no-fly areas of its site file."""
    site = site_from_file(Path(str(resources.files("housefly") / "sites" / "bsen.toml")))
    bare = voxel_map(bsen(), 0.1, ARDRONE, KEEP)
    zones = [
        Volume(VolumeKind.KEEP_OUT, ((a, b), (c, b), (c, d), (a, d)))
        for a, b, c, d in (obstacle.rectangle for obstacle in site.map.virtual_obstacles)
    ]
    return within_reach(within_volumes(bare, zones), bsen().home)


@cache
def bsen_search() -> CellSearch:
    """Return the search that keeps off walls and near the usual height."""
    voxels = bsen_voxels()
    return CellSearch(voxels.free(), narrowness(voxels, 0.35, 2.0) + height_wish(voxels, 1.1, 0.3))


def free_points(seed: int, count: int, height: float | None = None) -> FloatArray:
    """Return random middles of free voxels [m], at one height if given, shape (count, 3)."""
    voxels = bsen_voxels()
    cells = np.argwhere(voxels.free())
    if height is not None:
        cells = cells[cells[:, 2] == voxels.voxel_of((0.0, 0.0, height))[2]]
    picked = cells[np.random.default_rng(seed).integers(len(cells), size=count)]
    return np.array([voxels.middle_of((i, j, k)) for i, j, k in picked.tolist()])


def way_between(start: FloatArray, goal: FloatArray) -> FloatArray:
    """Return the corners of a straightened way in B-sen [m], shape (n, 3)."""
    voxels, search = bsen_voxels(), bsen_search()
    here, there = (voxels.voxel_of((x, y, z)) for x, y, z in (start.tolist(), goal.tolist()))
    cells = np.array(search.path(here, there).cells) + 0.5
    ends = in_voxel_edges(voxels, np.stack((start, goal)))
    points = np.vstack((ends[:1], cells[1:-1], ends[1:]))
    assert search.weights is not None
    return np.array(in_metres(voxels, taut(search.free, points, search.weights)))
