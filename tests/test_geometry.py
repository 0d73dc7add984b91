from math import isclose, pi

from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import (
    euler_from_quaternion,
    normalized,
    quaternion_from_euler,
    quaternion_product,
    rotate,
    stopping_distance,
    wrap_angle,
    yaw_of,
)

angles = st.floats(-10, 10)
halves = st.floats(-pi / 2 + 0.01, pi / 2 - 0.01)
vectors = st.tuples(st.floats(-5, 5), st.floats(-5, 5), st.floats(-5, 5))


@given(angles)
def test_a_wrapped_angle_is_the_same_direction_within_half_a_turn(angle: float) -> None:
    wrapped = wrap_angle(angle)
    assert -pi < wrapped <= pi
    turns = (angle - wrapped) / (2 * pi)
    assert isclose(turns, round(turns), abs_tol=1e-9)


def test_minus_pi_wraps_to_pi() -> None:
    assert wrap_angle(-pi) == pi


@given(st.floats(-3, 3), halves, st.floats(-3, 3))
def test_euler_angles_survive_the_way_through_a_quaternion(
    phi: float, theta: float, psi: float
) -> None:
    back = euler_from_quaternion(quaternion_from_euler(phi, theta, psi))
    assert all(isclose(a, b, abs_tol=1e-9) for a, b in zip(back, (phi, theta, psi), strict=True))


@given(st.floats(-3, 3), halves, st.floats(-3, 3), vectors)
def test_a_rotation_keeps_lengths(
    phi: float, theta: float, psi: float, v: tuple[float, float, float]
) -> None:
    turned = rotate(quaternion_from_euler(phi, theta, psi), v)
    assert isclose(sum(c * c for c in turned), sum(c * c for c in v), abs_tol=1e-6)


def test_positive_pitch_leans_the_thrust_forward_and_positive_roll_to_the_right() -> None:
    up = (0.0, 0.0, 1.0)
    assert rotate(quaternion_from_euler(0, 0.2, 0), up)[0] > 0
    assert rotate(quaternion_from_euler(0.2, 0, 0), up)[1] < 0


@given(st.floats(-3, 3))
def test_yaw_is_read_back_from_any_scaled_quaternion(psi: float) -> None:
    w, x, y, z = quaternion_from_euler(0, 0, psi)
    assert isclose(yaw_of(normalized((3 * w, 3 * x, 3 * y, 3 * z))), psi, abs_tol=1e-9)


def test_the_stopping_distance_matches_the_figures_of_the_design() -> None:
    assert isclose(stopping_distance(0.5, 2.09, 0.2), 0.16, abs_tol=0.005)
    assert isclose(stopping_distance(1.0, 2.09, 0.2), 0.44, abs_tol=0.005)


@given(angles, halves, angles, vectors)
def test_a_product_turns_by_the_second_first(
    psi: float, theta: float, phi: float, v: tuple[float, float, float]
) -> None:
    a, b = quaternion_from_euler(phi, 0.0, psi), quaternion_from_euler(0.0, theta, phi)
    once, twice = rotate(quaternion_product(a, b), v), rotate(a, rotate(b, v))
    assert all(isclose(x, y, abs_tol=1e-9) for x, y in zip(once, twice, strict=True))
