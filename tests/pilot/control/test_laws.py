from __future__ import annotations

from math import atan, cos, hypot, pi, sin, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import GRAVITY, quaternion_from_euler, rotate
from housefly.numeric import clipped, wrapped
from housefly.pilot.control.laws import (
    acceleration,
    climb_rate,
    clipped_per_axis,
    compensated_climb_rate,
    demand,
    paper_tilt,
    saturated_jointly,
    tilt,
    yaw_rate,
)

accelerations = st.floats(-5.0, 5.0)
angles = st.floats(-1.0, 1.0)
headings = st.floats(-10.0, 10.0)


@given(accelerations, accelerations, headings)
def test_tilt_is_the_exact_inverse_of_the_dynamics_at_any_heading(
    ax: float, ay: float, psi: float
) -> None:
    theta, phi = tilt(ax, ay, psi, 1.0)
    assert acceleration(theta, phi, psi) == pytest.approx((ax, ay), abs=1e-9)


@given(angles, angles, headings)
def test_acceleration_is_thrust_that_holds_the_height_turned_by_the_attitude(
    theta: float, phi: float, psi: float
) -> None:
    thrust = GRAVITY / (cos(theta) * cos(phi))
    ax, ay, az = rotate(quaternion_from_euler(phi, theta, psi), (0.0, 0.0, thrust))
    assert acceleration(theta, phi, psi) == pytest.approx((ax, ay), abs=1e-9)
    assert az == pytest.approx(GRAVITY)


@given(accelerations, accelerations)
def test_paper_tilt_is_the_general_law_at_both_headings_of_the_paper(ax: float, ay: float) -> None:
    assert paper_tilt(ax, ay, 1.0, 0.9) == pytest.approx(tilt(ax, ay, 0.0, 0.9), abs=1e-12)
    assert paper_tilt(ax, ay, -1.0, 0.9) == pytest.approx(tilt(ax, ay, pi, 0.9), abs=1e-12)


@given(accelerations, accelerations)
def test_paper_tilt_is_equations_20_and_21(ax: float, ay: float) -> None:
    theta = np.arctan(ax / GRAVITY)
    phi = -np.arctan(np.cos(np.arctan(ax / GRAVITY)) * ay / GRAVITY)
    assert paper_tilt(ax, ay, 1.0, 1.0) == pytest.approx((theta, phi), abs=1e-12)


@given(accelerations, accelerations, headings, st.floats(0.2, 2.0))
def test_tilt_matches_its_numpy_twin(ax: float, ay: float, psi: float, gain: float) -> None:
    turn = np.array([[np.cos(psi), np.sin(psi)], [-np.sin(psi), np.cos(psi)]])
    forward, left = turn @ np.array([ax, ay])
    theta = np.arctan(forward / GRAVITY)
    expected = theta / gain, -np.arctan(np.cos(theta) * left / GRAVITY) / gain
    assert tilt(ax, ay, psi, gain) == pytest.approx(expected, abs=1e-12)


@given(angles, angles, st.floats(0.01, 0.5))
def test_joint_saturation_keeps_the_direction_and_the_bound(
    theta: float, phi: float, bound: float
) -> None:
    a, b = saturated_jointly(theta, phi, bound)
    assert hypot(a, b) <= bound * (1.0 + 1e-12)
    assert a * phi == pytest.approx(b * theta, abs=1e-12)
    assert a * theta >= 0.0 and b * phi >= 0.0
    if hypot(theta, phi) <= bound * (1.0 - 1e-12):
        assert (a, b) == (theta, phi)


def test_clipping_each_axis_bends_the_direction_and_joint_saturation_does_not() -> None:
    bent = clipped_per_axis(0.4, 0.1, 0.2)
    straight = saturated_jointly(0.4, 0.1, 0.2)
    assert bent == (0.2, 0.1)
    assert straight[1] / straight[0] == pytest.approx(0.25)


@given(
    st.floats(-3.0, 3.0),
    st.floats(-3.0, 3.0),
    accelerations,
    st.floats(0.1, 20.0),
    st.floats(0.1, 50.0),
)
def test_demand_matches_its_numpy_twin(
    e: float, de: float, ff: float, alpha: float, beta: float
) -> None:
    assert demand(e, de, ff, alpha, beta) == pytest.approx(
        float(np.dot([beta, alpha, 1.0], [e, de, ff])), abs=1e-9
    )


