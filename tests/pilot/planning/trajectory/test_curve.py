"""Control points, splines and speed profiles by themselves, against scipy and the definitions."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline
from scipy.optimize import lsq_linear
from space_room import LIMITS

from housefly.pilot.planning.trajectory.bounded_points import bounded_points
from housefly.pilot.planning.trajectory.bspline import curve_points, moving_start
from housefly.pilot.planning.trajectory.control_points import stopping_points
from housefly.pilot.planning.trajectory.curve import arc_curve
from housefly.pilot.planning.trajectory.speed_limits import lowered_around
from housefly.pilot.planning.trajectory.speed_profile import averaged, swept, timed

SEEDS = st.integers(0, 2**32 - 1)


@settings(max_examples=30)
@given(SEEDS, st.integers(5, 60), st.sampled_from((0.02, 0.3)))
def test_points_between_bounds_bend_no_more_than_the_best_of_scipy(
    seed: int, count: int, pull: float
) -> None:
    random = np.random.default_rng(seed)
    low = np.cumsum(random.normal(0.0, 0.2, count))
    high = low + random.random(count) * 1.5
    high[:3], low[-3:] = low[:3], high[-3:]
    found = bounded_points(low, high, pull)
    assert (found >= low).all() and (found <= high).all()
    second, first = np.diff(np.eye(count), 2, axis=0), np.diff(np.eye(count), axis=0)
    matrix = np.vstack((second, np.sqrt(pull) * first))
    held = high - low < 1e-9
    best = lsq_linear(
        matrix[:, ~held],
        -matrix[:, held] @ low[held],
        (low[~held], high[~held]),
        tol=1e-12,
        max_iter=500,
    )
    assert float(((matrix @ found) ** 2).sum()) <= 2.0 * best.cost * (1.0 + 1e-4) + 1e-6


@given(SEEDS, st.integers(4, 12))
def test_the_spline_is_that_of_scipy(seed: int, count: int) -> None:
    points = np.random.default_rng(seed).random((count, 3))
    places, first, second = curve_points(points, 8)
    spline = BSpline(np.arange(-3.0, count + 1.0), points, 3)
    u = np.linspace(0.0, count - 3.0, 8 * (count - 3) + 1)
    assert np.allclose(places, spline(u))
    assert np.allclose(first, spline.derivative(1)(u))
    assert np.allclose(second[:-1], spline.derivative(2)(u)[:-1])


def test_a_moving_start_has_the_place_direction_and_bend_asked_for() -> None:
    place, along = np.array([1.0, 2.0, 1.1]), np.array([0.6, 0.8, 0.0])
    bend = 0.7 * np.array([-0.8, 0.6, 0.0])
    points = np.vstack((moving_start(place, along, bend, 0.2), [[1.8, 3.4, 1.1], [1.7, 3.9, 1.2]]))
    curve = arc_curve(points)
    assert np.allclose(curve.places[0], place)
    assert np.allclose(curve.along[0], along)
    assert np.allclose(curve.bends[0], bend)


def test_an_arc_curve_measures_and_bends_as_a_circle() -> None:
    angles = np.linspace(-0.3, 2.3, 60)
    points = np.stack((2.0 * np.cos(angles), 2.0 * np.sin(angles), 0.0 * angles), axis=1)
    curve = arc_curve(points)
    turned = np.arccos(np.clip((curve.along[0] * curve.along[-1]).sum(), -1.0, 1.0))
    assert curve.marks[-1] == pytest.approx(2.0 * turned, rel=2e-3)
    assert np.linalg.norm(curve.bends, axis=1) == pytest.approx(0.5, rel=2e-3)


def test_a_polyline_that_stops_has_no_bends_and_stands_at_its_corners() -> None:
    corners = np.array([[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 1.0, 1.0]])
    curve = arc_curve(stopping_points(corners))
    assert np.abs(curve.bends).max() < 1e-6
    standing = curve.places[curve.stands > 0.0]
    assert any(np.allclose(place, corners[1]) for place in standing)
    assert curve.marks[-1] == pytest.approx(3.0)


@settings(max_examples=40)
@given(SEEDS)
def test_a_speed_profile_keeps_its_limits_brakes_in_time_and_has_no_jolts(seed: int) -> None:
    random = np.random.default_rng(seed)
    marks = np.concatenate(([0.0], np.cumsum(random.uniform(0.01, 0.06, 200))))
    fastest = np.repeat(random.uniform(0.2, 1.0, 21), 10)[: marks.size]
    window = 2.0 * LIMITS.acceleration / LIMITS.jerk
    lowered = lowered_around(marks, fastest, window)
    assert (lowered <= fastest).all()
    nothing = np.zeros(marks.size)
    speed = swept(marks, lowered, nothing, nothing, LIMITS, 0.0)
    assert (speed <= lowered + 1e-12).all() and speed[0] == speed[-1] == 0.0
    pushes = np.diff(speed**2) / (2.0 * np.diff(marks))
    assert np.abs(pushes).max() <= LIMITS.acceleration + 1e-9
    rows = averaged(timed(marks, speed, window), marks, speed, window, np.zeros(2), 0.02)
    assert rows[0] == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)
    assert rows[-1] == pytest.approx([marks[-1], 0.0, 0.0])
    assert (np.diff(rows[:, 0]) >= -1e-9).all()
    assert np.abs(np.diff(rows[:-1, 2])).max() / 0.02 <= LIMITS.jerk * 1.001
    allowed = np.interp(rows[:, 0], marks, fastest)
    assert (rows[:, 1] <= allowed + 0.08).all()
