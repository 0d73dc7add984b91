from __future__ import annotations

from math import pi

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from path_follower import WaypointFollower

from housefly.geometry import Vec2
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES
from housefly.pilot.behavior.path_profile import path_profile
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.waypoints import paper_heading, waypoint_advanced

EPS3 = PAPER_TOLERANCES.position
SQUARE = ((0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5))
ZIGZAG = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.5), (0.5, 1.5), (0.5, 3.0))


def place(target: TrajectorySetpoint) -> Vec2:
    return target.x, target.y


def test_the_papers_follower_goes_on_when_nearer_than_eps3() -> None:
    follower = WaypointFollower(SQUARE, 0.1, EPS3)
    assert place(follower.step(-0.4, 0.0)) == (0.0, 0.0)
    assert place(follower.step(-0.39, 0.0)) == (0.5, 0.0)
    assert place(follower.step(0.3, 0.0)) == (0.5, 0.5)
    last = follower.step(0.45, 0.4)
    assert place(last) == (0.0, 0.5) and last.finished and (last.vx, last.vy) == (0.0, 0.0)


def test_the_papers_heading_is_zero_or_pi_by_the_legs_x_and_kept_along_y() -> None:
    follower = WaypointFollower(SQUARE, 3.0, EPS3)
    yaws = [follower.step(*here).yaw for here in ((9.0, 0.0), (0.0, 0.0), (0.5, 0.0), (0.5, 0.5))]
    assert yaws == [pi, 0.0, 0.0, pi]


@given(st.floats(-10.0, 10.0))
def test_paper_heading_is_the_nearer_of_its_two(yaw: float) -> None:
    off = np.angle(np.exp(1j * (paper_heading(yaw) - yaw)))
    assert abs(off) <= pi / 2 + 1e-9


@given(st.integers(0, 4), st.floats(-1.0, 4.0), st.floats(-1.0, 4.0), st.sampled_from([0.0, pi]))
def test_the_next_cell_comes_when_q4_holds(index: int, x: float, y: float, yaw: float) -> None:
    found, turned = waypoint_advanced(index, yaw, path_profile(ZIGZAG).waypoints, x, y, 0.4)
    near = np.hypot(x - ZIGZAG[index][0], y - ZIGZAG[index][1]) < 0.4
    assert found == (index + 1 if near and index < 4 else index)
    leg = ZIGZAG[found][0] - ZIGZAG[index][0]
    assert turned == (yaw if abs(leg) < 1e-6 else (0.0 if leg > 0.0 else pi))
