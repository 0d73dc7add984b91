"""Plans in words and numbers."""

from __future__ import annotations

from itertools import pairwise
from math import inf, nan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.geometry import distance
from housefly.pilot.planning.planner import path_clearance, path_length, plan
from housefly.pilot.planning.shortcut import sees, straightened
from housefly.room.bsen import bsen
from housefly.room.grid import Cell, OccupancyGrid, build_grid

BSEN = build_grid(bsen(), Site())
ENTRANCE = bsen().place("entrance").viewpoint


def grid_of(rows: str, resolution: float = 0.5) -> OccupancyGrid:
    """Return a grid drawn as text, +y up: . free, # occupied, v virtual, + inflated, x outside."""
    kinds = {
        ".": Cell.FREE,
        "#": Cell.OCCUPIED,
        "v": Cell.VIRTUAL,
        "+": Cell.INFLATED,
        "x": Cell.OUTSIDE,
    }
    lines = rows.split()
    cells = np.array(
        [[kinds[c] for c in line] for line in reversed(lines)], dtype=np.uint8
    ).T.copy()
    return OccupancyGrid((0.0, 0.0), resolution, cells, np.where(cells == Cell.FREE, 1.0, 0.0))


ROOM = grid_of("""
    xxxxxxxx
    ....#..x
    .vv.#..x
    ....#..x
    ++..#..x
    """)


@pytest.mark.parametrize(
    ("start", "goal", "words", "suggestion"),
    [
        ((0.25, 1.75), (2.25, 0.75), "goal (2.25, 0.75) m lies in an obstacle", (1.75, 0.75)),
        ((0.25, 1.75), (0.75, 1.25), "goal (0.75, 1.25) m lies in a no-fly area", (0.25, 1.25)),
        ((0.25, 1.75), (0.25, 0.25), "too close to an obstacle", (0.25, 0.75)),
        ((0.25, 1.75), (0.25, 2.25), "lies outside the room", (0.25, 1.75)),
        ((0.25, 1.75), (9.0, 0.25), "lies outside the map", (1.75, 0.25)),
        ((2.25, 0.75), (0.25, 1.75), "start (2.25, 0.75) m lies in an obstacle", (1.75, 0.75)),
        ((0.25, 1.75), (3.25, 1.75), "no free way", (1.75, 1.75)),
        ((0.25, 1.75), (nan, 1.0), "not a position", None),
        ((inf, 0.0), (0.25, 1.75), "not a position", None),
    ],
)
def test_where_there_is_no_path_there_is_a_reason_and_a_place_that_works(
    start: tuple[float, float],
    goal: tuple[float, float],
    words: str,
    suggestion: tuple[float, float] | None,
) -> None:
    answer = plan(ROOM, start, goal, 0.5)
    assert answer.path is None
    assert words in answer.reason
    assert answer.suggestion == (pytest.approx(suggestion) if suggestion else None)


def test_no_free_cell_at_all_means_no_suggestion() -> None:
    assert plan(grid_of("##"), (0.25, 0.25), (0.75, 0.25), 0.5).suggestion is None


points = st.tuples(st.floats(-1.0, 16.0), st.floats(-1.0, 9.0))


@settings(max_examples=80, deadline=None)
@given(points, points, st.booleans(), st.booleans())
def test_every_question_has_a_path_or_a_reason_never_an_error(
    start: tuple[float, float], goal: tuple[float, float], every_cell: bool, shortcut: bool
) -> None:
    answer = plan(BSEN, start, goal, 0.5, every_cell=every_cell, shortcut=shortcut)
    assert (answer.path is None) == bool(answer.reason)
    if answer.path is None:
        assert answer.suggestion is not None
        assert BSEN.is_free(BSEN.cell_of(answer.suggestion))
    else:
        assert answer.duration == pytest.approx(answer.path.length / 0.5)
        assert answer.path.length == pytest.approx(path_length(answer.path.waypoints))
        assert answer.path.clearance >= 0.49
        assert all(sees(BSEN, a, b) for a, b in pairwise(answer.path.waypoints))


