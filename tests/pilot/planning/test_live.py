"""The map of this moment: what obstacles close, what a path may still do, and that nothing stays
behind.
"""

from __future__ import annotations

from math import cos, hypot, inf, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import Vec2, rotate
from housefly.geometry import quaternion_from_euler as turned
from housefly.messages import Obstacle
from housefly.pilot.planning.live import distances_for, first_block, gap, live_grid
from housefly.pilot.planning.obstacles import obstacle_rows
from housefly.pilot.planning.planner import plan
from housefly.room.grid import Cell, OccupancyGrid

BAND = (0.85, 1.35)
KEEP, GIVE = 0.5, 0.1
EDGES = (0.1, 0.25, 0.5)


def hall(edge: float = 0.1) -> OccupancyGrid:
    """A hall of 8 m by 4 m with a block, some of it closed in every way that a cell can be."""
    nx, ny = round(8.0 / edge), round(4.0 / edge)
    cells = np.zeros((nx, ny), dtype=np.uint8)
    cells[: nx // 10, :] = Cell.OUTSIDE
    cells[:, ny - 2 :] = Cell.VIRTUAL
    cells[nx // 2, : ny // 3] = Cell.OCCUPIED
    return OccupancyGrid((0.0, 0.0), edge, cells, np.full((nx, ny), 2.0))


def rows(*obstacles: Obstacle, now: float = 0.0, horizon: float = 0.0) -> np.ndarray:
    return obstacle_rows(obstacles, now, horizon, BAND)[0]


finite = st.floats(-1.0, 9.0)
discs = st.builds(
    Obstacle, id=st.just("o"), position=st.tuples(finite, finite), radius=st.floats(0.0, 1.5)
)
boxes = st.builds(
    Obstacle,
    id=st.just("o"),
    position=st.tuples(finite, finite),
    radius=st.floats(0.0, 0.5),
    size=st.tuples(st.floats(0.0, 2.0), st.floats(0.0, 2.0)),
    yaw=st.floats(-pi, pi),
)
walkers = st.builds(
    Obstacle,
    id=st.just("o"),
    position=st.tuples(finite, finite),
    radius=st.floats(0.0, 1.0),
    size=st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 1.0)),
    yaw=st.floats(-pi, pi),
    velocity=st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)),
)
unit = st.floats(0.0, 1.0)


@given(st.lists(discs, max_size=4), st.sampled_from(EDGES), unit, unit)
def test_the_closed_cells_of_a_disc_always_cover_it(
    obstacles: list[Obstacle], edge: float, part: float, turn: float
) -> None:
    static = hall(edge)
    grid = live_grid(static, rows(*obstacles), distances_for(KEEP, GIVE, edge).reach)
    for o in obstacles:
        r = part * o.radius
        cell = grid.cell_of(
            (o.position[0] + r * cos(2 * pi * turn), o.position[1] + r * sin(2 * pi * turn))
        )
        if grid.contains(cell):
            assert grid.kind(cell) in (Cell.OCCUPIED, Cell.OUTSIDE)


@given(walkers, unit, unit, unit, unit)
def test_every_place_that_an_obstacle_may_reach_is_closed(
    o: Obstacle, u: float, v: float, when: float, turn: float
) -> None:
    grid = live_grid(hall(), rows(o, horizon=1.5), distances_for(KEEP, GIVE, 0.1).reach)
    corner = rotate(turned(0.0, 0.0, o.yaw), ((u - 0.5) * o.size[0], (v - 0.5) * o.size[1], 0.0))
    x = o.position[0] + corner[0] + o.radius * cos(2 * pi * turn) + 1.5 * when * o.velocity[0]
    y = o.position[1] + corner[1] + o.radius * sin(2 * pi * turn) + 1.5 * when * o.velocity[1]
    assert not grid.is_free(grid.cell_of((x, y)))


