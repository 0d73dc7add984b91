from __future__ import annotations

from math import nan, sin

import numpy as np
import pytest

from housefly.pilot.estimation.delay_estimate import (
    DELAY_CHANGE_MAX,
    DelayEstimate,
    delay_deviation,
    delay_known,
    delay_learned,
    sensitivity_at,
)
from housefly.pilot.estimation.delay_filter import (
    COMMAND_SPAN,
    CommandHistory,
    axes_and_covariance_at,
    axes_at,
    command_recorded,
    delay_filter_advanced,
    delay_filter_created,
    delay_filter_initialized,
    delay_filter_updated,
)
from housefly.pilot.estimation.lagged_axis import (
    AxisModel,
    AxisState,
    initial_covariance,
    predicted_axis,
    transition,
)
from housefly.pilot.estimation.stream_health import StreamHealth, health_updated

MODEL = AxisModel(7.0, 1.0, 0.58, 2.0, 0.4, 0.2)
FIRST = initial_covariance(9e-6, 0.4)
R, TICK = 9e-6, 0.01
NOMINAL, DEVIATION = 0.06, 0.05


def push(at: float) -> float:
    """What a drone is told that flies to and fro [m/s^2]."""
    return 0.8 * sin(2.0 * at) + 0.3 * sin(5.0 * at)


class Delayed:
    """A drone that obeys late, and the filter that is told nothing of it."""

    def __init__(self, true_delay: float, lag: float = 7.0, rest: bool = False) -> None:
        self.model = AxisModel(lag, 1.0, 0.58, 2.0, 0.4, 0.2)
        self.delay, self.rest = true_delay, rest
        self.body = AxisState(0.0, 0.0, 0.0, 0.0)
        self.spans: CommandHistory = np.zeros(1024, COMMAND_SPAN)
        created = delay_filter_created(self.spans, 0.0, FIRST)
        self.h = delay_filter_initialized(created, self.spans, MODEL, NOMINAL, 0.0, 0.0, 0.0, FIRST)
        self.e: DelayEstimate = delay_known(NOMINAL, DEVIATION)
        self.health = StreamHealth(nan, nan, nan, nan)
        self.noise = np.random.default_rng(3)

    def fly(self, seconds: float) -> None:
        step = transition(self.model, True, 0.001)
        for n in range(round(seconds / TICK)):
            at = n * TICK
            self.h = delay_filter_advanced(self.h, self.spans, MODEL, self.e.delay, at)
            command_recorded(self.h, self.spans, 0.0 if self.rest else push(at), 0.0, True)
            if n > 0:
                self.see(at)
            for k in range(10):
                told = TICK * ((at + 0.001 * k - self.delay + 1e-9) // TICK)
                u = 0.0 if told < 0.0 or self.rest else push(told)
                self.body = predicted_axis(self.body, u, step)

    def see(self, at: float) -> None:
        x = self.body.x + self.noise.normal(0.0, 0.001)
        y = self.noise.normal(0.0, 0.001)
        p = axes_and_covariance_at(self.h, self.spans, MODEL, self.e.delay, at)
        sx, sy = sensitivity_at(self.e, self.h, self.spans, MODEL, p)
        dx, dy = x - p.x.x, y - p.y.x
        nis = 0.5 * (dx * dx + dy * dy) / (p.covariance.xx + R)
        self.health = health_updated(self.health, TICK, 0.0, nis, 1.0)
        self.e = delay_learned(
            self.e, sx, sy, p.covariance, dx, dy, R, self.health.nis, TICK, NOMINAL, DEVIATION
        )
        self.h = delay_filter_updated(self.h, self.spans, MODEL, self.e.delay, at, p, x, y, R)


def test_the_sensitivity_is_the_change_of_the_prediction_with_the_delay() -> None:
    """Held against two filters that differ by 2 ms of delay and are corrected by nothing."""
    looks = []
    for delay in (0.059, 0.061):
        spans: CommandHistory = np.zeros(256, COMMAND_SPAN)
        h = delay_filter_initialized(
            delay_filter_created(spans, 0.0, FIRST), spans, MODEL, delay, 0.0, 0.0, 0.0, FIRST
        )
        for n in range(60):
            h = delay_filter_advanced(h, spans, MODEL, delay, n * TICK)
            command_recorded(h, spans, push(n * TICK), -push(n * TICK), True)
        looks.append(axes_at(h, spans, MODEL, delay, 0.6)[0])
        there = axes_and_covariance_at(h, spans, MODEL, delay, 0.6)
        sx, sy = sensitivity_at(delay_known(delay, 0.03), h, spans, MODEL, there)
    slope = (looks[1].x - looks[0].x) / 0.002
    assert sx.x == pytest.approx(slope, rel=0.05)
    assert sy.x == pytest.approx(-sx.x)


@pytest.mark.parametrize("delay", [0.02, 0.06, 0.13])
def test_most_of_a_wrong_delay_is_found_within_twenty_seconds_of_flight(delay: float) -> None:
    drone = Delayed(delay)
    drone.fly(20.0)
    assert drone.e.delay == pytest.approx(delay, abs=0.012)
    assert delay_deviation(drone.e) < 0.016


def test_a_drone_at_rest_teaches_nothing() -> None:
    drone = Delayed(0.13, rest=True)
    drone.fly(5.0)
    assert drone.e.delay == pytest.approx(NOMINAL, abs=0.002)
    assert delay_deviation(drone.e) == pytest.approx(DEVIATION, rel=0.05)


def test_a_delay_is_never_believed_to_be_far_from_that_of_the_site() -> None:
    drone = Delayed(0.4)
    drone.fly(6.0)
    assert drone.e.delay <= NOMINAL + DELAY_CHANGE_MAX


def test_a_delay_without_doubt_is_known() -> None:
    assert delay_deviation(delay_known(0.06, 0.0)) == 0.0
