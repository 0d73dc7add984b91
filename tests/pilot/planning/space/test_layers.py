"""Volumes, reach and layers of cost: what closes voxels, and what makes them dear."""

from __future__ import annotations

from math import inf

import numpy as np
from space_room import bsen_search, bsen_voxels

from housefly.pilot.planning.space.costs import blindness, height_wish, narrowness
from housefly.pilot.planning.space.reachability import within_reach
from housefly.pilot.planning.space.search import CellSearch
from housefly.pilot.planning.space.volumes import (
    Volume,
    VolumeKind,
    in_volume,
    within_volumes,
)
from housefly.room.bsen import bsen

TRIANGLE = ((6.0, 3.0), (9.0, 3.0), (6.0, 5.0))


def test_a_volume_holds_the_voxels_whose_middles_lie_in_it() -> None:
    voxels = bsen_voxels()
    inside = in_volume(voxels, Volume(VolumeKind.KEEP_OUT, TRIANGLE, 0.5, 1.5))
    for i, j, k in np.random.default_rng(3).integers((55, 25, 0), (95, 55, 27), (300, 3)).tolist():
        x, y, z = voxels.middle_of((i, j, k))
        expected = x > 6.0 and y > 3.0 and (x - 6.0) / 3.0 + (y - 3.0) / 2.0 < 1.0
        assert inside[i, j, k] == (expected and 0.5 <= z <= 1.5)
    turned = in_volume(voxels, Volume(VolumeKind.KEEP_OUT, TRIANGLE[::-1], 0.5, 1.5))
    assert np.array_equal(inside, turned)


def test_keep_out_closes_keep_in_closes_the_rest_and_slow_closes_nothing() -> None:
    voxels = bsen_voxels()
    out, kept, slow = (
        Volume(kind, TRIANGLE, 0.0, inf, speed=0.3)
        for kind in (VolumeKind.KEEP_OUT, VolumeKind.KEEP_IN, VolumeKind.SLOW)
    )
    inside = in_volume(voxels, out)
    assert np.array_equal(within_volumes(voxels, [out]).free(), voxels.free() & ~inside)
    assert np.array_equal(within_volumes(voxels, [kept]).free(), voxels.free() & inside)
    assert np.array_equal(within_volumes(voxels, [slow]).free(), voxels.free())


def test_what_is_within_reach_has_a_way_from_home_and_the_rest_has_none() -> None:
    voxels = bsen_voxels()
    (x, y), search = bsen().home, CellSearch(voxels.free())
    home = voxels.voxel_of((x, y, 1.1))
    everything = within_reach(voxels, bsen().home).free()
    assert np.array_equal(everything, voxels.free())
    for i, j, k in np.argwhere(voxels.free())[::9001].tolist():
        assert search.path(home, (i, j, k)).cells
    walled = within_volumes(
        voxels, [Volume(VolumeKind.KEEP_OUT, ((4.0, 0.0), (4.3, 0.0), (4.3, 8.0), (4.0, 8.0)))]
    )
    assert not within_reach(walled, bsen().home).free()[:40].any()


def test_layers_are_nothing_where_there_is_nothing_to_avoid() -> None:
    voxels = bsen_voxels()
    narrow, height = narrowness(voxels, 0.35, 2.0), height_wish(voxels, 1.15, 0.5)
    assert (narrow[voxels.clearance >= 0.35] == 0.0).all()
    assert narrow.max() <= 2.0
    assert height[0, 0, 11] < 1e-9 < height[0, 0, 12]
    blind = blindness(voxels, bsen(), 1.5)
    assert blind.shape == voxels.shape
    assert 0.0 <= blind.min() < blind.max() <= 1.5
    assert bsen_search().weights is not None
