"""The search for a way beside the same algorithm written in C, query by query in turn.

Needs a C compiler (``cc``). Times are those of the thread, the least of five of each query.
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from shutil import which
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from _run import table

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from benchmark_maps import grid_queries, read_grid  # noqa: E402
from space_room import bsen_search, bsen_voxels, free_points  # noqa: E402

from housefly.pilot.planning.space.astar import CELL_MARK  # noqa: E402
from housefly.pilot.planning.space.moves import moves_of, padded  # noqa: E402
from housefly.pilot.planning.space.search import CellSearch  # noqa: E402
from housefly.pilot.planning.space.voxels import VoxelIndex  # noqa: E402

GRIDS = ROOT.parent / "shared" / "data" / "maps" / "grid2d"
NAMES = ("8room_000", "maze512-8-0", "random512-40-0")
FLAGS = ("-O3", "-march=native", "-ffp-contract=off", "-shared", "-fPIC")
REPEATS, BUCKETS = 5, 4096
LIMIT = 1.2

Query = tuple[VoxelIndex, VoxelIndex]


class CMoves(ctypes.Structure):
    """The moves as the C code takes them."""

    _fields_ = [
        ("steps", ctypes.c_void_p),
        ("offsets", ctypes.c_void_p),
        ("needs", ctypes.c_void_p),
        ("lengths", ctypes.c_void_p),
        ("count", ctypes.c_int),
    ]


class SearchInC:
    """The search of ``_search.c`` on one grid."""

    def __init__(self, library: ctypes.CDLL, search: CellSearch) -> None:
        grid = padded(search.free)
        self._shape = np.array(grid.shape, dtype=np.int64)
        self._free = grid.ravel().astype(np.uint8)
        self._border = np.array([1, 1, int(grid.shape[2] > 1)])
        self._weights: np.ndarray | None = None
        if search.weights is not None:
            width = [(side, side) for side in self._border.tolist()]
            self._weights = np.pad(search.weights, width).ravel()
        self._moves = moves_of(grid.shape)
        self._marks = np.zeros(grid.size, CELL_MARK)
        self._heads = np.empty(BUCKETS, dtype=np.int32)
        self._stamp = 1
        self._call = library.shortest_length
        self._call.restype = ctypes.c_double
        parts = (self._moves.steps, self._moves.offsets, self._moves.needs, self._moves.lengths)
        self._arguments = CMoves(*(part.ctypes.data for part in parts), len(self._moves.lengths))

    def cost(self, start: VoxelIndex, goal: VoxelIndex) -> float:
        """Return the length of a shortest way, weights included [cell edges]."""
        self._stamp += 2
        pointer = ctypes.c_void_p
        return float(
            self._call(
                pointer(self._free.ctypes.data),
                pointer(self._weights.ctypes.data if self._weights is not None else None),
                self._number(start),
                self._number(goal),
                pointer(self._shape.ctypes.data),
                ctypes.byref(self._arguments),
                self._stamp,
                pointer(self._heads.ctypes.data),
                BUCKETS,
                pointer(self._marks.ctypes.data),
            )
        )

    def _number(self, cell: VoxelIndex) -> int:
        return int(np.ravel_multi_index(tuple(self._border + cell), tuple(self._shape)))


def library(folder: Path) -> ctypes.CDLL:
    """Compile the C code into a folder and load it."""
    if which("cc") is None:
        sys.exit("search_in_c needs a C compiler: apt install gcc")
    built = folder / "search.so"
    source = Path(__file__).with_name("_search.c")
    subprocess.run(["cc", *FLAGS, "-o", str(built), str(source), "-lm"], check=True)
    return ctypes.CDLL(str(built))


def microseconds(call: Callable[[], object]) -> float:
    begin = time.thread_time_ns()
    call()
    return (time.thread_time_ns() - begin) / 1e3


def compared(search: CellSearch, in_c: SearchInC, queries: list[Query]) -> list[Any]:
    """Return medians over the queries, and the ratio of the sums."""
    ours, theirs = [], []
    for start, goal in queries:
        mine, its = search.path(start, goal).cost, in_c.cost(start, goal)
        assert mine == its or abs(mine - its) < 1e-9 * mine, (start, goal, mine, its)
        times = [
            (
                microseconds(partial(search.path, start, goal)),
                microseconds(partial(in_c.cost, start, goal)),
            )
            for _ in range(REPEATS)
        ]
        ours.append(min(one for one, _ in times))
        theirs.append(min(other for _, other in times))
    ratio = sum(ours) / sum(theirs)
    return [len(queries), f"{median(ours):.0f}", f"{median(theirs):.0f}", f"{ratio:.2f}"]


def maps() -> Iterator[tuple[str, CellSearch, list[Query]]]:
    """Yield B-sen in space, then the 512 x 512 maps that are there."""
    points = [bsen_voxels().voxel_of(tuple(point)) for point in free_points(12, 400, 1.1).tolist()]
    pairs = list(zip(points[::2], points[1::2], strict=True))
    yield "B-sen in space, 26 moves", bsen_search(), pairs
    for name in NAMES if GRIDS.is_dir() else ():
        queries = list(grid_queries(GRIDS / f"{name}.map.scen"))[::40]
        flat = [((*q.start, 0)[:3], (*q.goal, 0)[:3]) for q in queries]
        yield f"{name}, 8 moves", CellSearch(read_grid(GRIDS / f"{name}.map")), flat


def main() -> None:
    print("### The search for a way beside the same algorithm in C\n")
    rows = []
    with TemporaryDirectory() as folder:
        built = library(Path(folder))
        for name, search, queries in maps():
            rows.append([name, *compared(search, SearchInC(built, search), queries)])
    head = ["map", "queries", "Housefly, median [us]", "C, median [us]", "sum of Housefly / C"]
    print(table(head, rows), "\n")
    flags = " ".join(FLAGS[:3])
    print(f"Housefly hands out the cells of the way, C its length only (`cc {flags}`);")
    print(f"all lengths are equal. The limit is {LIMIT}.")
    if any(float(row[-1]) > LIMIT for row in rows):
        sys.exit(1)


if __name__ == "__main__":
    main()
