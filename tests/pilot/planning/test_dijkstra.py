"""Shortest paths against two independent libraries, and the order of ties."""

from __future__ import annotations

from itertools import pairwise

import networkx as nx
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra as scipy_dijkstra

from housefly.pilot.planning.dijkstra import UNREACHED, distances, shortest_path

Mask = np.ndarray


@st.composite
def mazes(draw: st.DrawFn) -> tuple[Mask, tuple[int, int], tuple[int, int]]:
    """Draw a random grid with two free cells in it; dense ones are often unreachable."""
    nx_, ny_ = draw(st.integers(1, 14)), draw(st.integers(1, 14))
    share = draw(st.sampled_from((0.0, 0.2, 0.35, 0.5)))
    seed = draw(st.integers(0, 2**32 - 1))
    free = np.random.default_rng(seed).random((nx_, ny_)) >= share
    start = draw(st.integers(0, nx_ - 1)), draw(st.integers(0, ny_ - 1))
    goal = draw(st.integers(0, nx_ - 1)), draw(st.integers(0, ny_ - 1))
    free[start] = free[goal] = True
    return free, start, goal


def by_networkx(free: Mask, start: tuple[int, int]) -> dict[tuple[int, int], int]:
    graph = nx.grid_2d_graph(*free.shape)
    graph.remove_nodes_from([tuple(cell) for cell in np.argwhere(~free)])
    return dict(nx.single_source_shortest_path_length(graph, start))


def by_scipy(free: Mask, start: tuple[int, int]) -> np.ndarray:
    index = np.arange(free.size).reshape(free.shape)
    pairs = []
    for a, b in ((np.s_[:-1, :], np.s_[1:, :]), (np.s_[:, :-1], np.s_[:, 1:])):
        both = free[a] & free[b]
        pairs += [(index[a][both], index[b][both]), (index[b][both], index[a][both])]
    rows, columns = np.concatenate([p[0] for p in pairs]), np.concatenate([p[1] for p in pairs])
    graph = coo_array((np.ones(rows.size), (rows, columns)), shape=(free.size, free.size)).tocsr()
    return scipy_dijkstra(graph, indices=int(index[start])).reshape(free.shape)


@settings(max_examples=200, deadline=None)
@given(mazes())
def test_distances_equal_those_of_networkx_and_scipy(
    maze: tuple[Mask, tuple[int, int], tuple[int, int]],
) -> None:
    free, start, _ = maze
    ours = distances(free, start)
    theirs = by_networkx(free, start)
    scipys = by_scipy(free, start)
    for cell in np.ndindex(free.shape):
        assert ours[cell] == theirs.get(cell, UNREACHED)
        assert (
            (ours[cell] == scipys[cell]) if np.isfinite(scipys[cell]) else (ours[cell] == UNREACHED)
        )


@settings(max_examples=200, deadline=None)
@given(mazes())
def test_a_path_is_legal_and_as_long_as_the_independent_answer(
    maze: tuple[Mask, tuple[int, int], tuple[int, int]],
) -> None:
    free, start, goal = maze
    path = shortest_path(free, start, goal)
    expected = by_networkx(free, start).get(goal)
    if expected is None:
        assert path == ()
        return
    assert len(path) == expected + 1
    assert (path[0], path[-1]) == (start, goal)
    assert all(free[cell] for cell in path)
    assert all(abs(a[0] - b[0]) + abs(a[1] - b[1]) == 1 for a, b in pairwise(path))


def test_ties_are_settled_by_the_documented_order_every_time() -> None:
    free = np.ones((6, 5), dtype=bool)
    path = shortest_path(free, (1, 1), (4, 3))
    assert path == shortest_path(free.copy(), (1, 1), (4, 3))
    # Walking back from the goal, +x and +y lead away; -x comes before -y; then straight on as long
    # as it is a shortest way.
    assert path == ((1, 1), (1, 2), (1, 3), (2, 3), (3, 3), (4, 3))


def test_a_path_turns_only_where_it_must() -> None:
    free = np.ones((20, 20), dtype=bool)
    path = shortest_path(free, (2, 3), (17, 15))
    turns = sum(
        (b[0] - a[0], b[1] - a[1]) != (c[0] - b[0], c[1] - b[1])
        for a, b, c in zip(path, path[1:], path[2:], strict=False)
    )
    assert turns == 1


def test_a_blocked_goal_has_no_path_and_a_single_cell_is_its_own_path() -> None:
    free = np.array([[True, False]])
    assert shortest_path(free, (0, 0), (0, 1)) == ()
    assert shortest_path(free, (0, 0), (0, 0)) == ((0, 0),)
