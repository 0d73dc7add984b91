"""Shortest ways in the plane and in space against an independent library and known answers."""

from __future__ import annotations

from itertools import islice, pairwise, product
from math import inf, sqrt
from pathlib import Path

import numpy as np
import pytest
from benchmark_maps import (
    Query,
    dynamic_queries,
    grid_queries,
    read_grid,
    read_voxels,
    voxel_queries,
)
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from housefly.pilot.planning.space.astar import octile_distance
from housefly.pilot.planning.space.search import CellSearch

Mask = np.ndarray
GRIDS = ("32room_000", "8room_000", "maze512-1-0", "maze512-8-0", "random512-40-0")
VOXELS = ("Simple", "Complex")


@st.composite
def questions(draw: st.DrawFn) -> tuple[Mask, Mask | None, tuple[int, ...], tuple[int, ...]]:
    """Draw a grid in the plane or in space, weights or none, and two free cells."""
    deep = draw(st.sampled_from((1, 5)))
    shape = draw(st.integers(1, 7)), draw(st.integers(1, 7)), deep
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    free = random.random(shape) >= draw(st.sampled_from((0.0, 0.2, 0.4)))
    start, goal = (tuple(int(random.integers(n)) for n in shape) for _ in range(2))
    free[start] = free[goal] = True
    weighted = draw(st.booleans())
    weights = random.random(shape) * draw(st.sampled_from((0.5, 20.0))) if weighted else None
    return free, weights, start, goal


def lengths_by_scipy(free: Mask, weights: Mask | None, start: tuple[int, ...]) -> Mask:
    """Return the length of a shortest way to each cell; a move needs its whole box free."""
    index, edges = np.arange(free.size).reshape(free.shape), []
    for cell in np.argwhere(free):
        for step in product((-1, 0, 1), repeat=3):
            to = cell + step
            if not any(step) or (to < 0).any() or (to >= free.shape).any():
                continue
            low, high = np.minimum(cell, to), np.maximum(cell, to) + 1
            if free[tuple(slice(a, b) for a, b in zip(low, high, strict=True))].all():
                ends = tuple(cell), tuple(to)
                cost = sqrt(sum(map(abs, step)))
                if weights is not None:
                    cost *= 1.0 + 0.5 * (weights[ends[0]] + weights[ends[1]])
                edges.append((index[ends[0]], index[ends[1]], cost))
    rows, columns, costs = zip(*edges, strict=True) if edges else ((), (), ())
    graph = coo_array((costs, (rows, columns)), shape=(free.size, free.size)).tocsr()
    return dijkstra(graph, indices=int(index[start])).reshape(free.shape)


@settings(max_examples=60)
@given(questions())
def test_a_way_is_legal_and_as_short_as_the_independent_answer(
    question: tuple[Mask, Mask | None, tuple[int, int, int], tuple[int, int, int]],
) -> None:
    free, weights, start, goal = question
    found = CellSearch(free, weights).path(start, goal)
    expected = lengths_by_scipy(free, weights, start)[goal]
    assert found.cost == pytest.approx(expected, abs=1e-9)
    if expected == inf:
        assert found.cells == ()
        return
    assert (found.cells[0], found.cells[-1]) == (start, goal)
    for a, b in pairwise(found.cells):
        assert max(abs(p - q) for p, q in zip(a, b, strict=True)) == 1
        box = tuple(slice(min(p, q), max(p, q) + 1) for p, q in zip(a, b, strict=True))
        assert free[box].all()


def test_the_arrays_of_one_search_do_not_show_in_the_next() -> None:
    free = np.random.default_rng(2).random((9, 9, 9)) > 0.25
    free[0, 0, 0] = free[8, 8, 8] = free[0, 8, 0] = True
    search = CellSearch(free)
    first = search.path((0, 0, 0), (8, 8, 8))
    search.path((0, 8, 0), (8, 8, 8))
    assert search.path((0, 0, 0), (8, 8, 8)) == first == CellSearch(free).path((0, 0, 0), (8, 8, 8))


def test_a_blocked_end_has_no_way_and_a_cell_is_its_own_way() -> None:
    search = CellSearch(np.array([[[True], [False]]]))
    assert search.path((0, 0, 0), (0, 1, 0)).cells == ()
    assert search.path((0, 0, 0), (0, 0, 0)).cells == ((0, 0, 0),)
    assert search.path((0, 0, 0), (0, 0, -5)).cells == search.path((9, 0, 0), (0, 0, 0)).cells == ()


@given(st.tuples(*[st.integers(0, 300)] * 3))
def test_the_octile_distance_is_that_of_diagonals_first(counts: tuple[int, int, int]) -> None:
    low, middle, high = sorted(counts)
    expected = sqrt(3) * low + sqrt(2) * (middle - low) + (high - middle)
    assert octile_distance(*counts) == pytest.approx(expected)


def wrong_answers(search: CellSearch, queries: list[Query]) -> list[Query]:
    return [q for q in queries if not q.agrees(search.path(q.start, q.goal).cost)]


@pytest.mark.parametrize("name", GRIDS)
def test_some_lengths_on_the_grids_of_the_benchmark_are_optimal(
    name: str, shared_data: Path
) -> None:
    folder = shared_data / "maps" / "grid2d"
    queries = list(grid_queries(folder / f"{name}.map.scen"))
    some = queries[:: max(1, len(queries) // 30)]
    assert not wrong_answers(CellSearch(read_grid(folder / f"{name}.map")), some)


def test_some_lengths_among_the_voxels_of_the_benchmark_are_optimal(shared_data: Path) -> None:
    folder = shared_data / "maps" / "voxel3d"
    queries = list(voxel_queries(folder / "Simple.3dmap.3dscen"))[::100]
    assert not wrong_answers(CellSearch(read_voxels(folder / "Simple.3dmap")), queries)


def test_some_lengths_on_a_map_that_changes_are_optimal(shared_data: Path) -> None:
    for free, query in islice(dynamic_queries(shared_data / "maps" / "dynamic2d"), 0, None, 40):
        assert query.agrees(CellSearch(free).path(query.start, query.goal).cost)


@pytest.mark.safety
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", GRIDS)
def test_all_lengths_on_the_grids_of_the_benchmark_are_optimal(
    name: str, shared_data: Path
) -> None:
    folder = shared_data / "maps" / "grid2d"
    queries = list(grid_queries(folder / f"{name}.map.scen"))
    assert not wrong_answers(CellSearch(read_grid(folder / f"{name}.map")), queries)


@pytest.mark.safety
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", VOXELS)
def test_all_lengths_among_the_voxels_of_the_benchmark_are_optimal(
    name: str, shared_data: Path
) -> None:
    folder = shared_data / "maps" / "voxel3d"
    queries = list(voxel_queries(folder / f"{name}.3dmap.3dscen"))
    assert len(queries) == 10_000
    assert not wrong_answers(CellSearch(read_voxels(folder / f"{name}.3dmap")), queries)


@pytest.mark.safety
@pytest.mark.timeout(1800)
def test_all_lengths_on_a_map_that_changes_are_optimal(shared_data: Path) -> None:
    known: tuple[Mask, CellSearch] | None = None
    count = 0
    for free, query in dynamic_queries(shared_data / "maps" / "dynamic2d"):
        if known is None or known[0] is not free:
            known = free, CellSearch(free)
        assert query.agrees(known[1].path(query.start, query.goal).cost)
        count += 1
    assert count == 2000
