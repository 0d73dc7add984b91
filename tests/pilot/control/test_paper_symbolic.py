"""The paper's equations derived one from another by computer algebra, and the code compared with
what was derived.
"""

from __future__ import annotations

from math import isclose, pi
from random import Random
from typing import Any

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import GRAVITY
from housefly.pilot.control.laws import acceleration, demand, paper_tilt, tilt
from housefly.pilot.control.model import Constants, DroneState, drone_step, lagged

theta, phi = sp.symbols("theta phi", real=True)
psi = sp.Symbol("psi", real=True)
f, m, g = sp.symbols("f m g", positive=True)
wanted_x, wanted_y = sp.symbols("a_x a_y", real=True)
s, lam, c, alpha, beta = sp.symbols("s lambda c alpha beta", positive=True)
t = sp.Symbol("t", nonnegative=True)

PRINTED_3 = sp.Matrix(
    [
        [
            sp.cos(psi) * sp.cos(theta),
            sp.cos(psi) * sp.sin(theta) * sp.sin(phi) - sp.sin(psi) * sp.cos(phi),
            sp.cos(psi) * sp.sin(theta) * sp.cos(phi) + sp.sin(psi) * sp.sin(phi),
        ],
        [
            sp.sin(psi) * sp.cos(theta),
            sp.sin(psi) * sp.sin(theta) * sp.sin(phi) + sp.cos(psi) * sp.cos(phi),
            sp.sin(psi) * sp.sin(theta) * sp.cos(phi) - sp.cos(psi) * sp.sin(phi),
        ],
        [-sp.sin(theta), sp.cos(theta) * sp.sin(phi), sp.cos(theta) * sp.cos(phi)],
    ]
)
PRINTED_5_TO_7 = sp.Matrix(
    [
        (sp.cos(phi) * sp.sin(theta) * sp.cos(psi) + sp.sin(phi) * sp.sin(psi)) / m * f,
        (sp.cos(phi) * sp.sin(theta) * sp.sin(psi) - sp.sin(phi) * sp.cos(psi)) / m * f,
        sp.cos(phi) * sp.cos(theta) / m * f - g,
    ]
)
LIFT = PRINTED_3 * sp.Matrix([0, 0, f])
WEIGHT = sp.Matrix([0, 0, m * g])
MENDED_4 = (LIFT - WEIGHT) / m
"""Eq. (4) with the weight that the paper means: a force, and downwards once it is subtracted."""
LITERAL_4 = (LIFT - sp.Matrix([0, 0, -g])) / m
THRUST = sp.solve(sp.Eq(MENDED_4[2], 0), f)[0]
"""The thrust that eq. (10) asks for."""
LEVEL = MENDED_4.subs(f, THRUST)
"""The dynamics while the height is held."""
PRINTED_20 = sp.atan(wanted_x / g)
PRINTED_21 = -sp.atan(sp.cos(sp.atan(wanted_x / g)) * wanted_y / g)
FORWARD = sp.cos(psi) * wanted_x + sp.sin(psi) * wanted_y
LEFT = -sp.sin(psi) * wanted_x + sp.cos(psi) * wanted_y
GENERAL = (sp.atan(FORWARD / g), -sp.atan(sp.cos(sp.atan(FORWARD / g)) * LEFT / g))
"""Pitch and roll for any heading."""

accelerations = st.floats(-4.0, 4.0)
angles = st.floats(-1.0, 1.0)
headings = st.floats(-pi, pi)


def is_zero(expression: Any) -> bool:
    """Return whether an expression, or every entry of a matrix, simplifies to nothing."""
    entries = expression if isinstance(expression, sp.MatrixBase) else [expression]
    return all(sp.simplify(sp.expand(entry)) == 0 for entry in entries)


def test_equation_3_is_yaw_times_pitch_times_roll() -> None:
    yaw, pitch, roll = sp.rot_axis3(-psi), sp.rot_axis2(-theta), sp.rot_axis1(-phi)
    assert is_zero(PRINTED_3 - yaw * pitch * roll)
    assert is_zero(PRINTED_3.T * PRINTED_3 - sp.eye(3))


def test_equations_5_to_7_follow_from_3_and_4_once_the_weight_is_a_force() -> None:
    assert is_zero(MENDED_4 - PRINTED_5_TO_7)


def test_equation_4_as_printed_gives_another_row_for_z_and_the_same_for_x_and_y() -> None:
    difference = LITERAL_4 - PRINTED_5_TO_7
    assert is_zero(difference[:2, 0])
    assert is_zero(difference[2] - (g + g / m))


def test_equation_10_gives_the_thrust_of_the_paper() -> None:
    assert is_zero(THRUST - m * g / (sp.cos(theta) * sp.cos(phi)))
    assert is_zero(LEVEL[2])


