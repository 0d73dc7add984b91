"""Planning in space: clearance, search, straightening and trajectories in B-sen; 512 x 512 grids.

Times are those of the thread, so that other work on the machine does not count.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from scipy.ndimage import distance_transform_edt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from _run import percentile, table

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from benchmark_maps import grid_queries, read_grid  # noqa: E402
from space_room import (  # noqa: E402
    ARDRONE,
    KEEP,
    LIMITS,
    bsen_search,
    bsen_voxels,
    free_points,
    way_between,
)

from housefly.messages.obstacles import Obstacle  # noqa: E402
from housefly.pilot.planning.space.search import CellSearch  # noqa: E402
from housefly.pilot.planning.space.solid_rows import live_rows, room_rows  # noqa: E402
from housefly.pilot.planning.space.voxels import voxel_map, with_rows  # noqa: E402
from housefly.pilot.planning.trajectory.trajectory import (  # noqa: E402
    at_rest,
    trajectory_along,
)
from housefly.room.bsen import bsen  # noqa: E402

GRIDS = ROOT.parent / "shared" / "data" / "maps" / "grid2d"
NAMES = ("32room_000", "8room_000", "maze512-1-0", "maze512-8-0", "random512-40-0")
PAIRS = 25


def milliseconds(call: Callable[[], object], repeats: int = 5) -> float:
    call()
    times = []
    for _ in range(repeats):
        begin = time.thread_time()
        call()
        times.append(1e3 * (time.thread_time() - begin))
    return min(times)


def clearance_rows() -> list[list[object]]:
    chair = Obstacle("chair", (8.0, 3.0), 0.0, (0.5, 0.5), 0.3, 0.0, 1.0)
    rows = []
    for resolution in (0.1, 0.05):
        voxels = voxel_map(bsen(), resolution, ARDRONE, KEEP)
        whole = milliseconds(lambda r=resolution: voxel_map(bsen(), r, ARDRONE, KEEP), 3)
        peer = milliseconds(lambda v=voxels: distance_transform_edt(v.free()), 3)
        one, ten = (
            milliseconds(lambda v=voxels, n=n: with_rows(v, live_rows([chair] * n, 0.0, 0.0)))
            for n in (1, 10)
        )
        shape = " x ".join(str(size) for size in voxels.shape)
        ratios = f"{peer / whole:.1f} x, {peer / one:.0f} x"
        rows.append([f"{resolution} m", shape, f"{whole:.1f}", f"{one:.2f}", f"{ten:.2f}", ratios])
    return rows


def planning_rows() -> list[list[object]]:
    voxels, search, solids = bsen_voxels(), bsen_search(), room_rows(bsen())
    free, points = voxels.free(), free_points(12, 2 * PAIRS, 1.1)
    pairs = list(zip(points[::2], points[1::2], strict=True))
    trajectory_along(voxels, free, solids, way_between(*pairs[0]), at_rest(pairs[0][0]), LIMITS)
    rows: list[list[object]] = []
    for speed in (0.5, 1.0, 1.5, 2.0):
        limits = LIMITS._replace(speed=speed, narrow_speed=min(speed, LIMITS.narrow_speed))
        times: dict[str, list[float]] = {"search": [], "way": [], "all": []}
        flown, length, near = 0.0, 0.0, 9.0
        for start, goal in pairs:
            begin = time.thread_time()
            search.path(voxels.voxel_of(tuple(start)), voxels.voxel_of(tuple(goal)))
            found = time.thread_time()
            corners = way_between(start, goal)
            straight = time.thread_time()
            flight = trajectory_along(voxels, free, solids, corners, at_rest(start), limits)
            end = time.thread_time()
            assert flight is not None and not flight.stops
            times["search"].append(1e3 * (found - begin))
            times["way"].append(1e3 * (straight - found))
            times["all"].append(1e3 * (end - found))
            flown, length = flown + flight.duration, length + flight.length
            near = min(near, flight.clearance + ARDRONE.radius)
        spans = [f"{percentile(t, 0.5):.2f} / {max(t):.2f}" for t in times.values()]
        rows.append([f"{speed} m/s, {length:.0f} m", f"{flown:.0f} s", f"{near:.3f} m", *spans])
    return rows


def matrix(free: np.ndarray) -> object:
    index, ends, costs = np.arange(free.size).reshape(free.shape), [], []
    parts = {-1: (np.s_[1:], np.s_[:-1]), 0: (np.s_[:], np.s_[:]), 1: (np.s_[:-1], np.s_[1:])}
    for di, dj in ((1, 0), (0, 1), (1, 1), (1, -1)):
        (a, b), (c, d) = parts[di], parts[dj]
        legal = free[a, c] & free[b, d] & free[a, d] & free[b, c]
        ends.append((index[a, c][legal], index[b, d][legal]))
        costs.append(np.full(int(legal.sum()), float(np.hypot(di, dj))))
    i, j = np.concatenate([e[0] for e in ends]), np.concatenate([e[1] for e in ends])
    both = (np.concatenate((i, j)), np.concatenate((j, i)))
    return coo_array((np.tile(np.concatenate(costs), 2), both), shape=(free.size,) * 2).tocsr()


def grid_rows() -> list[list[object]]:
    rows: list[list[object]] = []
    for name in NAMES:
        free = read_grid(GRIDS / f"{name}.map")
        queries = list(grid_queries(GRIDS / f"{name}.map.scen"))[::40]
        search, graph = CellSearch(free), matrix(free)
        some = queries[:: max(1, len(queries) // 6)]
        ours = [milliseconds(partial(search.path, q.start, q.goal), 1) for q in queries]
        scipys = [
            milliseconds(partial(dijkstra, graph, indices=q.start[0] * 512 + q.start[1]), 1)
            for q in some
        ]
        mine, theirs = float(np.mean(ours)), float(np.mean(scipys))
        rows.append(
            [name, f"{mine:.2f}", f"{max(ours):.2f}", f"{theirs:.1f}", f"{theirs / mine:.1f} x"]
        )
    return rows


def main() -> None:
    print("### Planning in space\n")
    head = ["voxel", "voxels", "whole room [ms]", "one thing moved [ms]", "ten [ms]"]
    print(table([*head, "scipy's transform takes"], clearance_rows()), "\n")
    head = ["speed", f"{PAIRS} flights", "nearest", "search [ms]", "search and way [ms]"]
    print(table([*head, "way and trajectory [ms]"], planning_rows()), "\n")
    print("Median and largest; nearest is from the drone's middle to a solid, exact.\n")
    if GRIDS.is_dir():
        head = ["512 x 512", "A*, mean [ms]", "longest [ms]", "scipy's Dijkstra, mean [ms]"]
        print(table([*head, "ratio"], grid_rows()))


if __name__ == "__main__":
    main()
