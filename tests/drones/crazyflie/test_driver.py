"""The driver on a real socket against the simulated drone's own server, in real time."""

from __future__ import annotations

import asyncio
import random
from math import cos, degrees, dist, hypot, pi, sin

import pytest
from crazyflie_room import CrazyflieRoom, crazyflie_room
from driven_room import lossy

from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.crazyflie.driver import Crazyflie
from housefly.drones.crazyflie.reports import BLOCKS, MOTION_BLOCK, OwnState
from housefly.drones.failsafe import HOVER_AFTER, LAND_AFTER
from housefly.errors import LinkError
from housefly.geometry import euler_from_quaternion, wrap_angle
from housefly.messages import (
    Action,
    DroneStatus,
    KnownMotion,
    PositionSetpoint,
    Setpoint,
    VelocitySetpoint,
)
from housefly.messages.steering import flying
from housefly.twin.contracts import FlightState, GroundTruth
from housefly.twin.crazyflie.supervisor import SupervisorState
from housefly.twin.link_filters import Deliver, LinkFilters
from housefly.wires.crazyflie.crtp import Packet, Port, decode_crtp
from housefly.wires.crazyflie.log_blocks import encode_values
from housefly.wires.crazyflie.setpoints import (
    AltHold,
    FullState,
    GenericSetpoint,
    Place,
    decode_setpoint,
    is_notify_stop,
)

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.slow]

FORWARD = flying(Setpoint(theta=0.1))


def lean(truth: GroundTruth) -> float:
    phi, theta, _ = euler_from_quaternion(truth.pose.orientation)
    return hypot(phi, theta)


def fastest_sinking(room: CrazyflieRoom, since: int) -> float:
    return max(-truth.velocity[2] for truth in room.trail[since:])


async def test_connecting_sets_it_to_take_poses_and_reads_its_limits_back(
    room: CrazyflieRoom,
) -> None:
    await room.driver.connect()
    kept = room.server.values
    assert kept["stabilizer.estimator"] == 2.0
    assert kept["posCtlPid.rLimit"] == kept["posCtlPid.pLimit"] == pytest.approx(12.03, abs=0.01)
    assert room.driver.firmware == "2026.08" and room.driver.decks == ()
    await room.until(lambda: room.driver.telemetry_rate_hz > 50, Action.IDLE)
    report = room.driver.telemetry
    assert report is not None and report.configured and report.status is DroneStatus.LANDED
    assert report.battery == 0.9 and report.faults == ()
    assert room.server.malformed == 0


async def test_a_whole_flight_by_lean_by_velocity_and_to_a_place(room: CrazyflieRoom) -> None:
    await room.fly()
    assert room.height == pytest.approx(1.0, abs=0.1)
    yaw = room.world.truth().pose.yaw
    await room.hold(FORWARD, 0.5)
    report = room.driver.telemetry
    assert report is not None and report.theta == pytest.approx(0.1, abs=0.02)
    vx, vy, _ = room.world.truth().velocity
    assert vx * cos(yaw) + vy * sin(yaw) > 0.2
    await room.hold(Action.HOVER, 1.5)
    assert hypot(*room.world.truth().velocity[:2]) < 0.1
    await room.hold(flying(VelocitySetpoint(left=0.3)), 1.4)
    vx, vy, _ = room.world.truth().velocity
    assert vy * cos(yaw) - vx * sin(yaw) == pytest.approx(0.3, abs=0.1)
    x, y, _ = room.world.truth().pose.position
    await room.hold(flying(PositionSetpoint(x + 0.4, y, 1.2)), 3.0)
    assert dist(room.world.truth().pose.position, (x + 0.4, y, 1.2)) < 0.08
    since = len(room.trail)
    await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
    assert room.height < 0.03 and fastest_sinking(room, since) < 1.3
    assert room.world.contact_log == ()
    await room.until(lambda: room.status is DroneStatus.FLYING, Action.TAKE_OFF)
    assert room.height > 0.85, "and once more"


