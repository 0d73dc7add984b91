"""Straightened ways: never dearer, and through free voxels only."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from space_room import bsen_search, bsen_voxels, free_points, way_between

from housefly.pilot.planning.space.any_angle import taut
from housefly.pilot.planning.space.line_of_sight import line_cost, sees_in_space
from housefly.pilot.planning.space.search import CellSearch

Mask = np.ndarray


@st.composite
def ways(draw: st.DrawFn) -> tuple[Mask, Mask]:
    """Draw a small space and the middles of the voxels of a shortest way through it."""
    shape = draw(st.integers(3, 10)), draw(st.integers(3, 10)), draw(st.integers(2, 6))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    free = random.random(shape) >= draw(st.sampled_from((0.0, 0.15, 0.3)))
    start, goal = (tuple(int(random.integers(n)) for n in shape) for _ in range(2))
    free[start] = free[goal] = True
    cells = CellSearch(free).path(start, goal).cells
    assume(len(cells) > 1)
    return free, np.array(cells) + 0.5


def length_of(points: Mask) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


@settings(max_examples=100)
@given(ways())
def test_a_straightened_way_is_no_longer_and_touches_free_voxels_only(
    way: tuple[Mask, Mask],
) -> None:
    free, points = way
    short = taut(free, points)
    assert length_of(short) <= length_of(points) + 1e-9
    assert np.array_equal(short[[0, -1]], points[[0, -1]])
    for a, b in pairwise(short):
        shares = np.linspace(0.0, 1.0, 1500)[:, None]
        cells = np.floor(a + shares * (b - a)).astype(int)
        assert free[tuple(cells.T)].all()


@settings(max_examples=100)
@given(ways(), st.integers(0, 2**32 - 1))
def test_what_a_line_sees_is_what_points_on_it_meet(way: tuple[Mask, Mask], seed: int) -> None:
    free, _ = way
    random = np.random.default_rng(seed)
    a, b = (random.random(3) * free.shape for _ in range(2))
    cells = np.floor(a + np.linspace(0.0, 1.0, 4000)[:, None] * (b - a)).astype(int)
    met = free[tuple(np.minimum(cells, np.array(free.shape) - 1).T)].all()
    if sees_in_space(free, *a, *b):
        assert met
    if not met:
        assert not sees_in_space(free, *a, *b)


def test_in_empty_space_every_line_is_seen_and_none_outside() -> None:
    free = np.ones((6, 6, 6), dtype=bool)
    for a, b in np.random.default_rng(1).random((200, 2, 3)) * 5.9:
        assert sees_in_space(free, *a, *b)
    assert not sees_in_space(free, 1.0, 1.0, 1.0, 6.5, 1.0, 1.0)
    # A line along an edge touches the voxels on all its sides.
    free[2, 2, 2] = False
    assert not sees_in_space(free, 3.0, 3.0, 0.5, 3.0, 3.0, 5.5)


def test_a_line_costs_its_length_and_what_it_passes() -> None:
    weights = np.zeros((10, 4, 4))
    weights[5:] = 3.0
    none = np.zeros((0, 0, 0))
    assert line_cost(none, 0.5, 0.5, 0.5, 8.5, 0.5, 0.5) == pytest.approx(8.0)
    assert line_cost(weights, 1.0, 0.5, 0.5, 9.0, 0.5, 0.5) == pytest.approx(8.0 + 12.0, abs=1.6)


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1))
def test_in_a_room_a_way_keeps_the_distance_wherever_it_goes(seed: int) -> None:
    start, goal = free_points(seed, 2)
    corners, voxels = way_between(start, goal), bsen_voxels()
    scaled = (corners - np.array(voxels.origin)) / voxels.resolution
    assert bsen_search().free.shape == voxels.shape
    for a, b in pairwise(scaled):
        cells = np.floor(a + np.linspace(0.0, 1.0, 600)[:, None] * (b - a)).astype(int)
        assert (voxels.clearance[tuple(cells.T)] >= np.float32(voxels.keep)).all()
