from __future__ import annotations

from math import exp, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from housefly.pilot.control.laws import acceleration
from housefly.pilot.control.model import Constants, DroneState, drone_step, lagged

tilts = st.floats(-0.21, 0.21)


def twin(
    body: DroneState,
    wanted: tuple[float, float, float, float],
    wind: tuple[float, float],
    c: Constants,
    t: float,
) -> DroneState:
    """Integrate the same differential equations with an independent solver."""

    def rate(_: float, s: np.ndarray) -> list[float]:
        _x, _y, _z, psi, vx, vy, vz, r, theta, phi = s
        ax, ay = acceleration.py_func(theta, phi, psi)  # type: ignore[attr-defined]
        return [
            vx,
            vy,
            vz,
            r,
            ax - c.drag * vx + wind[0],
            ay - c.drag * vy + wind[1],
            c.climb_lag * (wanted[2] - vz),
            c.yaw_lag * (wanted[3] - r),
            c.lag * (c.gain * wanted[0] - theta),
            c.lag * (c.gain * wanted[1] - phi),
        ]

    return DroneState(*solve_ivp(rate, (0.0, t), list(body), rtol=1e-9, atol=1e-11).y[:, -1])


@pytest.mark.parametrize(
    "wanted", [(0.1, -0.05, 0.3, 0.5), (-0.2, 0.2, -0.7, -1.0), (0.0, 0.0, 0.0, 0.0)]
)
def test_half_a_second_of_steps_agrees_with_an_independent_solver(
    wanted: tuple[float, float, float, float],
) -> None:
    start = DroneState(1.0, 2.0, 1.1, 0.4, 0.3, -0.2, 0.1, 0.2, 0.05, -0.03)
    body, constants = start, Constants(lag=7.0, gain=0.9, drag=0.58)
    for _ in range(100):
        body = drone_step(body, *wanted, (0.1, -0.2), constants, 0.005)
    assert tuple(body) == pytest.approx(
        tuple(twin(start, wanted, (0.1, -0.2), constants, 0.5)), abs=2e-4
    )


@given(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(0.5, 50.0), st.floats(0.0, 1.0))
def test_first_order_response_is_exact(value: float, target: float, pole: float, dt: float) -> None:
    assert lagged(value, target, pole, dt) == pytest.approx(
        target + (value - target) * exp(-pole * dt), abs=1e-12
    )


@given(tilts, tilts, st.floats(-pi, pi))
def test_compiled_step_equals_the_plain_one(theta: float, phi: float, psi: float) -> None:
    body = DroneState(psi=psi, vx=0.3, vy=-0.1, theta=0.02)
    arguments = (body, theta, phi, 0.2, 0.1, (0.0, 0.0), Constants(), 0.01)
    assert tuple(drone_step(*arguments)) == pytest.approx(
        tuple(drone_step.py_func(*arguments)), abs=1e-14
    )  # type: ignore[attr-defined]


def test_drag_gives_the_top_speed_that_the_tilt_limit_allows() -> None:
    body = DroneState()
    for _ in range(3000):
        body = drone_step(body, 0.21, 0.0, 0.0, 0.0, (0.0, 0.0), Constants(), 0.01)
    assert body.vx == pytest.approx(acceleration(0.21, 0.0, 0.0)[0] / 0.58, rel=1e-3)