@given(st.lists(discs | boxes | walkers, max_size=5), st.sampled_from(EDGES))
def test_obstacles_only_close_cells_and_removing_them_gives_the_rooms_grid_bit_for_bit(
    obstacles: list[Obstacle], edge: float
) -> None:
    static = hall(edge)
    cells, clearance = static.cells.tobytes(), static.clearance.tobytes()
    grid = live_grid(static, rows(*obstacles), distances_for(KEEP, GIVE, edge).reach)
    assert not ((grid.cells == Cell.FREE) & (static.cells != Cell.FREE)).any()
    assert (grid.clearance <= static.clearance).all()
    assert live_grid(static, rows(), 0.5) is static
    assert (static.cells.tobytes(), static.clearance.tobytes()) == (cells, clearance)


@given(boxes, finite, finite)
def test_the_gap_to_a_rectangle_is_that_of_its_nearest_point(
    o: Obstacle, x: float, y: float
) -> None:
    (row,) = rows(o)
    best = inf
    for u in np.linspace(-0.5, 0.5, 21):
        for v in np.linspace(-0.5, 0.5, 21):
            cx, cy, _ = rotate(turned(0.0, 0.0, o.yaw), (u * o.size[0], v * o.size[1], 0.0))
            best = min(best, hypot(x - o.position[0] - cx, y - o.position[1] - cy))
    step = hypot(*o.size) / 40.0
    assert gap(row, x, y) <= max(best - o.radius, 0.0) + 1e-9
    assert gap(row, x, y) >= max(best - o.radius, 0.0) - step - 1e-9


free_points = st.tuples(st.floats(0.9, 7.8), st.floats(0.1, 3.7))


@given(
    st.lists(discs | boxes, min_size=1, max_size=4),
    st.sampled_from(EDGES),
    free_points,
    free_points,
)
def test_a_path_planned_on_the_live_grid_does_not_count_as_blocked(
    obstacles: list[Obstacle], edge: float, start: Vec2, goal: Vec2
) -> None:
    found, distances = rows(*obstacles), distances_for(KEEP, GIVE, edge)
    grid = live_grid(hall(edge), found, distances.reach)
    answer = plan(grid, start, goal, 0.5, shortcut=True)
    if answer.path is not None:
        assert first_block(found, answer.path.waypoints, distances.tight) == (inf, -1)


@pytest.mark.parametrize(
    ("distance", "blocked"), [(0.3, True), (0.42, True), (0.44, False), (1.0, False)]
)
def test_a_path_is_blocked_where_it_first_comes_too_close(distance: float, blocked: bool) -> None:
    found = rows(Obstacle("chair", (4.0, 1.0 + distance), 0.0))
    along, which = first_block(
        found, ((1.0, 1.0), (7.0, 1.0)), distances_for(KEEP, GIVE, 0.1).tight
    )
    assert (which == 0) == blocked
    assert not blocked or 2.5 < along < 3.0


def test_who_is_too_close_already_may_leave_and_not_come_closer() -> None:
    found = rows(Obstacle("chair", (4.0, 1.0), 0.2))
    assert first_block(found, ((4.4, 1.0), (7.0, 1.0)), 0.43)[1] == -1
    assert first_block(found, ((4.4, 1.0), (1.0, 1.0)), 0.43)[1] == 0
    assert first_block(found, ((4.4, 1.0), (6.0, 1.0), (2.0, 1.0)), 0.43)[0] == pytest.approx(
        1.6 + 1.4, abs=0.1
    )


def test_obstacles_below_or_above_the_flight_do_not_count() -> None:
    low, high = (
        Obstacle("cat", (4.0, 1.0), 0.2, top=0.3),
        Obstacle("lamp", (4.0, 1.0), 0.2, bottom=1.9, top=2.2),
    )
    assert len(rows(low, high)) == 0
    assert len(rows(Obstacle("chair", (4.0, 1.0), 0.2), low)) == 1


def test_who_stands_in_somebodys_way_may_step_aside_and_not_go_towards_them() -> None:
    walker = Obstacle("anna", (4.0, 1.0), 0.3, velocity=(0.8, 0.0))
    found = rows(walker, horizon=1.0)
    assert gap(found[0], 4.8, 1.0) == 0.0
    assert first_block(found, ((4.8, 1.0), (4.8, 3.0)), 0.43)[1] == -1
    assert first_block(found, ((4.8, 1.0), (7.0, 1.0)), 0.43)[1] == -1
    assert first_block(found, ((4.8, 1.0), (1.0, 1.0)), 0.43)[1] == 0