@given(st.floats(-1e4, 1e4))
def test_wrapped_is_the_same_angle_in_the_half_open_turn(angle: float) -> None:
    inside = wrapped(angle)
    assert -pi - 1e-9 < inside <= pi + 1e-9
    assert (cos(inside), sin(inside)) == pytest.approx((cos(angle), sin(angle)), abs=1e-9)


def test_wrapped_keeps_plus_pi_and_turns_minus_pi_into_it() -> None:
    assert wrapped(pi) == pi
    assert wrapped(-pi) == pi


@given(st.floats(-1e3, 1e3), st.floats(0.0, 1e3))
def test_clipped_is_numpy_clip(value: float, bound: float) -> None:
    assert clipped(value, bound) == float(np.clip(value, -bound, bound))


@given(headings, headings)
def test_yaw_law_turns_the_short_way(reference: float, psi: float) -> None:
    rate = yaw_rate(reference, psi, 1.0, 0.0, 10.0)
    off = np.angle(np.exp(1j * (reference - psi)))
    assert abs(rate) <= pi + 1e-9
    assert abs(abs(rate) - abs(off)) < 1e-6


def test_yaw_law_at_the_cut_would_spin_without_the_wrap() -> None:
    psi, reference = -pi + 0.002, pi
    assert abs(yaw_rate(reference, psi, 1.5, 0.0, 1.75)) == pytest.approx(0.003, rel=1e-6)
    assert 1.5 * abs(psi - reference) > 9.0


def test_height_law_climbs_when_too_low_whatever_the_printed_sign() -> None:
    assert climb_rate(1.1, 0.5, 1.2, 0.0, 0.7) == 0.7
    assert climb_rate(1.1, 1.2, 1.2, 0.0, 0.7) == pytest.approx(-0.12)


def _distance_after_ten_seconds(alpha: float, beta: float, psi: float, psi_in_law: float) -> float:
    """Fly the full nonlinear dynamics with an attitude lag of 6/s towards (1, 0.7) m."""
    x = y = vx = vy = theta = phi = 0.0
    for _ in range(10_000):
        ax, ay = demand(1.0 - x, -vx, 0.0, alpha, beta), demand(0.7 - y, -vy, 0.0, alpha, beta)
        want = tilt(ax, ay, psi_in_law, 1.0)
        theta += 0.001 * 6.0 * (clipped(want[0], 0.21) - theta)
        phi += 0.001 * 6.0 * (clipped(want[1], 0.21) - phi)
        ax, ay = acceleration(theta, phi, psi)
        vx, vy = vx + 0.001 * ax, vy + 0.001 * ay
        x, y = x + 0.001 * vx, y + 0.001 * vy
    return hypot(1.0 - x, 0.7 - y)


def test_gains_of_the_literal_sign_fly_away_and_positive_ones_arrive() -> None:
    assert _distance_after_ten_seconds(-2.0, -1.5, 0.0, 0.0) > 20.0
    assert _distance_after_ten_seconds(2.0, 1.5, 0.0, 0.0) < 1e-3


def test_law_for_heading_zero_diverges_at_ninety_degrees_and_the_general_law_does_not() -> None:
    assert _distance_after_ten_seconds(2.0, 1.5, pi / 2, 0.0) > 5.0
    assert _distance_after_ten_seconds(2.0, 1.5, pi / 2, pi / 2) < 1e-3


def test_tilt_of_a_pure_forward_push_is_the_plain_arc_tangent() -> None:
    assert tilt(1.0, 0.0, 0.0, 1.0)[0] == pytest.approx(atan(1.0 / GRAVITY))
    assert tan(tilt(0.0, 1.0, 0.0, 1.0)[1]) == pytest.approx(-1.0 / GRAVITY)


@given(st.floats(0.3, 3.0), st.floats(0.5, 20.0), st.floats(-1.0, 1.0), st.floats(-0.5, 0.5))
def test_a_climb_is_made_as_wanted_against_lag_and_push(
    gain: float, pole: float, lift: float, wanted: float
) -> None:
    climb = 0.1
    asked = compensated_climb_rate(wanted, climb, lift, gain, pole)
    acceleration_made = pole * (asked - climb) + lift
    faster = max(4.0 * gain, pole)
    assert acceleration_made == pytest.approx(faster * (wanted - climb), abs=1e-9)