@pytest.mark.parametrize(("heading", "sign"), [(0, 1), (sp.pi, -1)])
def test_equations_8_and_9_follow_at_both_headings_with_the_upper_sign_for_zero(
    heading: Any, sign: int
) -> None:
    planar = LEVEL.subs(psi, heading)
    assert is_zero(planar[0] - sign * g * sp.tan(theta))
    assert is_zero(planar[1] + sign * g * sp.tan(phi) / sp.cos(theta))


def test_equations_8_and_9_hold_at_no_heading_between() -> None:
    planar = LEVEL.subs(psi, sp.pi / 2)
    assert not is_zero(planar[0] - g * sp.tan(theta))
    assert not is_zero(planar[0] + g * sp.tan(theta))


def test_equations_20_and_21_are_what_11_to_19_solve_to() -> None:
    x, vx, y, vy, a1, b1, a2, b2 = sp.symbols("x vx y vy alpha_1 beta_1 alpha_2 beta_2", real=True)
    eq_16 = sp.Eq(g * sp.tan(theta), a1 * vx + b1 * x)
    law_20 = sp.atan(sp.solve(eq_16, sp.tan(theta))[0])
    eq_17 = sp.Eq(-g * sp.tan(phi) / sp.cos(theta), a2 * vy + b2 * y)
    eq_18 = sp.Eq(-g * sp.tan(phi), sp.cos(theta) * (a2 * vy + b2 * y))
    assert is_zero((eq_17.lhs - eq_17.rhs) * sp.cos(theta) - (eq_18.lhs - eq_18.rhs))
    law_21 = sp.atan(sp.solve(eq_18.subs(theta, law_20), sp.tan(phi))[0])
    put_in = {wanted_x: a1 * vx + b1 * x, wanted_y: a2 * vy + b2 * y}
    assert is_zero(law_20 - PRINTED_20.subs(put_in))
    assert is_zero(law_21 - PRINTED_21.subs(put_in))


def test_the_law_put_into_8_and_9_gives_the_linear_system_of_13_and_14() -> None:
    planar = LEVEL.subs(psi, 0).subs({theta: PRINTED_20, phi: PRINTED_21}, simultaneous=True)
    assert is_zero(planar[0] - wanted_x)
    assert is_zero(planar[1] - wanted_y)


def test_the_law_with_the_sign_of_21_left_out_does_not() -> None:
    planar = LEVEL.subs(psi, 0).subs({theta: PRINTED_20, phi: -PRINTED_21}, simultaneous=True)
    assert not is_zero(planar[1] - wanted_y)


def test_the_law_for_any_heading_is_an_exact_inverse_and_the_papers_at_its_two_headings() -> None:
    in_heading = sp.Matrix([[sp.cos(psi), sp.sin(psi)], [-sp.sin(psi), sp.cos(psi)]])
    body = (in_heading * LEVEL[:2, 0]).applyfunc(sp.simplify)
    pitch, roll = GENERAL
    assert is_zero(body[0].subs({theta: pitch, phi: roll}, simultaneous=True) - FORWARD)
    assert is_zero(body[1].subs({theta: pitch, phi: roll}, simultaneous=True) - LEFT)
    for heading, sign in ((0, 1), (sp.pi, -1)):
        turned = {wanted_x: sign * wanted_x, wanted_y: sign * wanted_y}
        assert is_zero(pitch.subs(psi, heading) - PRINTED_20.subs(turned, simultaneous=True))
        assert is_zero(roll.subs(psi, heading) - PRINTED_21.subs(turned, simultaneous=True))


def test_equations_24_and_25_are_the_transforms_of_22_and_23_with_gain_c_over_lambda() -> None:
    answer, asked = sp.symbols("Theta Theta_des")
    transfer = sp.solve(sp.Eq(s * answer + lam * answer, c * asked), answer)[0] / asked
    assert is_zero(transfer - c / (s + lam))
    assert sp.limit(transfer, s, 0) == c / lam
    step = c / lam * (1 - sp.exp(-lam * t))
    assert is_zero(sp.laplace_transform(step, t, s, noconds=True) - transfer / s)
    assert is_zero(sp.diff(step, t) + lam * step - c)


def test_with_the_lag_the_loop_is_stable_exactly_when_beta_is_below_lambda_alpha() -> None:
    open_loop = (lam / (s + lam)) * (alpha * s + beta) / s**2
    polynomial = sp.Poly(sp.numer(sp.together(1 + open_loop)), s)
    assert [sp.expand(item) for item in polynomial.all_coeffs()] == [
        1,
        lam,
        alpha * lam,
        beta * lam,
    ]
    a2, a1, a0 = polynomial.all_coeffs()[1:]
    routh = sp.simplify((a2 * a1 - a0) / a2)
    assert sp.solve(routh, beta) == [alpha * lam]
    w = sp.Symbol("omega", positive=True)
    edge = sp.expand(polynomial.as_expr().subs({beta: alpha * lam, s: sp.I * w}))
    assert is_zero(edge.subs(w, sp.sqrt(alpha * lam)))
    inside = sp.expand(polynomial.as_expr().subs({beta: alpha * lam / 2, s: sp.I * w}))
    assert not is_zero(inside.subs(w, sp.sqrt(alpha * lam)))


