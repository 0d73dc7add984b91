from __future__ import annotations

from math import cos, nan, pi, sin

import numpy as np
import pytest
from ardrone_flow import FLOW
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.pilot.estimation.flow_model import flow_bias_variance
from housefly.pilot.estimation.onboard_odometry import (
    MOTION_RING_SIZE,
    ONBOARD_MOTION,
    REPORT_GAP_MAX,
    SPEED_LOST,
    UNTOLD_AFTER,
    MotionRing,
    OdometryState,
    OnboardReport,
    odometry_advanced,
    odometry_at,
    odometry_begun,
    odometry_headed,
)

LEVEL = OnboardReport(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, True, nan)


def ring() -> MotionRing:
    return np.zeros(MOTION_RING_SIZE, ONBOARD_MOTION)


def begun(motion: MotionRing, yaw: float, psi: float = 0.0, at: float = 0.0) -> OdometryState:
    """Return the odometry of a drone that tracking saw once, at a heading [rad]."""
    state = odometry_advanced(odometry_begun(FLOW), motion, LEVEL._replace(at=at, psi=psi))
    return odometry_headed(state, motion, at, yaw)


@settings(max_examples=30)
@given(
    st.floats(-pi, pi),
    st.floats(-pi, pi),
    st.floats(-1.0, 1.0),
    st.floats(0.1, 1.0),
    st.floats(-0.2, 0.2),
    st.floats(-0.2, 0.2),
    st.floats(-0.5, 0.5),
)
def test_a_circle_at_any_heading_tilt_and_climb_is_followed(
    yaw: float, psi: float, rate: float, speed: float, theta: float, phi: float, vz: float
) -> None:
    motion = ring()
    state = begun(motion, yaw, psi)
    x = y = 0.0
    for tick in range(1, 301):
        at = 0.01 * tick
        then = at - FLOW.delay
        forward = speed * cos(theta) - vz * sin(theta)
        left = speed * sin(theta) * sin(phi) + vz * cos(theta) * sin(phi)
        report = OnboardReport(at, theta, phi, psi + rate * at, forward, left, 1.0, vz, True, nan)
        state = odometry_advanced(state, motion, report)
        heading = yaw + rate * then
        x += 0.01 * speed * cos(heading)
        y += 0.01 * speed * sin(heading)
    found = odometry_at(state, motion, 3.0 - FLOW.delay)
    assert (found.x, found.y) == pytest.approx((x, y), abs=0.06 * speed)
    assert found.way == pytest.approx(3.0 * speed, rel=0.05)


def test_after_the_newest_report_it_goes_on_for_a_while() -> None:
    motion = ring()
    state = begun(motion, 0.0)
    for tick in range(1, 101):
        state = odometry_advanced(state, motion, LEVEL._replace(at=0.01 * tick, forward=0.5))
    newest = odometry_at(state, motion, 1.0 - FLOW.delay)
    ahead = odometry_at(state, motion, 1.0)
    assert ahead.x - newest.x == pytest.approx(0.5 * FLOW.delay)
    far = odometry_at(state, motion, 5.0)
    assert far.x - newest.x == pytest.approx(0.5 * REPORT_GAP_MAX)


def test_a_gap_of_the_reports_is_a_hole() -> None:
    motion = ring()
    state = begun(motion, 0.0)
    for tick in range(1, 51):
        state = odometry_advanced(
            state, motion, LEVEL._replace(at=0.01 * tick, forward=0.5 + 1e-6 * tick)
        )
    assert state.since <= 0.01
    after = 0.5 + REPORT_GAP_MAX + 0.01
    state = odometry_advanced(state, motion, LEVEL._replace(at=after, forward=0.5 + 1e-6 * tick))
    assert state.since == after


def test_reports_that_were_never_read_are_a_hole_though_the_next_one_came_at_once() -> None:
    """A driver that was held up reads the oldest report that waits, then the newest."""
    motion = ring()
    state = begun(motion, 0.0)
    for tick in range(1, 51):
        at = 0.01 * tick
        report = LEVEL._replace(at=at, forward=0.5 + 1e-6 * tick, drone_time=7.0 + at)
        state = odometry_advanced(state, motion, report)
    assert state.since <= 0.01
    late = LEVEL._replace(at=0.75, forward=0.5, drone_time=7.52)
    newest = LEVEL._replace(at=0.76, forward=0.5, drone_time=7.52 + REPORT_GAP_MAX + 0.01)
    state = odometry_advanced(state, motion, late)
    assert state.since <= 0.01
    state = odometry_advanced(state, motion, newest)
    assert state.since == 0.76


