"""The shortest time: no flight can be faster, and bang-bang flight takes exactly that long."""

from __future__ import annotations

from math import log1p, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import GRAVITY
from quality_gate.time_bound import shortest_time

LENGTHS, SPEEDS = st.floats(0.05, 30.0), st.floats(0.1, 3.0)
TILTS, DRAGS = st.floats(0.05, 0.5), st.floats(0.0, 2.0)


@given(LENGTHS, SPEEDS, TILTS, DRAGS)
def test_nothing_is_faster_than_the_speed_limit_all_the_way(
    length: float, speed: float, tilt: float, drag: float
) -> None:
    assert shortest_time(length, speed, tilt, drag) > length / speed


@given(LENGTHS, st.floats(0.0, 5.0), SPEEDS, TILTS, DRAGS)
def test_a_longer_way_takes_longer(
    length: float, more: float, speed: float, tilt: float, drag: float
) -> None:
    short = shortest_time(length, speed, tilt, drag)
    assert shortest_time(length + more, speed, tilt, drag) >= short - 1e-9


@pytest.mark.parametrize(
    ("length", "speed", "tilt", "drag"),
    [(6.0, 1.0, 0.21, 0.58), (0.8, 2.0, 0.21, 0.58), (10.0, 0.5, 0.1, 0.2), (3.0, 3.0, 0.3, 1.5)],
)
def test_it_is_the_time_of_a_flight_that_speeds_up_keeps_the_limit_and_brakes(
    length: float, speed: float, tilt: float, drag: float
) -> None:
    push, dt = GRAVITY * tan(tilt), 1e-3
    v, s, now = 0.0, 0.0, 0.0
    while s < length - 1e-4 and now < 60.0:
        if length - s <= _braking_way(v, push, drag):
            v = max(v - (push + drag * v) * dt, 1e-3)
        else:
            v = min(v + (push - drag * v) * dt, speed)
        s, now = s + v * dt, now + dt
    assert shortest_time(length, speed, tilt, drag) == pytest.approx(now, abs=0.05)


def _braking_way(v: float, push: float, drag: float) -> float:
    """Integral of v / (push + drag v) from rest."""
    return v / drag - push / drag**2 * log1p(drag * v / push)


def test_the_errands_of_bsen_take_what_is_known() -> None:
    """25 ways of 6.03 m, 150.8 m in all, at 0.5, 1 and 2 m/s."""
    took = [25 * shortest_time(150.8 / 25, speed, 0.21, 0.58) for speed in (0.5, 1.0, 2.0)]
    assert took == pytest.approx([307.5, 162.8, 100.0], rel=0.01)
