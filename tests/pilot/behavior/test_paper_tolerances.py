"""What the paper's eps3 of 0.4 m does on a grid of 0.5 m, and what ours does."""

from __future__ import annotations

import numpy as np
import pytest
from path_follower import WaypointFollower

from housefly.config.site import Site
from housefly.geometry import distance
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES
from housefly.room.grid import OccupancyGrid, inflation

EPS3 = PAPER_TOLERANCES.position
GRID = OccupancyGrid((0.0, 0.0), 0.5, np.zeros((25, 9), np.uint8), np.ones((25, 9)))


def test_eps3_of_the_paper_is_met_in_the_neighbouring_cell_and_ours_is_not() -> None:
    goal = GRID.centre_of((10, 4))
    beside = (goal[0] + 0.39, goal[1])
    assert distance(beside, goal) < EPS3
    assert GRID.cell_of(beside) != GRID.cell_of(goal)
    assert Site().control.epsilon_position < 0.5 * GRID.resolution


def test_the_papers_reference_jumps_on_a_tenth_of_a_metre_behind_each_cells_middle() -> None:
    points = tuple(GRID.centre_of((column, 4)) for column in range(5))
    follower = WaypointFollower(points, 0.0, EPS3)
    assert follower.step(*points[0]).waypoint == 1
    assert follower.step(points[0][0] + 0.09, points[0][1]).waypoint == 1
    assert follower.step(points[0][0] + 0.11, points[0][1]).waypoint == 2


def test_the_hull_does_not_fit_a_paper_cell_and_our_map_grows_obstacles_by_more_than_half() -> None:
    drone, grid = Site().drone, Site().map
    half_diagonal = 0.5 * float(np.hypot(drone.hull_length, drone.hull_width))
    assert drone.hull_length > grid.paper_resolution
    assert half_diagonal == pytest.approx(0.343, abs=5e-4)
    assert inflation(Site()) == pytest.approx(half_diagonal + grid.tracking_bound + grid.margin)