def test_a_stall_of_the_link_does_not_lengthen_the_way_of_a_drone_that_tells_its_time() -> None:
    motion = ring()
    state = begun(motion, 0.0)
    at = told = 0.0
    for tick in range(1, 101):
        at += 0.21 if tick % 25 == 0 else 0.01
        told += 0.01
        report = LEVEL._replace(at=at, forward=0.5, drone_time=told)
        state = odometry_advanced(state, motion, report)
    found = odometry_at(state, motion, at - FLOW.delay)
    assert found.x == pytest.approx(0.5 * told, abs=0.01)


def test_around_a_link_that_stood_still_the_place_is_a_guess() -> None:
    motion = ring()
    state = begun(motion, 0.0)
    at = 0.0
    for tick in range(1, 101):
        # After the stall an old report comes first, then the newest.
        at += {50: 0.22, 51: 0.01}.get(tick, 0.01)
        told = at - (0.21 if tick == 50 else 0.0)
        state = odometry_advanced(
            state, motion, LEVEL._replace(at=at, forward=0.5, drone_time=told)
        )
        assert odometry_at(state, motion, at).stalled == (tick in (50, 51))
    assert odometry_at(state, motion, at - FLOW.delay).x == pytest.approx(0.5 * at, abs=0.03)


@pytest.mark.parametrize("told", [7.0, nan, -1.0], ids=["stands", "is not told", "goes back"])
def test_a_clock_of_the_drone_that_does_not_run_does_not_count(told: float) -> None:
    motion = ring()
    state = begun(motion, 0.0)
    for tick in range(1, 101):
        at = 0.01 * tick
        clock = -at if told < 0.0 else told
        report = LEVEL._replace(at=at, forward=0.5, drone_time=clock)
        state = odometry_advanced(state, motion, report)
    assert odometry_at(state, motion, 1.0 - FLOW.delay).x == pytest.approx(0.5, abs=0.01)


def test_a_velocity_of_exactly_zero_in_flight_is_none() -> None:
    motion = ring()
    state = begun(motion, 0.0)
    for tick in range(1, 101):
        state = odometry_advanced(state, motion, LEVEL._replace(at=0.01 * tick))
    assert state.since > 1.0 - UNTOLD_AFTER
    grounded = LEVEL._replace(airborne=False)
    state = begun(motion, 0.0)
    for tick in range(1, 101):
        state = odometry_advanced(state, motion, grounded._replace(at=0.01 * tick))
    assert state.since <= 0.01


def test_a_velocity_that_stands_still_to_the_last_bit_is_none() -> None:
    motion = ring()
    state = begun(motion, 0.0)
    for tick in range(1, 101):
        state = odometry_advanced(state, motion, LEVEL._replace(at=0.01 * tick, forward=0.004))
    assert state.since > 1.0 - UNTOLD_AFTER
    for tick in range(101, 201):
        # Flow comes less often than reports.
        report = LEVEL._replace(at=0.01 * tick, forward=0.004 + 1e-4 * (tick // 10))
        state = odometry_advanced(state, motion, report)
    assert state.since <= 1.1


@pytest.mark.parametrize("speed", [0.5, 0.05])
def test_a_drone_that_flies_and_tells_zero_at_once_does_not_tell_its_velocity(speed: float) -> None:
    motion = ring()
    state = begun(motion, 0.0)
    for tick in range(1, 51):
        report = LEVEL._replace(at=0.01 * tick, forward=speed + 1e-5 * tick)
        state = odometry_advanced(state, motion, report)
    for tick in range(51, 54):
        state = odometry_advanced(state, motion, LEVEL._replace(at=0.01 * tick))
        assert (state.since == 0.01 * tick) == (speed > SPEED_LOST)
    state = odometry_advanced(state, motion, LEVEL._replace(at=0.54, left=speed))
    assert state.since <= 0.53


def test_an_old_report_changes_nothing() -> None:
    motion = ring()
    state = begun(motion, 0.0, at=1.0)
    assert odometry_advanced(state, motion, LEVEL._replace(at=1.0, forward=9.0)) == state


def test_the_error_by_the_bias_is_that_of_its_random_process() -> None:
    random, dt = np.random.default_rng(1), 0.05
    keep = np.exp(-dt / 10.0)
    bias = random.normal(0.0, 0.003, 4000)
    way = np.zeros(4000)
    for _ in range(100):
        way += dt * bias
        bias = keep * bias + 0.003 * np.sqrt(1.0 - keep * keep) * random.normal(size=4000)
    assert flow_bias_variance(FLOW, 5.0) == pytest.approx(float(np.var(way)), rel=0.1)
