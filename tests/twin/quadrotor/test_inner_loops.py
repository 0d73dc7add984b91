"""How the simulated drone answers its sticks: the identified responses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import exp

import pytest

from housefly.config.airframe import airframe_named
from housefly.config.twin import INNER_LOOP_DELAY
from housefly.geometry import Vec2, distance, euler_from_quaternion, rotate
from housefly.messages.stick import Stick
from housefly.room.model import Room
from housefly.twin.contracts import FlightState, OnboardLimits, TwinWorld
from housefly.twin.quadrotor.motors import motor_duties
from housefly.twin.simulated_body import CONTROL_PERIOD, Wrench
from housefly.twin.world import SimulatedWorld

MakeWorld = Callable[..., SimulatedWorld]

COMMAND_DELAY = airframe_named("ardrone").response.command_delay
TILT = OnboardLimits().tilt
_HAND_STEP = 0.01
"""How often the hand lets the angle be looked at [s]."""


def tilt_of(world: TwinWorld) -> Vec2:
    phi, theta, _ = euler_from_quaternion(world.truth().pose.orientation)
    return phi, theta


def body_speed(world: TwinWorld) -> tuple[float, float, float]:
    w, x, y, z = world.truth().pose.orientation
    return rotate((w, -x, -y, -z), world.truth().velocity)


@pytest.mark.parametrize(
    ("stick", "axis", "sign"),
    [("forward", 1, 1), ("forward", 1, -1), ("left", 0, 1), ("left", 0, -1)],
)
def test_attitude_follows_the_stick_like_a_first_order_lag(
    make_world: MakeWorld, hand: type, stick: str, axis: int, sign: int
) -> None:
    world = make_world(twin__command_delay=0.1)
    hand(world).hover(1.5)
    start, began = tilt_of(world)[axis], world.now + 0.1
    wanted = sign * TILT if stick == "forward" else -sign * TILT
    errors = []

    def compare() -> None:
        expected = wanted + (start - wanted) * exp(-7.0 * max(0.0, world.now - began))
        errors.append(abs(tilt_of(world)[axis] - expected))

    world.set_stick(Stick(hover=False, **{stick: float(sign)}))
    hand(world).wait(0.8, compare)
    assert max(errors) < 0.03 * TILT
    assert abs(body_speed(world)[1 - axis]) > 0.3


@pytest.mark.parametrize("gain", [0.7, 1.2])
def test_the_achieved_angle_is_the_configured_share_of_the_commanded(
    make_world: MakeWorld, hand: type, gain: float
) -> None:
    world = make_world(drone__attitude_gain=gain)
    hand(world).hover(1.5)
    hand(world).fly(forward=0.5, seconds=1.0)
    assert tilt_of(world)[1] == pytest.approx(0.5 * TILT * gain, abs=0.004)


def test_full_stick_ends_at_the_speed_where_drag_balances_tilt(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world()
    hand(world).hover(2.0)
    hand(world).fly(forward=1.0, seconds=9.0)
    assert body_speed(world)[0] == pytest.approx(3.6, abs=0.15)
    assert world.truth().pose.position[2] == pytest.approx(2.0, abs=0.3)


def test_the_same_stick_sinks_twice_as_fast_as_it_climbs_but_no_faster_than_allowed(
    make_world: MakeWorld, make_room: Callable[..., Room], hand: type
) -> None:
    world = make_world(replace(make_room(), height=8.0))
    world.set_limits(OnboardLimits(altitude=6.0))
    hand(world).hover(1.2)
    hand(world).fly(up=0.3, seconds=5.0)
    climb = world.truth().velocity[2]
    hand(world).fly(up=1.0, seconds=3.0)
    full_climb = world.truth().velocity[2]
    hand(world).fly(up=-0.3, seconds=3.0)
    sink = world.truth().velocity[2]
    hand(world).fly(up=-1.0, seconds=1.5)
    assert climb == pytest.approx(0.3 * 0.7, abs=0.03)
    assert sink == pytest.approx(-2 * climb, abs=0.05)
    assert full_climb == pytest.approx(0.7, abs=0.05)
    assert world.truth().velocity[2] > -0.75


def test_the_altitude_limit_holds(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    world.set_limits(OnboardLimits(altitude=1.6))
    hand(world).hover(1.0)
    hand(world).fly(up=1.0, seconds=8.0)
    assert world.truth().pose.position[2] < 1.75


def test_yaw_rate_follows_within_tenths_of_a_second_and_only_yaw_changes(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world()
    hand(world).hover()
    before = world.truth().pose
    hand(world).fly(turn=0.5, seconds=0.26)
    rate = world.onboard().angular_rate[2]
    hand(world).fly(turn=0.5, seconds=0.74)
    assert rate == pytest.approx(0.5 * 1.7453, rel=0.05)
    assert world.truth().pose.yaw - before.yaw == pytest.approx(
        0.5 * 1.7453 * (1.0 - 0.06 - 0.04), rel=0.05
    )
    assert distance(world.truth().pose.position, before.position) < 0.1


def test_hovering_wanders_by_centimetres_to_decimetres(make_world: MakeWorld, hand: type) -> None:
    wandered = []
    for seed in range(4):
        world = make_world(twin__seed=seed, twin__mocap_rate_hz=1.0)
        hand(world).hover()
        start = world.truth().pose.position
        hand(world).wait(60.0)
        wandered.append(distance(world.truth().pose.position[:2], start[:2]))
        assert abs(world.truth().pose.position[2] - start[2]) < 0.1
    assert 0.01 < max(wandered) < 0.6


def test_level_flight_drifts_and_hover_stops_it(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    hand(world).hover()
    hand(world).fly(forward=0.5, seconds=2.0)
    hand(world).fly(seconds=0.5)
    assert body_speed(world)[0] > 0.8
    world.set_stick(Stick(hover=True))
    hand(world).wait(2.0)
    assert abs(body_speed(world)[0]) < 0.1


def test_nothing_happens_before_the_command_delay(make_world: MakeWorld) -> None:
    world = make_world(twin__command_delay=0.2)
    world.request_take_off()
    world.advance(0.195)
    assert world.onboard().flight is FlightState.LANDED
    world.advance(0.02)
    assert world.onboard().flight is FlightState.TAKING_OFF


def test_motors_of_the_lower_side_turn_faster(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    hand(world).hover()
    hover = world.onboard().motors
    assert all(0.55 < motor < 0.8 for motor in hover)
    front_left, front_right, rear_right, rear_left = motor_duties(Wrench(4.0, 0.0, 0.05, 0.0))
    assert rear_left > front_left
    assert rear_right > front_right


@pytest.mark.parametrize("lag", [5.0, 10.0])
def test_the_inner_loops_add_their_declared_delay_to_the_first_order_lag(
    make_world: MakeWorld, hand: type, lag: float
) -> None:
    world = make_world(drone__attitude_lag=lag)
    hand(world).hover(1.5)
    world.set_stick(Stick(hover=False))
    hand(world).wait(1.0)
    angles = [tilt_of(world)[1]]
    world.set_stick(Stick(forward=0.4, hover=False))
    hand(world).wait(2.5, lambda: angles.append(tilt_of(world)[1]))
    steady = sum(angles[-100:]) / 100
    # The area above a step response is the sum of its delays and lags.
    missing = [1.0 - (angle - angles[0]) / (steady - angles[0]) for angle in angles]
    area = _HAND_STEP * (sum(missing) - 0.5 * missing[0])
    waited = 0.5 * CONTROL_PERIOD  # of a datagram on average; this stick comes in time
    added = area - COMMAND_DELAY - 1.0 / lag
    assert added == pytest.approx(INNER_LOOP_DELAY - waited, abs=0.002)
