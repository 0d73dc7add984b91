"""What is asked of a drone that is not steered by tilt accelerates it as control wants."""

from __future__ import annotations

from math import cos, hypot, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.control.forms import (
    FormCode,
    FormModel,
    place_asked,
    velocity_asked,
)
from housefly.pilot.estimation.estimator_state import ControlState

GLIDER = FormModel(form=int(FormCode.VELOCITY), pull=3.0, speed_max=1.2)
HOMER = FormModel(
    form=int(FormCode.POSITION),
    pull=4.5,
    stiffness=6.0,
    climb_pull=3.0,
    speed_max=1.2,
    x_min=0.0,
    y_min=0.0,
    x_max=10.0,
    y_max=5.0,
    z_max=2.0,
)
accelerations = st.floats(-50.0, 50.0)
angles = st.floats(-10.0, 10.0)


def at(x: float, y: float, z: float) -> ControlState:
    return ControlState(
        position=(x, y), velocity=(0.0, 0.0), disturbance=(0.0, 0.0), height=z, yaw=0.0
    )


@given(accelerations, accelerations, angles)
def test_a_velocity_points_where_it_is_to_accelerate_and_is_never_too_fast(
    ax: float, ay: float, heading: float
) -> None:
    asked = velocity_asked(ax, ay, heading, GLIDER)
    c, s = cos(heading), sin(heading)
    vx, vy = c * asked.forward - s * asked.left, s * asked.forward + c * asked.left
    assert hypot(vx, vy) <= GLIDER.speed_max + 1e-9
    assert (asked.ux, asked.uy) == pytest.approx((GLIDER.pull * vx, GLIDER.pull * vy), abs=1e-9)
    if hypot(ax, ay) <= GLIDER.pull * GLIDER.speed_max:
        assert (asked.ux, asked.uy) == pytest.approx((ax, ay), abs=1e-9)


@given(accelerations, accelerations, st.floats(0.0, 10.0), st.floats(0.0, 5.0), st.floats(-1, 1))
def test_a_place_lies_in_the_room_and_the_estimator_is_told_what_it_makes_of_it(
    ax: float, ay: float, x: float, y: float, climb: float
) -> None:
    asked = place_asked(ax, ay, climb, at(x, y, 1.9), HOMER)
    assert 0.0 <= asked.x <= 10.0 and 0.0 <= asked.y <= 5.0 and asked.z <= 2.0
    reach = HOMER.speed_max * HOMER.pull / HOMER.stiffness
    assert hypot(asked.x - x, asked.y - y) <= reach + 1e-9
    assert asked.ux == pytest.approx(HOMER.stiffness * (asked.x - x))
    assert asked.uy == pytest.approx(HOMER.stiffness * (asked.y - y))


def test_where_nothing_is_wanted_a_velocity_is_none_and_a_place_is_here() -> None:
    still = velocity_asked(0.0, 0.0, 1.0, GLIDER)
    assert (still.forward, still.left) == (0.0, 0.0)
    here = place_asked(0.0, 0.0, 0.0, at(3.0, 2.0, 1.0), HOMER)
    assert (here.x, here.y, here.z) == (3.0, 2.0, 1.0)
