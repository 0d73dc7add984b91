"""Depth images of walls and balls whose place is known."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import quaternion_from_euler, rotate
from housefly.messages import Pose
from housefly.perception.depth import Intrinsics, occupied_cells, points_of
from housefly.room.grid import OccupancyGrid

CAMERA = Intrinsics(200.0, 200.0, 79.5, 59.5)
SHAPE = (120, 160)
BAND = (0.85, 1.35)


def looking(yaw: float) -> tuple[float, float, float, float]:
    """Orientation of a level camera that looks along a heading: z forward, x right, y down."""
    w, _, _, z = quaternion_from_euler(0.0, 0.0, yaw)
    return (w + z) / 2, -(w + z) / 2, (w - z) / 2, (z - w) / 2


def grid() -> OccupancyGrid:
    return OccupancyGrid((-10.0, -10.0), 0.1, np.zeros((200, 200), np.uint8), np.ones((200, 200)))


@given(st.floats(-pi, pi))
def test_the_camera_of_these_tests_looks_where_it_should(yaw: float) -> None:
    q = looking(yaw)
    assert rotate(q, (0.0, 0.0, 1.0)) == pytest.approx((np.cos(yaw), np.sin(yaw), 0.0), abs=1e-9)
    assert rotate(q, (0.0, 1.0, 0.0)) == pytest.approx((0.0, 0.0, -1.0), abs=1e-9)


@given(
    yaw=st.floats(-pi, pi),
    depth=st.floats(0.5, 7.0),
    x=st.floats(-2.0, 2.0),
    y=st.floats(-2.0, 2.0),
)
def test_a_wall_before_the_camera_is_found_where_it_is(
    yaw: float, depth: float, x: float, y: float
) -> None:
    points = points_of(np.full(SHAPE, depth), CAMERA, Pose((x, y, 1.1), looking(yaw)))
    ahead = (points[:, 0] - x) * np.cos(yaw) + (points[:, 1] - y) * np.sin(yaw)
    assert np.allclose(ahead, depth, atol=1e-9)
    cells = occupied_cells(points, grid(), BAND, fewest=1)
    band = points[(points[:, 2] >= BAND[0]) & (points[:, 2] <= BAND[1])]
    assert len(band) and all(cells[grid().cell_of((px, py))] for px, py, _ in band[::97].tolist())
    assert cells.sum() <= len(band)


def test_what_is_below_or_above_the_flight_does_not_count() -> None:
    pose = Pose((0.0, 0.0, 0.3), looking(0.0))
    depth = np.full(SHAPE, 1.0)
    assert not occupied_cells(
        points_of(depth[40:80], Intrinsics(200.0, 200.0, 79.5, 19.5), pose), grid(), BAND
    ).any()


@given(st.sampled_from([np.nan, np.inf, -np.inf, 0.0, -3.0, 1e9]))
def test_pixels_without_a_depth_are_nothing(value: float) -> None:
    points = points_of(np.full(SHAPE, value), CAMERA, Pose((0.0, 0.0, 1.1), looking(0.0)))
    assert points.shape == (0, 3)
    assert not occupied_cells(points, grid(), BAND).any()


def test_single_points_are_noise() -> None:
    depth = np.full(SHAPE, np.nan)
    depth[60, 80] = 2.0
    points = points_of(depth, CAMERA, Pose((0.0, 0.0, 1.1), looking(0.0)))
    assert len(points) == 1 and not occupied_cells(points, grid(), BAND).any()
