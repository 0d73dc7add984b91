"""The pattern stays in the checked box for any drone within a factor of two."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.lab.identification.pattern import (
    TILT_AXES,
    Axis,
    Block,
    blocks,
    excursion,
    largest_excursion,
)
from housefly.pilot.control.model import Constants, DroneState, drone_step

PLAN = blocks(4, 0.21)


@settings(max_examples=40, deadline=None)
@given(
    st.floats(3.5, 14.0),
    st.floats(0.8, 1.25),
    st.floats(0.29, 1.16),
    st.floats(0.0, 0.12),
    st.sampled_from(PLAN),
)
def test_no_drone_within_a_factor_of_two_leaves_the_predicted_excursion(
    lag: float, gain: float, drag: float, delay: float, block: Block
) -> None:
    if block.axis not in TILT_AXES:
        return
    allowed = largest_excursion(PLAN, 7.0, 1.0, 0.58, 0.06)
    body, reach = DroneState(), 0.0
    for step in range(round((block.duration + delay) / 0.01)):
        value = block.asked(step * 0.01 - delay)
        theta, phi = (value, 0.0) if block.axis is Axis.PITCH else (0.0, value)
        body = DroneState(
            *drone_step(body, theta, phi, 0.0, 0.0, (0.0, 0.0), Constants(lag, gain, drag), 0.01)
        )
        reach = max(reach, abs(body.x), abs(body.y))
    assert reach <= allowed + 0.005


def test_the_predicted_excursion_is_that_of_the_drone() -> None:
    assert excursion(PLAN[0], 7.0, 1.0, 0.58, 0.06) == pytest.approx(0.21, abs=0.02)


def test_every_axis_is_flown_both_ways_and_asks_nothing_after_its_last_part() -> None:
    for axis in Axis:
        signs = {np.sign(block.amplitude) for block in PLAN if block.axis is axis}
        assert signs == {-1.0, 1.0}
    assert all(
        block.asked(block.duration + 0.01) == 0.0 and block.asked(-0.01) == 0.0 for block in PLAN
    )


@given(st.sampled_from(PLAN))
def test_a_block_asks_of_its_own_axis_alone(block: Block) -> None:
    setpoint = block.setpoint(0.5 * block.part)
    asked = {
        Axis.PITCH: setpoint.theta,
        Axis.ROLL: setpoint.phi,
        Axis.CLIMB: setpoint.vz,
        Axis.TURN: setpoint.yaw_rate,
    }
    assert asked.pop(block.axis) == block.amplitude
    assert set(asked.values()) == {0.0}
