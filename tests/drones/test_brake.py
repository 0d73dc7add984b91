"""The brake, against a drone of first principles: lag, delay and drag."""

from __future__ import annotations

from collections import deque
from math import hypot, inf, isfinite, nan, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.drones.brake import (
    KNOWN_FOR,
    SINK_RATE,
    AttitudeSpeed,
    braking_setpoint,
    sinking_setpoint,
)
from housefly.geometry import GRAVITY
from housefly.messages import LEVEL, DroneStatus, KnownMotion, Telemetry

ARDRONE = airframe_named("ardrone")
TILT_MAX = 0.21
STEP = 0.01
speeds = st.floats(-1.5, 1.5)
tilts = st.floats(-TILT_MAX, TILT_MAX)


def report(
    at: float = 0.0,
    theta: float = 0.0,
    phi: float = 0.0,
    velocity: tuple[float, float] = (0.0, 0.0),
    psi: float = 0.0,
    status: DroneStatus = DroneStatus.FLYING,
) -> Telemetry:
    return Telemetry(at, status, 1.0, phi, theta, psi, 1.0, (*velocity, 0.0))


def by_attitude(forward: float = 0.0, left: float = 0.0) -> AttitudeSpeed:
    speed = AttitudeSpeed(ARDRONE)
    speed.velocity = (forward, left)
    return speed


def by_tracking(forward: float, left: float = 0.0, *, hovers: bool = True) -> AttitudeSpeed:
    speed = AttitudeSpeed(ARDRONE)
    speed.know(KnownMotion(forward, left, hovers=hovers), 0.0)
    return speed


@given(speeds, speeds, tilts, tilts, speeds, speeds)
def test_the_brake_never_leans_further_than_it_may_and_never_moves_in_height_or_heading(
    forward: float, left: float, theta: float, phi: float, by_forward: float, by_left: float
) -> None:
    newest = report(theta=theta, phi=phi, velocity=(forward, left))
    known = by_tracking(by_forward, by_left)
    sinking = sinking_setpoint(0.1, newest, known, TILT_MAX)
    assert max(abs(sinking.theta), abs(sinking.phi)) <= TILT_MAX and sinking.vz == -SINK_RATE
    leaning = braking_setpoint(0.1, newest, by_attitude(by_forward, by_left), TILT_MAX)
    if leaning is not None:
        assert abs(leaning.theta) <= TILT_MAX and abs(leaning.phi) <= TILT_MAX
        assert isfinite(leaning.theta) and isfinite(leaning.phi)
        assert leaning.vz == leaning.yaw_rate == 0.0


@given(st.floats(0.2, 2.0))
def test_it_leans_against_the_speed(speed: float) -> None:
    for velocity, leans in (
        ((speed, 0.0), lambda s: s.theta < 0),
        ((-speed, 0.0), lambda s: s.theta > 0),
        ((0.0, speed), lambda s: s.phi > 0),
        ((0.0, -speed), lambda s: s.phi < 0),
    ):
        assert leans(braking_setpoint(0.0, report(velocity=velocity), by_attitude(), TILT_MAX))
        assert leans(braking_setpoint(0.0, report(), by_tracking(*velocity), TILT_MAX))


@pytest.mark.parametrize("frozen", [0.5, -0.6])
def test_the_brake_takes_the_speed_that_tracking_gave_and_not_the_flow_that_lies(
    frozen: float,
) -> None:
    speed = by_tracking(0.4)
    leaning = braking_setpoint(0.0, report(velocity=(frozen, 0.0)), speed, TILT_MAX)
    assert leaning is not None and leaning.theta < 0
    for step in range(1, 300):
        speed.update(report(step * STEP))
    later = 3.0
    assert 0.0 < speed.velocity[0] < 0.1, "drag has stopped it"
    assert braking_setpoint(later, report(later, velocity=(frozen, 0.0)), speed, TILT_MAX) is None
    wrong = report(KNOWN_FOR, velocity=(frozen, 0.0))
    assert braking_setpoint(KNOWN_FOR, wrong, speed, TILT_MAX) is not None, "too long ago"


def test_against_a_steady_push_it_leans_as_the_pilot_did() -> None:
    speed = AttitudeSpeed(ARDRONE)
    speed.know(KnownMotion(0.0, 0.0, theta=0.05, phi=-0.02, hovers=False), 0.0)
    for step in range(200):
        speed.update(report(step * STEP, theta=0.05, phi=-0.02, psi=1e-9 * step))
    assert hypot(*speed.velocity) < 1e-9, "so it stands still"
    sinking = sinking_setpoint(2.0, report(2.0, 0.05, -0.02), speed, TILT_MAX)
    assert (sinking.theta, sinking.phi) == (0.05, -0.02)


