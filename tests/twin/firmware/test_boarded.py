"""Rotors follow what they are told, and turn the body the way they should."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.geometry import GRAVITY
from housefly.twin.drone_mechanics import mechanics_of
from housefly.twin.firmware.boarded import Rotors, lift
from housefly.twin.simulated_body import MOTORS_OFF, Wrench

BEBOP = mechanics_of(airframe_named("arducopter"))
throttles = st.floats(0.0, 1.0)


def settled(*told: float) -> Wrench:
    front_left, front_right, rear_right, rear_left = told
    rotors = Rotors(BEBOP)
    for _ in range(400):
        pushed = rotors.step((front_left, front_right, rear_right, rear_left), 0.0025)
    return pushed


@given(throttles, throttles)
def test_more_throttle_is_more_lift_up_to_the_whole(low: float, high: float) -> None:
    low, high = sorted((low, high))
    assert 0.0 <= lift(low) <= lift(high) <= 1.0
    assert lift(1.0) == 1.0 and lift(0.0) == 0.0


def test_all_rotors_at_full_throttle_have_the_full_thrust_and_no_torque() -> None:
    assert settled(1.0, 1.0, 1.0, 1.0) == pytest.approx((BEBOP.thrust_max, 0.0, 0.0, 0.0))
    assert settled(0.0, 0.0, 0.0, 0.0) == MOTORS_OFF


def test_the_left_rotors_lift_the_left_side_the_rear_ones_the_tail() -> None:
    assert settled(0.7, 0.5, 0.5, 0.7).roll > 0.01
    assert settled(0.5, 0.5, 0.7, 0.7).pitch > 0.01
    assert settled(0.7, 0.5, 0.7, 0.5).yaw > 0.001


def test_a_rotor_needs_a_while() -> None:
    rotors = Rotors(BEBOP)
    told = (0.65, 0.65, 0.65, 0.65)
    first = rotors.step(told, 0.0025).thrust
    later = [rotors.step(told, 0.0025).thrust for _ in range(40)]
    assert first < later[0] < later[7] < later[-1]
    assert later[-1] == pytest.approx(BEBOP.mass * GRAVITY, rel=0.05)
