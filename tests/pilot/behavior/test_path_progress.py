from __future__ import annotations

from math import isnan, nan, pi

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from housefly.pilot.behavior.path_profile import path_profile
from housefly.pilot.behavior.path_progress import (
    HEADING_FREEZE,
    HEADING_LOOKAHEAD,
    LAG_MAX,
    PathProgress,
    point_on,
    progress_advanced,
    progress_headed,
    setpoint_at,
)
from housefly.pilot.behavior.waypoints import waypoint_advanced
from housefly.pilot.behavior.yaw_reference import (
    YAW_REFERENCE_RATE,
    YawReference,
    yaw_reference_advanced,
)

ZIGZAG = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.5), (0.5, 1.5), (0.5, 3.0))
WAY = path_profile(ZIGZAG)
END = float(WAY.marks[-1])
lengths = st.floats(0.0, END)
angles = st.floats(-pi, pi)


def on_path(s: float) -> np.ndarray:
    """The point at an arc length, by interpolation over all corners."""
    return np.array([np.interp(s, WAY.marks, WAY.points[:, axis]) for axis in (0, 1)])


def leg_of(s: float) -> int:
    return min(int(np.searchsorted(WAY.marks, s, side="right")) - 1, len(ZIGZAG) - 2)


@given(lengths)
def test_a_place_on_the_path_is_the_interpolated_one(s: float) -> None:
    assert point_on(leg_of(s), s, WAY) == pytest.approx(tuple(on_path(s)), abs=1e-12)


@given(lengths, angles)
def test_the_heading_is_that_of_the_point_ahead_and_stays_near_the_end(
    s: float, yaw: float
) -> None:
    ahead = on_path(min(s + HEADING_LOOKAHEAD, END)) - on_path(s)
    found = progress_headed(PathProgress(s, 0.3, 0.0, leg_of(s), yaw), WAY).yaw
    reach = float(np.hypot(*ahead))
    if abs(reach - HEADING_FREEZE) < 1e-9:
        return
    expected = np.arctan2(ahead[1], ahead[0]) if reach > HEADING_FREEZE else yaw
    assert np.exp(1j * found) == pytest.approx(np.exp(1j * expected), abs=1e-9)


@given(lengths, st.floats(0.0, 0.5), st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.booleans())
def test_the_ride_goes_on_only_while_it_may_and_the_drone_is_near(
    s: float, v: float, dx: float, dy: float, moving: bool
) -> None:
    ride = PathProgress(s, v, 0.0, leg_of(s), 0.2)
    x, y = on_path(s) + np.array([dx, dy])
    after = progress_advanced(ride, WAY, 0.5, x, y, moving, 0.01)
    assert s <= after.s <= END
    if np.hypot(dx, dy) > LAG_MAX + 1e-9 or not moving:
        assert after.v <= v
    assert after == progress_advanced.py_func(ride, WAY, 0.5, x, y, moving, 0.01)  # type: ignore[attr-defined]


@given(lengths, st.floats(0.0, 0.5), st.floats(-0.6, 0.4))
def test_the_target_moves_along_its_leg(s: float, v: float, a: float) -> None:
    target = setpoint_at(PathProgress(s, v, a, leg_of(s), 0.3), WAY)
    leg = WAY.points[leg_of(s) + 1] - WAY.points[leg_of(s)]
    along = leg / np.hypot(*leg)
    assert (target.vx, target.vy) == pytest.approx(tuple(v * along), abs=1e-12)
    assert (target.ax, target.ay) == pytest.approx(
        tuple((0.0 if s >= END else a) * along), abs=1e-12
    )
    assert target.finished == (s >= END) and target.waypoint == leg_of(s) + 1


@given(angles, angles, angles, st.floats(0.0, 0.1))
@example(0.0, -pi, 0.0, 0.0625)
def test_the_nose_turns_the_short_way_no_faster_than_allowed(
    reference: float, wish: float, yaw: float, dt: float
) -> None:
    nose = yaw_reference_advanced(YawReference(0.0, reference), wish, yaw, YAW_REFERENCE_RATE * dt)
    turned = np.angle(np.exp(1j * (nose.reference - reference)))
    left = np.angle(np.exp(1j * (wish - reference)))
    assert abs(turned) == pytest.approx(min(abs(left), YAW_REFERENCE_RATE * dt), abs=1e-9)
    assert -pi < nose.reference <= pi
    assert turned * left >= -1e-12 or abs(left) > pi - 1e-9, (
        "half a turn is as short one way as the other"
    )


def test_the_nose_without_a_wish_keeps_the_last_target_or_the_present_heading() -> None:
    assert yaw_reference_advanced(YawReference(0.0, nan), nan, 0.7, 0.01) == YawReference(0.7, 0.7)
    assert yaw_reference_advanced(YawReference(0.4, 0.1), nan, 0.7, 9.0) == YawReference(0.4, 0.4)
    assert isnan(YawReference().reference)


def test_the_nose_of_mode_paper_jumps() -> None:
    assert yaw_reference_advanced(YawReference(0.0, 0.0), pi, 0.1, float("inf")) == YawReference(pi, pi)


@given(st.integers(0, 4), st.floats(-1.0, 4.0), st.floats(-1.0, 4.0), st.sampled_from([0.0, pi]))
def test_the_next_cell_comes_when_q4_holds(index: int, x: float, y: float, yaw: float) -> None:
    found, turned = waypoint_advanced(index, yaw, WAY.points, x, y, 0.4)
    near = np.hypot(x - ZIGZAG[index][0], y - ZIGZAG[index][1]) < 0.4
    assert found == (index + 1 if near and index < 4 else index)
    leg = ZIGZAG[found][0] - ZIGZAG[index][0]
    assert turned == (yaw if abs(leg) < 1e-6 else (0.0 if leg > 0.0 else pi))