@pytest.mark.parametrize("lean", [-0.15, 0.0, 0.1])
@pytest.mark.parametrize("speed", [-0.5, 0.5])
def test_a_drone_whose_reports_stand_still_is_braked_by_what_it_was_asked_for(
    lean: float, speed: float
) -> None:
    brake, velocity, theta = AttitudeSpeed(ARDRONE), speed, 0.0
    asked: deque[float] = deque([0.0] * 6)
    fastest_back = 0.0
    for step in range(-20, 0):
        brake.update(report(step * STEP, theta=lean, velocity=(0.4, 0.0)))
    brake.know(KnownMotion(speed, 0.0, hovers=False), 0.0)
    for step in range(400):
        now = step * STEP
        newest = report(now, theta=lean, velocity=(0.4, 0.0))
        brake.update(newest)
        setpoint = sinking_setpoint(now, newest, brake, TILT_MAX)
        brake.ask(setpoint)
        asked.append(setpoint.theta)
        theta += STEP * 7.0 * (asked.popleft() - theta)
        velocity += STEP * (GRAVITY * tan(theta) - 0.58 * velocity)
        fastest_back = max(fastest_back, -velocity if speed > 0.0 else velocity)
    assert abs(velocity) < ARDRONE.brake.rest_speed and fastest_back < 0.25


def test_at_rest_or_without_a_fresh_report_it_leaves_the_drone_to_its_own_hover() -> None:
    slow = report(velocity=(0.5 * ARDRONE.brake.rest_speed, 0.0))
    assert braking_setpoint(0.0, slow, by_attitude(1.0, 1.0), TILT_MAX) is None
    assert braking_setpoint(0.5, report(velocity=(0.5, 0.0)), by_attitude(), TILT_MAX) is None


@pytest.mark.parametrize("odd", [nan, inf, -inf, 1e308])
def test_numbers_that_are_none_leave_it_to_the_drone_and_are_forgotten(odd: float) -> None:
    for newest in (report(velocity=(odd, 1.0)), report(theta=odd), report(phi=odd)):
        leaning = braking_setpoint(0.0, newest, by_attitude(), TILT_MAX)
        assert leaning is None or abs(odd) == 1e308, "full tilt on a number that is none"
    speed = AttitudeSpeed(ARDRONE)
    for step, theta in enumerate((0.03, odd, 0.03, 0.03)):
        speed.update(report(step * STEP, theta=theta))
    assert all(map(isfinite, speed.velocity))


@pytest.mark.parametrize("flow_sees", [True, False])
@given(speed=st.floats(0.2, 1.0))
def test_with_and_without_its_flow_camera_a_drone_comes_nearly_to_rest_in_time(
    flow_sees: bool, speed: float
) -> None:
    theta = tan(0.58 * speed / GRAVITY)
    velocity, way, cruise = speed, 0.0, AttitudeSpeed(ARDRONE)
    for step in range(1000):
        cruise.update(report(step * STEP, theta=theta))
    assert cruise.velocity[0] == pytest.approx(speed, rel=0.05)
    asked: deque[float] = deque([theta] * 6)
    now = 10.0
    for step in range(round((ARDRONE.brake.time_max + 0.3) / STEP)):
        now = 10.0 + step * STEP
        newest = report(now, theta, velocity=(velocity if flow_sees else 0.0, 0.0))
        cruise.update(newest)
        setpoint = braking_setpoint(now, newest, cruise, TILT_MAX)
        if setpoint is None or now > 10.0 + ARDRONE.brake.time_max:
            setpoint = LEVEL
        asked.append(setpoint.theta)
        theta += STEP * 7.0 * (asked.popleft() - theta)
        velocity += STEP * (GRAVITY * tan(theta) - 0.58 * velocity)
        way += velocity * STEP
    assert abs(velocity) < 2 * ARDRONE.brake.rest_speed
    assert way < 0.6 * speed + 0.5 * speed**2


def test_the_speed_from_attitude_turns_with_the_drone_and_starts_anew_on_the_ground() -> None:
    speed = AttitudeSpeed(ARDRONE)
    for step in range(300):
        speed.update(report(step * STEP, theta=0.03))
    forward = speed.velocity[0]
    speed.update(report(3.0, psi=1.5708))
    assert hypot(*speed.velocity) == pytest.approx(forward, rel=0.02)
    assert speed.velocity[1] == pytest.approx(-forward, rel=0.02)
    speed.update(report(3.01, status=DroneStatus.LANDED))
    assert speed.velocity == (0.0, 0.0)
    speed.update(report(3.02, theta=0.2))
    speed.update(report(9.0, theta=0.2))
    assert speed.velocity == (0.0, 0.0)