@settings(max_examples=40, deadline=None)
@given(points, points)
def test_a_suggested_goal_can_be_flown_to(
    start: tuple[float, float], goal: tuple[float, float]
) -> None:
    answer = plan(BSEN, start, goal, 0.5)
    if answer.suggestion and BSEN.is_free(BSEN.cell_of(start)):
        assert plan(BSEN, start, answer.suggestion, 0.5).path is not None


@settings(max_examples=60, deadline=None)
@given(points)
def test_shortcuts_make_a_path_no_longer_and_keep_its_ends(goal: tuple[float, float]) -> None:
    cells = plan(BSEN, ENTRANCE, goal, 0.5, every_cell=True).path
    if cells:
        short = straightened(BSEN, cells.waypoints)
        assert path_length(short) <= cells.length + 1e-9
        assert (short[0], short[-1]) == (cells.waypoints[0], cells.waypoints[-1])
        assert path_length(short) >= distance(short[0], short[-1]) - 1e-9


def test_the_paper_gets_the_middle_of_every_cell() -> None:
    grid = build_grid(bsen(), changed(Site(), mode="paper"))
    path = plan(grid, bsen().home, ENTRANCE, 0.5, every_cell=True).path
    assert path is not None
    assert all(distance(a, b) == pytest.approx(0.5) for a, b in pairwise(path.waypoints))
    assert path.waypoints[-1] == grid.centre_of(grid.cell_of(ENTRANCE))
    assert path.length == pytest.approx(0.5 * (len(path.waypoints) - 1))


def test_without_every_cell_the_path_ends_at_the_goal_itself() -> None:
    goal = (2.53, 4.21)
    for shortcut in (False, True):
        path = plan(BSEN, bsen().home, goal, 0.5, shortcut=shortcut).path
        assert path is not None
        assert path.waypoints[-1] == goal


def test_a_goal_in_the_same_cell_is_a_path_too() -> None:
    answer = plan(BSEN, (2.52, 4.21), (2.57, 4.28), 0.5, shortcut=True)
    assert answer.path is not None
    assert answer.path.waypoints[-1] == (2.57, 4.28)


def touched(
    grid: OccupancyGrid, a: tuple[float, float], b: tuple[float, float]
) -> set[tuple[int, int]]:
    return {
        grid.cell_of((a[0] + (b[0] - a[0]) * k / 500, a[1] + (b[1] - a[1]) * k / 500))
        for k in range(501)
    }


@settings(max_examples=150, deadline=None)
@given(st.integers(0, 2**32 - 1), st.data())
def test_a_line_of_sight_touches_free_cells_only(seed: int, data: st.DataObject) -> None:
    cells = np.where(
        np.random.default_rng(seed).random((8, 6)) < 0.15, Cell.OCCUPIED, Cell.FREE
    ).astype(np.uint8)
    grid = OccupancyGrid((0.0, 0.0), 1.0, cells, np.ones((8, 6)))
    ends = st.tuples(st.floats(0.01, 7.99), st.floats(0.01, 5.99))
    a, b = data.draw(ends), data.draw(ends)
    sampled = all(grid.is_free(cell) for cell in touched(grid, a, b))
    if sees(grid, a, b):
        assert sampled
    assert sees(grid, a, b) == sees(grid, b, a)


def test_a_line_of_sight_does_not_slip_between_two_diagonal_obstacles() -> None:
    grid = grid_of(
        """
        .#
        #.
        """,
        1.0,
    )
    assert not sees(grid, (0.5, 1.5), (1.5, 0.5))


def test_clearance_is_the_smallest_along_the_way() -> None:
    clearance = np.array([[2.0], [0.7], [2.0]])
    grid = OccupancyGrid((0.0, 0.0), 1.0, np.zeros((3, 1), dtype=np.uint8), clearance)
    assert path_clearance(grid, ((0.5, 0.5), (2.5, 0.5))) == pytest.approx(0.7)