def test_the_remark_after_21_turns_the_sign_of_the_gains_that_15_asks_for() -> None:
    """With x := x_ref - x and x' := -x', the error obeys (13) with both gains negated."""
    a, b, reference, pole = sp.symbols("a b r s", real=True)
    place = sp.Function("x")(t)
    law = {place.diff(t, 2): a * (0 - place.diff(t)) + b * (reference - place)}
    error = reference - place
    obeyed = error.diff(t, 2).subs(law)
    assert is_zero(obeyed - (-a * error.diff(t) - b * error))
    printed = (pole * sp.eye(2) - sp.Matrix([[0, 1], [b, a]])).det()
    closed = (pole * sp.eye(2) - sp.Matrix([[0, 1], [-b, -a]])).det()
    assert is_zero(printed - (pole**2 - a * pole - b))
    assert is_zero(closed - printed.subs({a: -a, b: -b}, simultaneous=True))


derived_acceleration = sp.lambdify((theta, phi, psi), list(LEVEL[:2, 0].subs(g, GRAVITY)))
derived_tilt = sp.lambdify((wanted_x, wanted_y, psi), [item.subs(g, GRAVITY) for item in GENERAL])
derived_paper_tilt = sp.lambdify(
    (wanted_x, wanted_y), [PRINTED_20.subs(g, GRAVITY), PRINTED_21.subs(g, GRAVITY)]
)


@given(angles, angles, headings)
def test_the_codes_acceleration_is_the_derived_one(
    pitch: float, roll: float, heading: float
) -> None:
    assert acceleration(pitch, roll, heading) == pytest.approx(
        derived_acceleration(pitch, roll, heading), abs=1e-11
    )


@given(accelerations, accelerations, headings, st.floats(0.5, 1.5))
def test_the_codes_law_is_the_derived_one_over_the_static_gain(
    ax: float, ay: float, heading: float, gain: float
) -> None:
    expected = [angle / gain for angle in derived_tilt(ax, ay, heading)]
    assert tilt(ax, ay, heading, gain) == pytest.approx(expected, abs=1e-12)


@given(accelerations, accelerations)
def test_the_codes_law_of_mode_paper_is_the_printed_one_at_both_headings(
    ax: float, ay: float
) -> None:
    assert paper_tilt(ax, ay, 1.0, 1.0) == pytest.approx(derived_paper_tilt(ax, ay), abs=1e-12)
    assert paper_tilt(ax, ay, -1.0, 1.0) == pytest.approx(derived_paper_tilt(-ax, -ay), abs=1e-12)


def test_the_codes_lag_is_the_derived_step_response() -> None:
    answer = sp.Function("theta")
    start = {answer(0): 0}
    solved = sp.dsolve(sp.Eq(answer(t).diff(t) + lam * answer(t), c), answer(t), ics=start)
    response = sp.lambdify((c, lam, t), solved.rhs)
    random = Random(22)
    for _ in range(100):
        pole, gain, time = (
            random.uniform(1.0, 15.0),
            random.uniform(0.5, 1.5),
            random.uniform(0.01, 2.0),
        )
        assert isclose(
            lagged(0.0, gain, pole, time), response(gain * pole, pole, time), abs_tol=1e-12
        )


def test_the_codes_drone_obeys_the_derived_equations_in_small_steps() -> None:
    """One short step of the model without drag, against eqs. (8), (9), (22) and (23)."""
    random, dt = Random(8), 1e-5
    for _ in range(100):
        pitch, roll, heading, asked = (random.uniform(-0.3, 0.3) for _ in range(4))
        constants = Constants(
            lag=random.uniform(3.0, 12.0), gain=random.uniform(0.7, 1.3), drag=0.0
        )
        body = DroneState(theta=pitch, phi=roll, psi=heading)
        after = drone_step(body, asked, -asked, 0.0, 0.0, (0.0, 0.0), constants, dt)
        expected = derived_acceleration(pitch, roll, heading)
        assert (after.vx / dt, after.vy / dt) == pytest.approx(expected, abs=1e-3)
        cc = constants.gain * constants.lag
        assert (after.theta - pitch) / dt == pytest.approx(
            cc * asked - constants.lag * pitch, abs=1e-3
        )
        assert (after.phi - roll) / dt == pytest.approx(
            -cc * asked - constants.lag * roll, abs=1e-3
        )


@given(accelerations, accelerations, st.floats(-2.0, 2.0), st.floats(-2.0, 2.0))
def test_the_codes_demand_is_13_and_14_in_the_error(
    ex: float, rate: float, a: float, b: float
) -> None:
    assert demand(ex, rate, 0.0, a, b) == pytest.approx(a * rate + b * ex, abs=1e-12)
