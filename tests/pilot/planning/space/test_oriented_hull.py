"""The hull as a rectangle with a heading, against points on its rim."""

from __future__ import annotations

from math import cos, hypot, pi, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.messages.obstacles import Obstacle
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.oriented_hull import OrientedHull, oriented_clearances
from housefly.pilot.planning.space.solid_rows import live_rows

HULL = OrientedHull(0.517 / 2, 0.451 / 2, 0.065)
DISC = HullCylinder(hypot(HULL.half_length, HULL.half_width), HULL.half_height)


def rim(hull: OrientedHull, pose: np.ndarray) -> np.ndarray:
    """Return points on the rim of the hull at a pose, and inside it."""
    u, v = np.meshgrid(np.linspace(-1.0, 1.0, 61), np.linspace(-1.0, 1.0, 61))
    u, v = u.ravel() * hull.half_length, v.ravel() * hull.half_width
    c, s = cos(pose[3]), sin(pose[3])
    return np.stack((pose[0] + u * c - v * s, pose[1] + u * s + v * c), axis=1)


@settings(max_examples=60)
@given(
    st.tuples(*[st.floats(-1.5, 1.5)] * 2),
    st.floats(-pi, pi),
    st.tuples(*[st.floats(0.0, 2.0)] * 2),
    st.floats(-pi, pi),
    st.sampled_from((0.0, 0.3)),
)
def test_the_gap_is_that_of_the_nearest_point_of_the_hull(
    place: tuple[float, float],
    yaw: float,
    size: tuple[float, float],
    turn: float,
    radius: float,
) -> None:
    row = live_rows([Obstacle("thing", (0.0, 0.0), radius, size, turn, 0.0, 2.0)], 0.0, 0.0)
    pose = np.array([*place, 1.0, yaw])
    found = oriented_clearances(row, pose[None, :], HULL, 9.0)[0]
    points = np.hstack((rim(HULL, pose), np.ones((61 * 61, 1))))
    sampled = hull_clearances(row, points, HullCylinder(0.0, 0.0), 9.0).min()
    assert sampled - 0.01 <= found <= sampled + 1e-9


def test_a_door_of_80_cm_is_wide_enough_for_the_hull_but_not_for_its_disc() -> None:
    posts = [Obstacle(f"post {side}", (0.0, side * 1.4), 0.0, (0.1, 2.0)) for side in (-1, 1)]
    rows = live_rows(posts, 0.0, 0.0)
    xs = np.linspace(-1.0, 1.0, 81)
    places = np.stack((xs, 0.0 * xs, 0.0 * xs + 1.1), axis=1)
    poses = np.hstack((places, np.zeros((81, 1))))
    assert oriented_clearances(rows, poses, HULL, 9.0).min() == pytest.approx(0.4 - 0.2255)
    assert hull_clearances(rows, places, DISC, 9.0).min() == pytest.approx(0.4 - DISC.radius)
    across = poses + np.array([0.0, 0.0, 0.0, pi / 2])
    assert oriented_clearances(rows, across, HULL, 9.0).min() == pytest.approx(0.4 - 0.2585)


def test_above_and_below_count_as_height_and_what_moves_counts_all_along_its_way() -> None:
    table = Obstacle("table", (0.0, 0.0), 0.0, (1.0, 1.0), 0.0, 0.0, 0.7)
    pose = np.array([[0.0, 0.0, 1.1, 0.3]])
    over = oriented_clearances(live_rows([table], 0.0, 0.0), pose, HULL, 9.0)[0]
    assert over == pytest.approx(1.1 - 0.065 - 0.7)
    walker = Obstacle("walker", (-3.0, 0.0), 0.25, velocity=(1.0, 0.0))
    near = oriented_clearances(live_rows([walker], 0.0, 2.0), pose, HULL, 9.0)[0]
    assert near == pytest.approx(1.0 - 0.25 - DISC.radius)
