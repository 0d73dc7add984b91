"""Air, lines and loads: which way they push, and how hard."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import Vec3, quaternion_from_euler
from housefly.twin.disturbance import CeilingFan, Disturbances, Payload, Tether
from housefly.twin.external_forces import ExternalForces, downwash_at
from housefly.twin.simulated_body import CONTROL_PERIOD, BodyState

DRAG, MASS = 0.58, 0.436
PLACES = st.tuples(*[st.floats(-5.0, 5.0)] * 3)
SPEEDS = st.tuples(*[st.floats(-2.0, 2.0)] * 3)


def at(position: Vec3, velocity: Vec3 = (0.0, 0.0, 0.0), theta: float = 0.0) -> BodyState:
    still = (0.0, 0.0, 0.0)
    return BodyState(position, quaternion_from_euler(0.0, theta, 0.0), velocity, still, still)


@given(PLACES, SPEEDS, PLACES, st.floats(0.0, 5.0), st.floats(0.1, 500.0))
def test_a_tether_pulls_towards_its_anchor_and_only_when_taut(
    place: Vec3, velocity: Vec3, anchor: Vec3, length: float, stiffness: float
) -> None:
    tied = Disturbances(tether=Tether(anchor, length, stiffness))
    force, torque = ExternalForces(1, DRAG, MASS).step(tied, at(place, velocity))
    towards = tuple(b - a for a, b in zip(place, anchor, strict=True))
    reach = hypot(*towards)
    assert torque == (0.0, 0.0, 0.0)
    if reach <= length:
        assert force == (0.0, 0.0, 0.0)
    else:
        along = sum(f * d for f, d in zip(force, towards, strict=True)) / reach
        assert along == pytest.approx(hypot(*force), abs=1e-9)


@given(st.floats(0.0, 3.0), st.floats(0.0, 3.0))
def test_the_air_below_a_fan_falls_no_faster_farther_out(near: float, far: float) -> None:
    fan = CeilingFan((1.0, 2.0), 0.6, 1.5)
    near, far = sorted((near, far))
    inner, outer = (downwash_at(fan, (1.0 + out, 2.0, 1.0)) for out in (near, far))
    assert 1.5 >= inner >= outer >= 0.0
    assert near > 0.6 or inner == pytest.approx(1.5)
    assert far < 0.9 or outer == 0.0


@given(st.floats(0.0, 0.5))
def test_gusts_do_not_blow_through_the_floor(height: float) -> None:
    rough = Disturbances(gust=1.0, gust_time=0.5)
    free, near = (
        ExternalForces(1, DRAG, MASS)._wind(rough, at((0.0, 0.0, z))) for z in (1.0, height)
    )
    assert near[:2] == free[:2]
    assert near[2] == pytest.approx(2.0 * height * free[2])


def test_gusts_have_the_size_and_the_memory_that_is_asked() -> None:
    forces = ExternalForces(1, DRAG, MASS)
    rough = Disturbances(gust=1.0, gust_time=0.5)
    speeds = np.array([forces._wind(rough, at((0.0, 0.0, 1.0))) for _ in range(60_000)])
    assert speeds.std(axis=0) == pytest.approx([1.0, 1.0, 0.5], rel=0.15)
    after = round(0.5 / CONTROL_PERIOD)
    x = speeds[:, 0]
    assert np.mean(x[after:] * x[:-after]) / np.var(x) == pytest.approx(np.exp(-1.0), abs=0.15)


def test_a_load_ahead_of_the_middle_turns_the_nose_down_and_less_when_the_drone_leans() -> None:
    carried = Disturbances(payload=Payload(0.05, (0.1, 0.0, 0.0)))
    level, leaning = (
        ExternalForces(1, DRAG, MASS).step(carried, at((0.0, 0.0, 1.0), theta=theta))
        for theta in (0.0, 0.5)
    )
    assert level.torque == pytest.approx((0.0, 0.05 * 9.81 * 0.1, 0.0), abs=1e-3)
    assert leaning.torque[1] == pytest.approx(level.torque[1] * np.cos(0.5))
    assert level.force == (0.0, 0.0, 0.0), "its weight is the body's own"