@pytest.mark.parametrize(("steered_by", "given"), [("position", Place), ("trajectory", FullState)])
async def test_a_place_is_told_as_one_or_as_a_full_state_and_nothing_is_where_tracking_is_silent(
    loopback: str, steered_by: str, given: type[GenericSetpoint]
) -> None:
    asked: list[GenericSetpoint] = []

    def tapped(deliver: Deliver) -> Deliver:
        def heard(datagram: bytes) -> None:
            packet = decode_crtp(datagram)
            if packet.port == Port.GENERIC_SETPOINT and packet.channel == 0:
                asked.append(decode_setpoint(packet))
            deliver(datagram)

        return heard

    filters = LinkFilters(uplink=tapped)
    async with crazyflie_room(loopback, filters=filters, steered_by=steered_by) as room:
        await room.fly()
        pose, since = room.world.truth().pose, len(asked)
        x, y, _ = pose.position
        await room.hold(flying(PositionSetpoint(x + 0.3, y, 1.2)), 3.0)
        there = room.world.truth().pose
        assert {type(one) for one in asked[since:]} == {given}
        assert dist(there.position, (x + 0.3, y, 1.2)) < 0.08
        assert abs(wrap_angle(there.yaw - pose.yaw)) < 0.05
        await room.hold(flying(PositionSetpoint(x + 0.3, y, 1.2, yaw_rate=0.4)), 1.0)
        assert wrap_angle(room.world.truth().pose.yaw - there.yaw) > 0.2
        room.tracked = False
        await room.hold(flying(PositionSetpoint(x, y, 1.2)), 0.5)
        assert asked[-1] == AltHold(0.0, 0.0, 0.0, 0.0)


