from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.pilot.control.landing_aim import AIM_MAX, landing_drift

AIRFRAME = airframe_named("ardrone")
BRAKE = 2.08
pushes = st.floats(-0.6, 0.6)


@given(pushes, pushes, st.floats(0.1, 0.5))
def test_the_drift_is_that_of_a_drone_that_brakes_and_is_pushed(
    x: float, y: float, height: float
) -> None:
    speed = way = 0.0
    dt = 1e-4
    for _ in range(
        round((height - AIRFRAME.body.standing_height) / AIRFRAME.landing.sink_rate / dt)
    ):
        way += dt * speed
        speed += dt * (1.0 - BRAKE * speed)
    drift = landing_drift((x, y), height, BRAKE, AIRFRAME)
    wanted = [min(max(push * way, -AIM_MAX), AIM_MAX) for push in (x, y)]
    assert drift == pytest.approx(wanted, abs=1e-4)


def test_in_still_air_and_on_the_floor_there_is_none() -> None:
    assert landing_drift((0.0, 0.0), 0.3, BRAKE, AIRFRAME) == (0.0, 0.0)
    assert landing_drift((0.5, 0.5), 0.05, BRAKE, AIRFRAME) == (0.0, 0.0)


def test_a_storm_does_not_send_the_drone_away() -> None:
    assert landing_drift((5.0, -5.0), 0.5, BRAKE, AIRFRAME) == (AIM_MAX, -AIM_MAX)
