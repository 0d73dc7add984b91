"""Clearance in space against the definition, with nothing left out."""

from __future__ import annotations

from math import hypot, inf

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from space_room import ARDRONE, KEEP, bsen_voxels

from housefly.config.site import Site, changed
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.solid_rows import live_rows, room_rows
from housefly.pilot.planning.space.voxels import CLEARANCE_CAP, VoxelMap, voxel_map, with_rows
from housefly.room.bsen import bsen
from housefly.room.grid import build_grid

HULLS = st.builds(HullCylinder, st.floats(0.0, 0.5), st.floats(0.0, 0.3))
OBSTACLES = st.builds(
    Obstacle,
    id=st.just("thing"),
    position=st.tuples(st.floats(-1.0, 3.0), st.floats(-1.0, 3.0)),
    radius=st.floats(0.0, 0.4),
    size=st.tuples(st.floats(0.0, 1.5), st.floats(0.0, 1.5)),
    yaw=st.floats(-3.2, 3.2),
    bottom=st.floats(-0.5, 1.0),
    top=st.floats(1.0, 2.0),
    velocity=st.sampled_from(((0.0, 0.0), (0.6, -0.3))),
    kind=st.sampled_from(ObstacleKind),
)


def empty(hull: HullCylinder) -> VoxelMap:
    shape = (12, 10, 9)
    return VoxelMap(
        (0.0, 0.0, 0.0),
        0.2,
        hull,
        KEEP,
        np.full(shape, CLEARANCE_CAP, dtype=np.float32),
        np.ones(shape, dtype=np.bool_),
    )


def gap_by_definition(row: FloatArray, point: tuple[float, ...], hull: HullCylinder) -> float:
    """Return the gap between hull and row, by looking along the way that the row moves."""
    x, y, z = point
    shares = np.linspace(0.0, 1.0, 401)
    dx, dy = x - row[0] - shares * row[7], y - row[1] - shares * row[8]
    u, v = dx * row[4] + dy * row[5], -dx * row[5] + dy * row[4]
    aside = np.hypot(np.maximum(abs(u) - row[2], 0.0), np.maximum(abs(v) - row[3], 0.0)) - row[6]
    beside = max(float(aside.min()) - hull.radius, 0.0)
    above = max(row[9] - (z + hull.half_height), (z - hull.half_height) - row[10], 0.0)
    return min(hypot(beside, above), CLEARANCE_CAP)


@settings(max_examples=40)
@given(st.lists(OBSTACLES, max_size=3), HULLS)
def test_the_clearance_of_every_voxel_is_that_of_the_definition(
    obstacles: list[Obstacle], hull: HullCylinder
) -> None:
    rows = live_rows(obstacles, 0.0, 1.0)
    voxels = with_rows(empty(hull), rows)
    random = np.random.default_rng(len(obstacles))
    for i, j, k in random.integers((0, 0, 0), voxels.shape, size=(25, 3)).tolist():
        point = voxels.middle_of((i, j, k))
        expected = min((gap_by_definition(row, point, hull) for row in rows), default=1.0)
        assert voxels.clearance[i, j, k] == pytest.approx(min(expected, CLEARANCE_CAP), abs=2e-3)


@settings(max_examples=25)
@given(st.lists(OBSTACLES, max_size=4), HULLS)
def test_what_comes_later_changes_only_what_it_is_near_to(
    obstacles: list[Obstacle], hull: HullCylinder
) -> None:
    rows = live_rows(obstacles, 0.0, 0.5)
    at_once = with_rows(empty(hull), rows)
    one_by_one = empty(hull)
    for row in rows[::-1]:
        one_by_one = with_rows(one_by_one, row[None, :])
    assert np.array_equal(at_once.clearance, one_by_one.clearance)


def test_nobody_is_flown_over_but_a_table_is() -> None:
    voxels = empty(ARDRONE)
    person = Obstacle("visitor", (1.1, 1.1), 0.25, top=1.2, kind=ObstacleKind.PERSON)
    table = Obstacle("table", (1.1, 1.1), 0.0, (0.8, 0.8), top=0.7)
    over_person = with_rows(voxels, live_rows([person], 0.0, 0.0)).free()
    over_table = with_rows(voxels, live_rows([table], 0.0, 0.0)).free()
    assert not over_person[5, 5, :].any()
    assert not over_table[5, 5, :4].any()
    assert over_table[5, 5, 5:].all()


def test_a_place_at_flight_height_has_no_more_clearance_than_on_the_map_of_today() -> None:
    # A height in the middle of a layer of voxels.
    site, hull = changed(Site(), map__flight_height=1.15), HullCylinder(0.343, 0.25)
    grid = build_grid(bsen(), site)
    voxels = voxel_map(bsen(), site.map.resolution, hull, KEEP)
    level = voxels.voxel_of((1.0, 1.0, site.map.flight_height))[2]
    flat = np.clip(grid.clearance - hull.radius, 0.0, CLEARANCE_CAP)
    assert (voxels.clearance[:, :, level] <= flat + 1e-6).all()
    assert (voxels.clearance[:, :, level] > flat - 1e-6).mean() > 0.3


def test_the_exact_clearance_along_a_line_changes_no_faster_than_the_line() -> None:
    rows = room_rows(bsen())
    points = np.stack(
        [np.linspace(1.0, 14.0, 400), np.full(400, 4.2), np.linspace(1.0, 1.5, 400)], axis=1
    )
    near = hull_clearances(rows, points, ARDRONE, 5.0)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert (np.abs(np.diff(near)) <= steps + 1e-9).all()
    middles = np.array([bsen_voxels().middle_of((i, 40, 12)) for i in range(30, 120)])
    exact = hull_clearances(rows, middles, ARDRONE, CLEARANCE_CAP)
    stored = [bsen_voxels().clearance[i, 40, 12] for i in range(30, 120)]
    assert np.abs(exact - stored).max() < 1e-6


def test_points_of_no_room_are_in_no_voxel() -> None:
    voxels = bsen_voxels()
    assert not voxels.contains(voxels.voxel_of((inf, 1.0, 1.0)))
    assert not voxels.contains(voxels.voxel_of((1.0, -0.01, 1.0)))
    assert voxels.contains(voxels.voxel_of((0.0, 7.99, 2.69)))