async def test_a_silent_pilot_lets_it_stand_and_sink_and_it_is_down_without_a_crash(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    await room.hold(FORWARD, 0.4)
    velocity = room.world.truth().velocity
    moving = KnownMotion(forward=hypot(*velocity[:2]), left=0.0)
    room.driver.send(FORWARD, moving)
    since = len(room.trail)
    await asyncio.sleep(HOVER_AFTER + 1.2)
    assert hypot(*room.world.truth().velocity[:2]) < 0.2
    async with asyncio.timeout(20.0):
        while room.firmware.supervisor.is_flying:
            await asyncio.sleep(0.05)
    assert LAND_AFTER < 20.0 and fastest_sinking(room, since) < 0.6
    assert room.firmware.supervisor.state is not SupervisorState.LOCKED


async def test_a_dead_driver_is_the_drones_own_affair_level_at_once_and_cut_after_two_seconds(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    await room.hold(FORWARD, 0.4)
    await room.driver.close()
    died, since = room.world.now, len(room.trail)
    async with asyncio.timeout(10.0):
        while room.world.onboard().flight is not FlightState.EMERGENCY:
            await asyncio.sleep(0.02)
    assert room.world.now - died == pytest.approx(2.0, abs=0.3)
    level = next(t.at for t in room.trail[since:] if t.at - died > 0.3 and lean(t) < 0.03)
    assert level - died < 0.9
    await asyncio.sleep(1.0)
    assert room.height < 0.1


async def test_a_driver_that_dies_in_a_climb_leaves_one_that_does_not_climb_on(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    await room.hold(flying(Setpoint(vz=0.5)), 0.6)
    assert room.world.truth().velocity[2] > 0.3
    height, since = room.height, len(room.trail)
    await room.driver.close()
    await asyncio.sleep(1.8)
    highest = max(truth.pose.position[2] for truth in room.trail[since:])
    assert highest < height + 0.4 and room.height > 0.5


async def test_a_new_driver_that_finds_it_in_the_air_flies_nowhere_and_lands_it(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    await room.hold(FORWARD, 0.6)
    x, y, _ = room.world.truth().pose.position
    await room.driver.close()
    room.driver = Crazyflie(room.driver._config, LimitsConfig(), RealClock())
    since = len(room.trail)
    await room.driver.connect()
    await room.until(lambda: room.status is DroneStatus.LANDED, FORWARD)
    way = (hypot(t.pose.position[0] - x, t.pose.position[1] - y) for t in room.trail[since:])
    assert max(way) < 0.8 and room.height < 0.03
    assert room.firmware.supervisor.state is not SupervisorState.LOCKED


async def test_a_driver_that_dies_in_a_landing_leaves_one_that_ends_softly(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    await room.hold(Action.LAND, 0.5)
    since = len(room.trail)
    await room.driver.close()
    async with asyncio.timeout(10.0):
        while room.world.onboard().flight is not FlightState.LANDED:
            await asyncio.sleep(0.02)
    assert fastest_sinking(room, since) < 1.3 and room.height < 0.03
    assert room.firmware.supervisor.state is not SupervisorState.LOCKED


async def test_told_to_land_without_tracking_it_sinks_level_and_its_motors_stop(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    room.tracked = False
    await room.hold(flying(Setpoint()), 0.5)
    since = len(room.trail)
    await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
    assert fastest_sinking(room, since) < 0.6 and room.height < 0.03
    assert max(map(lean, room.trail[since:])) < 0.06


async def test_a_pilot_that_lets_it_sink_without_tracking_need_not_know_when_it_is_down(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    room.tracked = False
    since, began = len(room.trail), room.world.now
    sinking = flying(Setpoint(vz=-0.3))
    await room.until(lambda: room.status is DroneStatus.LANDED, sinking)
    assert room.world.now - began < 8.0
    assert fastest_sinking(room, since) < 0.6 and room.height < 0.03


async def test_it_does_not_take_off_while_it_believes_to_be_elsewhere(
    room: CrazyflieRoom,
) -> None:
    room.tracked = False
    await room.driver.connect()
    await room.hold(Action.TAKE_OFF, 1.0)
    assert room.status is DroneStatus.LANDED
    room.tracked = True
    room.server.values["stabilizer.estimator"] = 1.0
    await room.until(lambda: "believes to be" in room.driver.problem, Action.IDLE)
    await room.hold(Action.TAKE_OFF, 1.0)
    assert room.status is DroneStatus.LANDED and room.height < 0.03


async def test_cutting_the_motors_locks_it_and_it_says_what_to_do(room: CrazyflieRoom) -> None:
    await room.fly()
    await room.until(lambda: room.status is DroneStatus.EMERGENCY, Action.CUT)
    await room.until(lambda: room.height < 0.05, Action.CUT)
    assert "switch it off and on" in room.driver.problem
    await room.hold(Action.RESET, 0.5)
    assert room.status is DroneStatus.EMERGENCY
    room.world.toggle_emergency()
    await room.until(lambda: room.status is DroneStatus.LANDED, Action.IDLE)


async def test_a_drone_that_was_restarted_is_set_and_read_again(room: CrazyflieRoom) -> None:
    await room.driver.connect()
    await room.until(lambda: room.driver.connected, Action.IDLE)
    await room.server.stop()
    await asyncio.sleep(0.7)
    assert not room.driver.connected
    server = type(room.server)(room.world, room.driver._config.address)
    room.server = server
    await server.start()
    await room.until(lambda: room.driver.connected and not room.driver.problem, Action.IDLE)
    assert server.values["stabilizer.estimator"] == 2.0


async def test_a_brushless_one_is_armed_when_it_is_to_take_off_and_disarms_by_itself(
    loopback: str,
) -> None:
    async with crazyflie_room(loopback, "crazyflie_brushless") as room:
        await room.driver.connect()
        await room.until(lambda: room.driver.connected and not room.driver.problem, Action.IDLE)
        await room.hold(Action.IDLE, 0.5)
        assert not room.firmware.supervisor.is_armed
        await room.until(lambda: room.status is DroneStatus.FLYING, Action.TAKE_OFF)
        assert room.firmware.supervisor.is_armed
        await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
        await room.until(lambda: not room.firmware.supervisor.is_armed, Action.IDLE)


async def test_over_a_link_that_loses_a_fifth_it_is_set_flies_and_lands(loopback: str) -> None:
    filters = lossy(random.Random(5), 0.2, twice=0.1)
    async with crazyflie_room(loopback, filters=filters) as room:
        await room.fly()
        assert room.server.values["stabilizer.estimator"] == 2.0
        x, y, _ = room.world.truth().pose.position
        await room.hold(flying(PositionSetpoint(x, y, 1.2)), 2.0)
        assert dist(room.world.truth().pose.position, (x, y, 1.2)) < 0.1
        since = len(room.trail)
        await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
        assert room.height < 0.03 and fastest_sinking(room, since) < 1.3
        assert room.firmware.supervisor.state is not SupervisorState.LOCKED


async def test_a_landing_goes_on_where_only_the_end_of_setpoints_is_lost(loopback: str) -> None:
    lost = 0

    def deaf(deliver: Deliver) -> Deliver:
        def heard(datagram: bytes) -> None:
            nonlocal lost
            packet = decode_crtp(datagram)
            if lost < 3 and packet.port == Port.GENERIC_SETPOINT and is_notify_stop(packet):
                lost += 1
            else:
                deliver(datagram)

        return heard

    async with crazyflie_room(loopback, filters=LinkFilters(uplink=deaf)) as room:
        await room.fly()
        since = len(room.trail)
        await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
        assert lost == 3 and room.height < 0.03 and fastest_sinking(room, since) < 1.3
        assert room.firmware.supervisor.state is not SupervisorState.LOCKED


async def test_a_setpoint_that_comes_late_into_a_landing_is_answered_by_another_order_to_land(
    room: CrazyflieRoom,
) -> None:
    await room.fly()
    await room.hold(Action.LAND, 0.6)
    room.firmware.give(AltHold(0.0, 0.0, 0.0, 0.0))
    since = len(room.trail)
    await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
    assert room.height < 0.03 and fastest_sinking(room, since) < 1.3
    assert room.firmware.supervisor.state is not SupervisorState.LOCKED


async def test_nobody_there_is_said_in_words(loopback: str) -> None:
    config = DroneConfig(kind="crazyflie", address=loopback)
    driver = Crazyflie(config, LimitsConfig(), RealClock())
    with pytest.raises(LinkError, match="nobody answers at"):
        await driver.connect()
    await driver.close()


def motion(yaw: float, milliseconds: int) -> Packet:
    kinds = BLOCKS[MOTION_BLOCK][1].values()
    values = zip(kinds, (0.0, 0.0, degrees(yaw), 0.0, 0.0), strict=True)
    return encode_values(MOTION_BLOCK, milliseconds, list(values))


def test_a_heading_that_it_takes_over_from_poses_is_no_turn_of_its_own() -> None:
    state = OwnState().taken_in(motion(0.3, 1000), 1.0)
    for step in range(1, 51):
        state = state.taken_in(motion(0.3 + 0.01 * step, 1000 + 10 * step), 1.0 + 0.01 * step)
    assert state.turned == pytest.approx(0.5, abs=1e-3)
    state = state.taken_in(motion(3.1, 1510), 1.51).taken_in(motion(-3.12, 1520), 1.52)
    assert state.turned == pytest.approx(0.5 + (2 * pi - 6.22), abs=1e-3)
    report = state.report(DroneStatus.LANDED, configured=True, notes=())
    assert report.psi == state.turned and state.yaw == pytest.approx(-3.12, abs=1e-3)


def test_a_state_that_was_never_told_is_neither_flying_nor_configured() -> None:
    report = OwnState().report(DroneStatus.LANDED, configured=True, notes=())
    assert not report.configured and not OwnState().is_flying
