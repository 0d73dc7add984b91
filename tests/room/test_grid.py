"""The occupancy grid against brute force, against MuJoCo, and under changes of its settings."""

from __future__ import annotations

from itertools import pairwise
from math import cos, hypot, pi, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.map import VirtualObstacle
from housefly.config.site import Site, changed
from housefly.room.bsen import bsen
from housefly.room.distance import clearance_field, covered_shares, footprints
from housefly.room.grid import Cell, build_grid, inflation
from housefly.room.model import Place, Room, Shape, Solid

HOME = (0.5, 0.5)


def room_of(*solids: Solid) -> Room:
    return Room(
        "test", (0.0, 0.0, 6.0, 4.0), 2.5, solids, (Place("home", HOME, (1.0, 0.5, 1.0)),), (), HOME
    )


def solid(
    shape: Shape, x: float, y: float, length: float, width: float, yaw: float, name: str = "thing"
) -> Solid:
    size = (length, length, 2.5) if shape is Shape.CYLINDER else (length, width, 2.5)
    return Solid(name, name, shape, (x, y, 1.25), size, yaw)


shapes = st.builds(
    solid,
    st.sampled_from(Shape),
    st.floats(2.0, 5.5),
    st.floats(1.5, 3.5),
    st.floats(0.05, 1.5),
    st.floats(0.05, 1.5),
    st.floats(-pi, pi),
)


def inside(item: Solid, x: float, y: float) -> bool:
    dx, dy = x - item.position[0], y - item.position[1]
    if item.shape is Shape.CYLINDER:
        return hypot(dx, dy) <= item.size[0] / 2
    u, v = dx * cos(item.yaw) + dy * sin(item.yaw), -dx * sin(item.yaw) + dy * cos(item.yaw)
    return abs(u) <= item.size[0] / 2 and abs(v) <= item.size[1] / 2


def edge_points(item: Solid) -> np.ndarray:
    t = np.linspace(0.0, 1.0, 400, endpoint=False)
    a, b = item.size[0] / 2, item.size[1] / 2
    if item.shape is Shape.CYLINDER:
        local = np.column_stack([a * np.cos(2 * pi * t), a * np.sin(2 * pi * t)])
    else:
        corners = np.array([(-a, -b), (a, -b), (a, b), (-a, b), (-a, -b)])
        local = np.vstack([p + (q - p) * t[:, None] for p, q in pairwise(corners)])
    turn = np.array([[cos(item.yaw), sin(item.yaw)], [-sin(item.yaw), cos(item.yaw)]])
    return local @ turn + np.array(item.position[:2])


@settings(max_examples=60, deadline=None)
@given(shapes, st.floats(0.0, 6.0), st.floats(0.0, 4.0))
def test_clearance_is_the_distance_to_the_nearest_edge_point(
    item: Solid, x: float, y: float
) -> None:
    field = clearance_field(footprints([item], 0.8, 1.4), np.array([x]), np.array([y]), 100.0)[0, 0]
    if inside(item, x, y):
        assert field == pytest.approx(0.0, abs=1e-9)
    else:
        sampled = np.hypot(*(edge_points(item) - (x, y)).T).min()
        assert field <= sampled + 1e-9
        assert field == pytest.approx(sampled, abs=0.02)


@settings(max_examples=40, deadline=None)
@given(st.lists(shapes, min_size=1, max_size=4), st.sampled_from((0.1, 0.25, 0.5)))
def test_covered_share_is_that_of_many_sample_points(items: list[Solid], edge: float) -> None:
    xs, ys = np.array([3.0, 3.0 + edge]), np.array([2.0])
    rows = footprints(items, 0.8, 1.4)
    shares = covered_shares(rows, xs, ys, edge, clearance_field(rows, xs, ys, 10.0))
    offsets = (np.arange(24) + 0.5) / 24 * edge - edge / 2
    for i, x in enumerate(xs):
        brute = np.mean(
            [
                any(inside(item, x + u, ys[0] + v) for item in items)
                for u in offsets
                for v in offsets
            ]
        )
        assert shares[i, 0] == pytest.approx(brute, abs=0.13)


@settings(max_examples=25, deadline=None)
@given(st.lists(shapes, min_size=1, max_size=5), st.floats(0.0, 0.3), st.floats(0.0, 0.3))
def test_more_margin_never_frees_a_cell(items: list[Solid], less: float, more: float) -> None:
    room = room_of(*items)
    small = build_grid(room, changed(Site(), map__margin=min(less, more)))
    large = build_grid(room, changed(Site(), map__margin=max(less, more)))
    assert not np.any((large.cells == Cell.FREE) & (small.cells != Cell.FREE))


