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

from housefly.config.site import changed, site_from_file  # noqa: E402
from housefly.messages.obstacles import Obstacle, ObstacleKind  # noqa: E402
from housefly.pilot.planning.space.search import CellSearch  # noqa: E402
from housefly.pilot.planning.space.solid_rows import live_rows, room_rows  # noqa: E402
from housefly.pilot.planning.space.space_map import SpaceMap  # noqa: E402
from housefly.pilot.planning.space.voxels import VoxelMap, voxel_map, with_rows  # noqa: E402
from housefly.pilot.planning.trajectory.timing import KinematicState  # noqa: E402
from housefly.pilot.planning.trajectory.trajectory import (  # noqa: E402
    Trajectory,
    at_rest,
    trajectory_along,
)
from housefly.room.bsen import bsen  # noqa: E402
from housefly.room.grid import build_grid  # noqa: E402

GRIDS = ROOT.parent / "shared" / "data" / "maps" / "grid2d"
NAMES = ("32room_000", "8room_000", "maze512-1-0", "maze512-8-0", "random512-40-0")
PAIRS = 25
PLANS = 300


def milliseconds(call: Callable[[], object], repeats: int = 5) -> float:
    call()
    times = []
    for _ in range(repeats):
        begin = time.thread_time()
        call()
        times.append(1e3 * (time.thread_time() - begin))
    return min(times)


def transformed(voxels: VoxelMap) -> object:
    """Return the distances as the peer works them out."""
    return distance_transform_edt(voxels.free())


def with_chairs(voxels: VoxelMap, chairs: list[Obstacle]) -> VoxelMap:
    """Return the map with chairs in it."""
    return with_rows(voxels, live_rows(chairs, 0.0, 0.0))


def clearance_rows() -> list[list[object]]:
    chair = Obstacle("chair", (8.0, 3.0), 0.0, (0.5, 0.5), 0.3, 0.0, 1.0)
    rows: list[list[object]] = []
    for resolution in (0.1, 0.05):
        voxels = voxel_map(bsen(), resolution, ARDRONE, KEEP)
        whole = milliseconds(partial(voxel_map, bsen(), resolution, ARDRONE, KEEP), 3)
        peer = milliseconds(partial(transformed, voxels), 3)
        one, ten = (
            milliseconds(partial(with_chairs, voxels, [chair] * count)) for count in (1, 10)
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


def map_rows() -> list[list[object]]:
    """Plans as the pilot asks for them: a chair and somebody have moved, the map is made anew."""
    file = ROOT / "src" / "housefly" / "sites" / "bsen.toml"
    site = changed(site_from_file(file), map__planner="space", limits__speed=1.0)
    begin = time.thread_time()
    space = SpaceMap(site, bsen(), build_grid(bsen(), site))
    made, points = time.thread_time() - begin, free_points(21, 2 * PLANS, 1.1)
    random = np.random.default_rng(5)
    whole: list[float] = []
    local: list[float] = []
    answered = [0, 0]
    for start, goal in zip(points[::2].tolist(), points[1::2].tolist(), strict=True):
        space.update((), 0.0)
        first = space.trajectory(at_rest(np.array(start)), tuple(goal), 0.0, 0.5)
        for times, state in ((whole, at_rest(np.array(start))), (local, middle_of(first, random))):
            if state is None:
                continue
            chair, person = random.uniform((5.0, 1.0), (13.0, 5.0), (2, 2)).tolist()
            seen = (
                Obstacle("chair", tuple(chair), 0.25, top=1.0, kind=ObstacleKind.THING),
                Obstacle("person", tuple(person), 0.25, kind=ObstacleKind.PERSON),
            )
            begin = time.thread_time()
            space.update(seen, 0.0)
            flight = space.trajectory(state, tuple(goal), 0.0, 0.5)
            times.append(1e3 * (time.thread_time() - begin))
            answered[times is local] += flight is not None
    rows: list[list[object]] = []
    for name, times, count in (
        ("from rest", whole, answered[0]),
        ("in flight", local, answered[1]),
    ):
        spans = [f"{value:.1f}" for value in (percentile(times, 0.5), percentile(times, 0.99))]
        rows.append([name, len(times), count, *spans, f"{max(times):.1f}", f"{made:.2f} s"])
    return rows


def middle_of(flight: Trajectory | None, random: np.random.Generator) -> KinematicState | None:
    """Return a state on the way, if there is a way."""
    if flight is None or len(flight.rows) < 10:
        return None
    row = flight.rows[int(random.integers(len(flight.rows) // 4, len(flight.rows) // 2))]
    return KinematicState(row[:3].copy(), row[3:6].copy(), row[6:9].copy())


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
    map_rows()  # compiles
    head = ["B-sen's map, 0.1 m", "plans", "answered", "median [ms]", "p99 [ms]", "longest [ms]"]
    print(table([*head, "made at the start in"], map_rows()), "\n")
    head = ["speed", f"{PAIRS} flights", "nearest", "search [ms]", "search and way [ms]"]
    print(table([*head, "way and trajectory [ms]"], planning_rows()), "\n")
    print("Median and largest; nearest is from the drone's middle to a solid, exact.\n")
    if GRIDS.is_dir():
        head = ["512 x 512", "A*, mean [ms]", "longest [ms]", "scipy's Dijkstra, mean [ms]"]
        print(table([*head, "ratio"], grid_rows()))


if __name__ == "__main__":
    main()
