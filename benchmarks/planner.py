"""Planning time against scipy and networkx, on the paper's grid and on 512 x 512 maps."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import networkx as nx
import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra as scipy_dijkstra

from housefly.config.site import changed, site_from_file
from housefly.pilot.planning.dijkstra import shortest_path
from housefly.room.bsen import bsen
from housefly.room.grid import Cell, build_grid

ROOT = Path(__file__).resolve().parents[1]
MAPS = ROOT.parent / "shared" / "data" / "maps" / "grid2d"
NAMES = ("8room_000", "maze512-8-0", "random512-40-0")
QUERIES = 7

Free = np.ndarray
Query = tuple[tuple[int, int], tuple[int, int]]


def paper_grid() -> Free:
    site = changed(site_from_file(ROOT / "src" / "housefly" / "sites" / "bsen.toml"), mode="paper")
    return np.asarray(build_grid(bsen(), site).cells == Cell.FREE)


def read_map(path: Path) -> Free:
    rows = path.read_text().splitlines()[4:]
    return np.array([[cell == "." for cell in row] for row in rows]).T.copy()


def generated_map() -> Free:
    return np.random.default_rng(3).random((512, 512)) > 0.3


def cell_of(row: np.ndarray) -> tuple[int, int]:
    return int(row[0]), int(row[1])


def far_queries(free: Free) -> list[Query]:
    """Return the farthest of many random pairs of cells that have a way between them."""
    random = np.random.default_rng(1)
    cells = np.argwhere(free)
    pairs = [
        (cell_of(cells[one]), cell_of(cells[other]))
        for one, other in random.integers(len(cells), size=(60, 2))
    ]
    pairs.sort(key=lambda pair: -abs(pair[0][0] - pair[1][0]) - abs(pair[0][1] - pair[1][1]))
    found = (pair for pair in pairs if shortest_path(free, pair[0], pair[1]))
    return [query for query, _ in zip(found, range(QUERIES), strict=False)]


def matrix(free: Free) -> Any:
    index = np.arange(free.size).reshape(free.shape)
    ends = []
    for a, b in ((np.s_[:-1, :], np.s_[1:, :]), (np.s_[:, :-1], np.s_[:, 1:])):
        both = free[a] & free[b]
        ends += [(index[a][both], index[b][both]), (index[b][both], index[a][both])]
    rows, columns = np.concatenate([e[0] for e in ends]), np.concatenate([e[1] for e in ends])
    return coo_array((np.ones(rows.size), (rows, columns)), shape=(free.size, free.size)).tocsr()


def median_ms(
    solve: Callable[[Query], int], queries: list[Query], repeats: int
) -> tuple[float, list[int]]:
    times, lengths = [], []
    for query in queries:
        best = float("inf")
        for _ in range(repeats):
            begin = time.perf_counter()
            length = solve(query)
            best = min(best, time.perf_counter() - begin)
        times.append(1000 * best)
        lengths.append(length)
    return statistics.median(times), lengths


def row(name: str, free: Free) -> str:
    queries = far_queries(free)
    graph = matrix(free)
    network = nx.grid_2d_graph(*free.shape)
    network.remove_nodes_from([(int(i), int(j)) for i, j in np.argwhere(~free)])

    def ours(query: Query) -> int:
        return len(shortest_path(free, *query)) - 1

    def scipys(query: Query) -> int:
        (i, j), (k, m) = query
        return int(
            scipy_dijkstra(graph, indices=i * free.shape[1] + j, unweighted=True)[
                k * free.shape[1] + m
            ]
        )

    def networkxs(query: Query) -> int:
        return int(nx.dijkstra_path_length(network, *query))

    small = free.size < 10_000
    mine, lengths = median_ms(ours, queries, 20)
    scipy_ms, scipy_lengths = median_ms(scipys, queries, 20 if small else 3)
    few = queries if small else queries[:3]
    networkx_ms, networkx_lengths = median_ms(networkxs, few, 20 if small else 1)
    assert lengths == scipy_lengths
    assert lengths[: len(few)] == networkx_lengths
    cells = f"{free.shape[0]} x {free.shape[1]}"
    return (
        f"| {name} | {cells} | {mine:.3f} ms | {scipy_ms:.3f} ms ({scipy_ms / mine:.1f} x) "
        f"| {networkx_ms:.2f} ms ({networkx_ms / mine:.0f} x) |"
    )


def main() -> None:
    maps = [("the paper's grid", paper_grid())]
    if MAPS.is_dir():
        maps += [(name, read_map(MAPS / f"{name}.map")) for name in NAMES]
    else:
        maps.append(("generated, 30 % blocked", generated_map()))
    print("### Planner")
    print()
    print("| map | cells | Housefly | scipy csgraph | networkx |")
    print("|---|---|---|---|---|")
    for name, free in maps:
        print(row(name, free))
    print()
    print(
        f"Median over the {QUERIES} farthest of 60 random queries (networkx on large maps: 3) of"
        " one shortest path with 4 moves of unit cost, path included for Housefly, distances only"
        " for the others; their graphs are built beforehand, ours is the grid itself. All lengths"
        " are equal."
    )


if __name__ == "__main__":
    main()