@settings(max_examples=25, deadline=None)
@given(st.lists(shapes, min_size=1, max_size=5))
def test_a_free_cell_keeps_the_whole_inflation_from_every_obstacle(items: list[Solid]) -> None:
    grid = build_grid(room_of(*items), Site())
    free = np.argwhere(grid.cells == Cell.FREE)
    edges = np.vstack([edge_points(item) for item in items])
    for cell in free[:: max(1, len(free) // 60)]:
        centre = grid.centre_of((int(cell[0]), int(cell[1])))
        assert np.hypot(*(edges - centre).T).min() >= inflation(Site()) - 1e-9


@given(st.integers(0, 24), st.integers(0, 8))
def test_cell_and_centre_are_inverse(i: int, j: int) -> None:
    grid = build_grid(bsen(), changed(Site(), mode="paper"))
    assert grid.cell_of(grid.centre_of((i, j))) == (i, j)


@pytest.mark.parametrize("thickness", [0.001, 0.02, 0.1])
@pytest.mark.parametrize("yaw", [0.0, 0.3, pi / 4])
def test_no_wall_is_too_thin_to_close_a_room(thickness: float, yaw: float) -> None:
    wall = solid(Shape.BOX, 3.0, 2.0, 12.0, thickness, pi / 2 + yaw)
    grid = build_grid(room_of(wall), Site())
    assert grid.kind(grid.cell_of((0.5, 0.5))) is Cell.FREE
    assert grid.kind(grid.cell_of((5.6, 2.0))) is Cell.OUTSIDE


def test_only_what_stands_at_flight_height_counts() -> None:
    low = Solid("bed", "bed", Shape.BOX, (3.0, 2.0, 0.25), (1.0, 1.0, 0.5))
    lamp = Solid("lamp", "lamp", Shape.BOX, (3.0, 2.0, 2.2), (1.0, 1.0, 0.3))
    carpet = Solid("rug", "rug", Shape.BOX, (3.0, 2.0, 1.0), (1.0, 1.0, 2.0), collides=False)
    grid = build_grid(room_of(low, lamp, carpet), Site())
    assert np.all(grid.cells == Cell.FREE)


def test_virtual_obstacles_bound_the_middle_of_the_drone_and_do_not_grow() -> None:
    obstacle = VirtualObstacle(rectangle=(2.0, 1.0, 3.0, 2.0), reason="a vase")
    site = Site(map={"virtual_obstacles": [obstacle.model_dump()]})  # type: ignore[arg-type]
    grid = build_grid(room_of(), site)
    assert grid.kind(grid.cell_of((2.05, 1.05))) is Cell.VIRTUAL
    assert grid.kind(grid.cell_of((1.95, 1.05))) is Cell.FREE
    assert int((grid.cells == Cell.VIRTUAL).sum()) == 100


def test_the_paper_grid_has_25_by_9_cells_and_inflates_nothing() -> None:
    grid = build_grid(bsen(), changed(Site(), mode="paper"))
    assert grid.shape == (25, 9)
    assert not np.any(grid.cells == Cell.INFLATED)
    corridor = [grid.kind(grid.cell_of((2.55 + 0.5 * k, 4.25))) for k in range(5)]
    assert corridor == [Cell.FREE] * 5


def test_the_grid_is_read_only() -> None:
    grid = build_grid(bsen(), Site())
    with pytest.raises(ValueError, match="read-only"):
        grid.cells[0, 0] = 0


@pytest.mark.parametrize(
    "point", [(float("nan"), 0.0), (float("inf"), 0.0), (-5.0, 2.0), (99.0, 2.0)]
)
def test_points_off_the_map_are_outside(point: tuple[float, float]) -> None:
    grid = build_grid(bsen(), Site())
    assert grid.kind(grid.cell_of(point)) is Cell.OUTSIDE
    assert not grid.is_free(grid.cell_of(point))


@pytest.mark.parametrize("name", [place.name for place in bsen().places])
def test_every_place_of_bsen_is_free_in_both_modes(name: str) -> None:
    place = bsen().place(name)
    for mode in ("default", "paper"):
        grid = build_grid(bsen(), changed(Site(), mode=mode))
        assert grid.is_free(grid.cell_of(place.viewpoint))
