"""A place is held, and reached, by the drone's own motion alone."""

from __future__ import annotations

from math import cos, hypot, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.control.flow_hold import (
    CLIMB_MAX,
    CLIMB_MIN,
    TILT_MAX,
    FlowHold,
    climb_to,
)
from housefly.pilot.control.model import Constants, DroneState, drone_step

TICK = 0.02
DELAY = 4
"""Steps after which flow, command and tilt act together, beside the drone's own lag."""


def fly(push: tuple[float, float], yaw: float, start: tuple[float, float]) -> list[float]:
    """Return how far the drone is from the origin in every step [m]."""
    state, hold = DroneState(x=start[0], y=start[1], psi=yaw), FlowHold(0.0)
    seen, away = [state] * DELAY, []
    for n in range(round(12.0 / TICK)):
        late = seen[-DELAY]
        error = (-late.x, -late.y)
        hold = hold.pushed(error, n * TICK)
        asked = hold.setpoint(error, (-late.vx, -late.vy), (0.0, 0.0), 0.0, yaw, 1.0, 0.21)
        assert hypot(asked.theta, asked.phi) <= TILT_MAX + 1e-9
        state = drone_step(state, asked.theta, asked.phi, 0.0, 0.0, push, Constants(), TICK)
        seen.append(state)
        away.append(hypot(state.x, state.y))
    return away


@pytest.mark.parametrize("yaw", [0.0, 1.3, -2.6])
def test_a_place_is_reached_and_kept_in_a_draught_at_any_heading(yaw: float) -> None:
    away = fly((0.3 * cos(yaw), 0.3 * sin(yaw)), yaw, (0.8, -0.6))
    assert away[-1] < 0.1
    assert max(away) < 1.2


@given(st.floats(0.3, 2.5), st.floats(0.0, 3.0), st.booleans())
def test_it_is_never_told_to_keep_the_height_of_its_sonar(
    wanted: float, z: float, may_sink: bool
) -> None:
    climb = climb_to(wanted, (0.0, 0.0, z), may_sink)
    assert CLIMB_MIN <= abs(climb) <= CLIMB_MAX
    assert (climb > 0.0) == (wanted > z)
    assert may_sink or climb >= -CLIMB_MIN
