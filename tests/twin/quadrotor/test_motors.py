"""Four motors: a wrench in, what is left of it out."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.twin.quadrotor.inner_loops import THRUST_MAX
from housefly.twin.quadrotor.motors import achieved_wrench
from housefly.twin.simulated_body import MOTORS_OFF, Wrench

GAINS = st.tuples(*[st.floats(0.0, 1.0)] * 4)
WRENCHES = st.builds(
    Wrench,
    thrust=st.floats(0.0, THRUST_MAX),
    roll=st.floats(-2.0, 2.0),
    pitch=st.floats(-2.0, 2.0),
    yaw=st.floats(-1.0, 1.0),
)
STRONG = (1.0, 1.0, 1.0, 1.0)
HOVER = Wrench(4.28, 0.0, 0.0, 0.0)


@given(st.floats(3.0, 5.0), *[st.floats(-0.02, 0.02)] * 2, st.floats(-0.005, 0.005))
def test_strong_motors_give_what_is_asked_within_their_means(
    thrust: float, roll: float, pitch: float, yaw: float
) -> None:
    asked = Wrench(thrust, roll, pitch, yaw)
    assert achieved_wrench(asked, STRONG) == pytest.approx(asked, abs=1e-9)


@given(WRENCHES, GAINS, st.floats(0.5, 1.0))
def test_no_motor_pulls_down_and_none_gives_more_than_it_has(
    asked: Wrench, gains: tuple[float, float, float, float], voltage: float
) -> None:
    got = achieved_wrench(asked, gains, voltage)
    assert -1e-9 <= got.thrust <= THRUST_MAX * voltage**2 * max(gains) + 1e-9


@given(WRENCHES)
def test_yaw_is_given_up_before_lift_and_attitude(asked: Wrench) -> None:
    with_yaw, without = (
        achieved_wrench(asked, STRONG),
        achieved_wrench(asked._replace(yaw=0.0), STRONG),
    )
    assert with_yaw[:3] == pytest.approx(without[:3], abs=1e-9)


def test_a_weak_front_left_motor_lets_the_drone_fall_forward_and_to_the_left() -> None:
    got = achieved_wrench(HOVER, (0.6, 1.0, 1.0, 1.0))
    assert got.thrust == pytest.approx(0.9 * HOVER.thrust)
    assert got.roll < -0.05
    assert got.pitch > 0.05


def test_motors_that_are_off_stay_off() -> None:
    assert achieved_wrench(Wrench(0.0, 1.0, 1.0, 1.0), STRONG) == MOTORS_OFF


def test_full_thrust_falls_with_the_square_of_the_voltage() -> None:
    full = achieved_wrench(Wrench(THRUST_MAX, 0.0, 0.0, 0.0), STRONG, 0.8)
    assert full.thrust == pytest.approx(0.64 * THRUST_MAX)
