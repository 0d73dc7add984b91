"""The paper's equations one by one, where no other test holds them: numbers as printed, traps as
negative controls.
"""

from __future__ import annotations

from math import atan, cos, exp, pi, sin, tan

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from housefly.config.site import Site, site_from_tree
from housefly.errors import ConfigError
from housefly.geometry import GRAVITY, Vec3, quaternion_from_euler, rotate
from housefly.pilot.control.laws import acceleration, demand, tilt
from housefly.pilot.control.model import Constants, DroneState, drone_step

angles = st.floats(-1.2, 1.2)
headings = st.floats(-pi, pi)
GAINS = Site().control
THETA_MAX = 0.21


def printed_matrix(theta: float, phi: float, psi: float) -> np.ndarray:
    """Eq. (3), typed off the page."""
    ct, st_, cp, sp, cs, ss = cos(theta), sin(theta), cos(phi), sin(phi), cos(psi), sin(psi)
    return np.array(
        [
            [cs * ct, cs * st_ * sp - ss * cp, cs * st_ * cp + ss * sp],
            [ss * ct, ss * st_ * sp + cs * cp, ss * st_ * cp - cs * sp],
            [-st_, ct * sp, ct * cp],
        ]
    )


@given(angles, angles, headings)
def test_equation_3_is_our_rotation_with_theta_as_pitch_and_phi_as_roll(
    theta: float, phi: float, psi: float
) -> None:
    axes: tuple[Vec3, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    ours = np.column_stack([rotate(quaternion_from_euler(phi, theta, psi), axis) for axis in axes])
    assert ours == pytest.approx(printed_matrix(theta, phi, psi), abs=1e-12)


@given(angles, angles, headings, st.floats(0.1, 20.0), st.floats(0.1, 2.0))
def test_equations_5_to_7_are_newtons_law_and_equation_4_as_printed_is_not(
    theta: float, phi: float, psi: float, thrust: float, mass: float
) -> None:
    lift = printed_matrix(theta, phi, psi) @ np.array([0.0, 0.0, thrust])
    right = lift / mass - np.array([0.0, 0.0, GRAVITY])
    x = (cos(phi) * sin(theta) * cos(psi) + sin(phi) * sin(psi)) / mass * thrust
    y = (cos(phi) * sin(theta) * sin(psi) - sin(phi) * cos(psi)) / mass * thrust
    z = cos(phi) * cos(theta) / mass * thrust - GRAVITY
    assert right == pytest.approx([x, y, z], abs=1e-9)
    literal = (lift - np.array([0.0, 0.0, -GRAVITY])) / mass
    assert abs(literal[2] - z) > GRAVITY


@given(angles, angles)
def test_equations_8_and_9_hold_at_both_headings_of_the_paper(theta: float, phi: float) -> None:
    for psi, sign in ((0.0, 1.0), (pi, -1.0)):
        ax, ay = acceleration(theta, phi, psi)
        assert ax == pytest.approx(sign * GRAVITY * tan(theta), abs=1e-9)
        assert ay == pytest.approx(-sign * GRAVITY * tan(phi) / cos(theta), abs=1e-9)


@given(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_equations_16_to_21_turn_the_dynamics_into_the_linear_system(
    ex: float, ey: float, vx: float, vy: float
) -> None:
    ax, ay = (demand(e, -v, 0.0, GAINS.alpha, GAINS.beta) for e, v in ((ex, vx), (ey, vy)))
    theta, phi = tilt(ax, ay, 0.0, 1.0)
    assert GRAVITY * tan(theta) == pytest.approx(ax, abs=1e-9)
    assert -GRAVITY * tan(phi) == pytest.approx(cos(theta) * ay, abs=1e-9)
    assert acceleration(theta, phi, 0.0) == pytest.approx(
        (GAINS.beta * ex - GAINS.alpha * vx, GAINS.beta * ey - GAINS.alpha * vy)
    )


def test_equation_15_is_stable_in_the_error_only_with_positive_gains() -> None:
    def slowest(alpha: float, beta: float) -> float:
        """The error obeys e'' = -alpha e' - beta e, so A carries the gains with a minus."""
        axis = np.array([[0.0, 1.0], [-beta, -alpha]])
        return float(np.linalg.eigvals(np.kron(np.eye(2), axis)).real.max())

    assert slowest(GAINS.alpha, GAINS.beta) == pytest.approx(-1.8, abs=1e-6)
    assert slowest(-2.0, -1.5) > 0.0


@given(st.floats(0.6, 49.0), st.floats(0.2, 19.0), st.floats(0.1, 49.0))
def test_with_the_lag_of_equation_22_the_loop_is_stable_exactly_where_a_site_is_accepted(
    lag: float, alpha: float, beta: float
) -> None:
    assume(abs(beta / (lag * alpha) - 1.0) > 1e-3)
    stable = np.roots([1.0, lag, lag * alpha, lag * beta]).real.max() < 0.0
    tree = {"drone": {"attitude_lag": lag}, "control": {"alpha": alpha, "beta": beta}}
    if stable:
        assert site_from_tree(tree).control.beta == beta
    else:
        with pytest.raises(ConfigError, match="unstable"):
            site_from_tree(tree)


def test_equations_22_to_25_have_the_gain_c_over_lambda_and_the_law_divides_by_it() -> None:
    constants = Constants(lag=6.0, gain=0.8)
    asked = 0.4 * THETA_MAX
    body = DroneState()
    for tick in range(1, 301):
        body = drone_step(body, asked, -asked, 0.0, 0.0, (0.0, 0.0), constants, 0.01)
        assert body.theta == pytest.approx(0.8 * asked * (1.0 - exp(-6.0 * 0.01 * tick)), abs=1e-9)
        assert body.phi == -body.theta
    assert 0.8 * tilt(1.0, 0.0, 0.0, 0.8)[0] == pytest.approx(atan(1.0 / GRAVITY))


def test_a_step_of_one_paper_cell_saturates_nothing_with_our_gains() -> None:
    a_max = GRAVITY * tan(THETA_MAX)
    assert a_max == pytest.approx(2.09, abs=0.005)
    assert tilt(GAINS.beta * 0.5, 0.0, 0.0, 1.0)[0] < THETA_MAX
    assert tilt(4.3 * 0.5, 0.0, 0.0, 1.0)[0] > THETA_MAX
