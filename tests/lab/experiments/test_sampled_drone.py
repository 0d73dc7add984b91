from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.random import sown
from housefly.lab.experiments.sampled_drone import (
    ORDER,
    ORDER_RING_SIZE,
    carried_on,
    gusted,
    sampled_drone,
)
from housefly.lab.experiments.tracking_noise import FRAME, FRAMES, Camera, stream_begun
from housefly.pilot.control.model import DroneState, drone_step, hover_tilt

BLIND = Camera(1e-6, 0.999, 0.0, 0.0, 0.0, 0.0)


def flown(case: np.ndarray, theta: list[float]) -> list[DroneState]:
    """Fly one pitch a tick and return the drone at each tick."""
    orders, frames, random = (
        np.zeros(ORDER_RING_SIZE, ORDER),
        np.zeros(FRAMES, FRAME),
        np.zeros(1, np.uint64),
    )
    air, stream, body = sampled_drone(case), stream_begun(BLIND), DroneState(z=1.0)
    bodies = [body]
    for tick, angle in enumerate(theta):
        orders[tick & (ORDER_RING_SIZE - 1)] = (1, angle, *[0.0] * (len(ORDER) - 2))
        now = tick / float(case["rate_hz"])
        body, stream = carried_on(
            body, stream, tick, now, air, (0.0, 0.0), orders, BLIND, frames, random
        )
        bodies.append(body)
    return bodies


@settings(max_examples=25)
@given(st.sampled_from([20.0, 50.0, 100.0, 160.0]), st.floats(0.0, 0.3), st.floats(2.0, 20.0))
def test_an_order_acts_one_delay_after_it_was_sent_at_any_rate(
    rate: float, delay: float, lag: float
) -> None:
    case = cases(Site(), 1, rate_hz=rate, delay=delay, lag=lag)[0]
    bodies = flown(case, [0.1] * int(rate))
    for tick, body in enumerate(bodies):
        felt = max(tick / rate - delay, 0.0)
        assert body.theta == pytest.approx(0.1 * (1.0 - np.exp(-lag * felt)), abs=1e-7)


def test_a_flight_agrees_with_many_tiny_steps_of_the_live_model() -> None:
    case = cases(Site(), 1, rate_hz=30.0, delay=0.047)[0]
    asked = [0.1 * np.sin(0.3 * n) for n in range(60)]
    body, dt = DroneState(z=1.0), 1e-4
    for n in range(round(60 / 30.0 / dt)):
        sent = int(np.floor(((n + 0.5) * dt - 0.047) * 30.0))
        theta, phi = (asked[sent], 0.0) if sent >= 0 else hover_tilt(body, (0.0, 0.0), 0.21)
        constants = sampled_drone(case).constants
        body = drone_step(body, theta, phi, 0.0, 0.0, (0.0, 0.0), constants, dt)
    assert tuple(flown(case, asked)[-1]) == pytest.approx(tuple(body), abs=1e-4)


def test_its_own_hover_brakes_and_leans_against_the_wind() -> None:
    body, wind = DroneState(z=1.0, vx=0.6, vy=-0.3, psi=0.7), (0.3, -0.1)
    constants = sampled_drone(cases(Site(), 1)[0]).constants
    for _ in range(800):
        theta, phi = hover_tilt(body, wind, 0.21)
        body = drone_step(body, theta, phi, 0.0, 0.0, wind, constants, 0.01)
    assert np.hypot(body.vx, body.vy) < 0.01


def test_gusts_have_the_size_asked_and_last_about_a_second() -> None:
    air, random = sampled_drone(cases(Site(), 1, gust=0.2)[0]), np.zeros(1, np.uint64)
    sown(random, 4)
    gust, pushes = (0.0, 0.0), []
    for _ in range(60_000):
        gust = gusted(gust, air, random)
        pushes.append(gust[0])
    series = np.array(pushes)
    assert series.std() == pytest.approx(0.2, rel=0.1)
    assert np.corrcoef(series[:-100], series[100:])[0, 1] == pytest.approx(np.exp(-1.0), abs=0.1)
