"""The driver on a real socket against the simulated controller's own server, in real time."""

from __future__ import annotations

import asyncio
import random
from dataclasses import replace
from math import cos, hypot, sin

import pytest
from betaflight_room import BetaflightRoom, betaflight_room
from driven_room import lossy
from serial_bridge import serial_bridge, udp_bridge

from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.betaflight.driver import Betaflight
from housefly.drones.betaflight.manoeuvres import Doing
from housefly.errors import ConfigError, LinkError
from housefly.messages import Action, DroneStatus, KnownMotion, Setpoint
from housefly.messages.steering import flying
from housefly.twin.betaflight.failsafe import Phase
from housefly.wires.betaflight.endpoint import TCP_PORT
from housefly.wires.betaflight.settings import (
    FailsafeProcedure,
    FailsafeSettings,
    FcSettings,
    SilentChannel,
)

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.slow]

UDP_PORT = 5762
FORWARD = flying(Setpoint(theta=0.1))


def fastest_sinking(room: BetaflightRoom, since: int) -> float:
    return max(-truth.velocity[2] for truth in room.trail[since:])


async def test_connecting_reads_everything_and_finds_its_channels_to_be_ours(
    room: BetaflightRoom,
) -> None:
    await room.driver.connect()
    assert room.driver.firmware == "Betaflight 25.12.0"
    await room.until(lambda: room.driver.telemetry_rate_hz > 10, Action.IDLE)
    await room.until(lambda: room.is_ready, Action.IDLE)
    report = room.driver.telemetry
    assert report is not None and report.status is DroneStatus.LANDED and report.battery > 0.85
    counters = room.driver.counters
    assert counters.connects == 1 and counters.refused == counters.broken == 0
    assert counters.answered > 0.9 * counters.sent and room.server.malformed == 0


async def test_a_whole_flight_by_lean_and_once_more(room: BetaflightRoom) -> None:
    await room.fly()
    await room.hold(Action.HOVER, 1.0)
    assert room.height == pytest.approx(1.05, abs=0.12)
    yaw = room.world.truth().pose.yaw
    await room.hold(FORWARD, 0.5)
    report = room.driver.telemetry
    assert report is not None and report.theta == pytest.approx(0.1, abs=0.03)
    vx, vy, _ = room.world.truth().velocity
    assert vx * cos(yaw) + vy * sin(yaw) > 0.2
    await room.hold(Action.HOVER, 2.5)
    assert hypot(*room.world.truth().velocity[:2]) < 0.1
    since = len(room.trail)
    await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
    assert room.height < 0.06 and fastest_sinking(room, since) < 0.7
    assert room.world.contact_log == ()
    await room.until(lambda: room.status is DroneStatus.FLYING, Action.TAKE_OFF)
    assert room.height > 0.85, "and once more"


async def test_a_silent_pilot_lets_it_stand_and_sink_and_it_is_down_without_a_crash(
    room: BetaflightRoom,
) -> None:
    await room.fly()
    await room.hold(FORWARD, 0.4)
    speed = hypot(*room.world.truth().velocity[:2])
    room.driver.send(FORWARD, KnownMotion(forward=speed, left=0.0))
    since = len(room.trail)
    async with asyncio.timeout(20.0):
        while room.firmware.is_armed:
            await asyncio.sleep(0.05)
    assert fastest_sinking(room, since) < 0.8 and room.height < 0.06
    assert room.world.contact_log == () and room.firmware.failsafe.phase is Phase.IDLE


async def test_a_dead_driver_is_the_controllers_own_affair_it_lands_by_its_failsafe(
    room: BetaflightRoom,
) -> None:
    await room.fly()
    await room.hold(Action.HOVER, 0.5)
    await room.driver.close()
    died = room.world.now
    async with asyncio.timeout(15.0):
        while room.firmware.failsafe.phase is not Phase.LANDING:
            await asyncio.sleep(0.01)
        assert room.world.now - died == pytest.approx(1.5, abs=0.3)
        since = len(room.trail)
        while room.firmware.is_armed:
            await asyncio.sleep(0.05)
    assert room.height < 0.06 and fastest_sinking(room, since) < 1.5


async def test_a_new_driver_that_finds_it_in_the_air_flies_nowhere_and_lands_it(
    room: BetaflightRoom,
) -> None:
    await room.fly()
    await room.hold(FORWARD, 0.5)
    x, y, _ = room.world.truth().pose.position
    await room.driver.close()
    await asyncio.sleep(0.6)
    room.driver = Betaflight(room.driver._config, LimitsConfig(), RealClock())
    since = len(room.trail)
    await room.driver.connect()
    await room.until(lambda: room.status is DroneStatus.LANDED, FORWARD)
    way = (hypot(t.pose.position[0] - x, t.pose.position[1] - y) for t in room.trail[since:])
    assert max(way) < 1.2 and room.height < 0.06
    assert fastest_sinking(room, since) < 1.0


async def test_told_to_land_without_tracking_it_sinks_level_and_its_motors_stop(
    room: BetaflightRoom,
) -> None:
    await room.fly()
    await room.hold(Action.HOVER, 1.0)
    room.tracked = False
    await room.hold(flying(Setpoint()), 0.5)
    since = len(room.trail)
    await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
    assert fastest_sinking(room, since) < 1.2 and room.height < 0.06


async def test_cut_motors_are_cut_until_a_reset(room: BetaflightRoom) -> None:
    await room.fly()
    await room.until(lambda: not room.firmware.is_armed, Action.CUT, 1.0)
    await room.until(lambda: room.status is DroneStatus.EMERGENCY, Action.CUT)
    await room.hold(Action.TAKE_OFF, 0.6)
    assert room.status is DroneStatus.EMERGENCY and not room.firmware.is_armed
    await room.until(lambda: room.status is DroneStatus.LANDED, Action.RESET)


async def test_it_never_takes_off_untracked(room: BetaflightRoom) -> None:
    room.tracked = False
    await room.driver.connect()
    await room.hold(Action.IDLE, 2.5)
    await room.hold(Action.TAKE_OFF, 1.5)
    assert room.driver._manoeuvres.doing is Doing.NOTHING and not room.firmware.is_armed


DEFAULTS = FcSettings()


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"ranges": ()}, "set aux ARM to a switch"),
        ({"silent": DEFAULTS.silent}, "set rxfail 3 to h on the drone (it is auto)"),
        (
            {"failsafe": FailsafeSettings(procedure=FailsafeProcedure.DROP)},
            "set failsafe_procedure to AUTO-LAND on the drone (it is DROP)",
        ),
        ({"angle_limit": 10}, "set angle_limit to 13 to 80 on the drone (it is 10)"),
        ({"features": 0}, "set msp_override_channels_mask"),
    ],
)
async def test_what_is_set_otherwise_is_named_and_keeps_it_on_the_floor(
    room: BetaflightRoom, changes: dict[str, object], words: str
) -> None:
    room.firmware.settings = replace(room.firmware.settings, **changes)  # type: ignore[arg-type]
    await room.driver.connect()
    await room.until(lambda: words in room.driver.problem, Action.IDLE, 4.0)
    await room.hold(Action.TAKE_OFF, 1.5)
    report = room.driver.telemetry
    assert report is not None and not report.configured and not room.firmware.is_armed


RADIO = (1500, 1500, 1000, 1500, 1000, 1000, 2000, 1000)


@pytest.mark.parametrize(("mask", "lacking"), [(0b111111, ""), (0b111011, "throttle")])
async def test_with_a_radio_the_mask_is_checked_by_what_it_flies_by(
    room: BetaflightRoom, mask: int, lacking: str
) -> None:
    firmware = room.firmware
    firmware.settings = replace(firmware.settings, features=0)
    firmware.receiver.radio, firmware.receiver.override_mask = RADIO, mask
    await room.driver.connect()
    driver = room.driver
    if lacking:
        await room.until(lambda: f"these are not ours: {lacking}" in driver.problem, Action.IDLE)
        await room.hold(Action.TAKE_OFF, 1.0)
        assert not firmware.is_armed
        return
    await room.until(lambda: room.is_ready, Action.IDLE)
    await room.until(lambda: room.status is DroneStatus.FLYING, Action.TAKE_OFF)
    firmware.receiver.radio = (*RADIO[:6], 1000, 1000)
    await room.until(lambda: not firmware.is_armed, Action.HOVER, 2.0)
    # a person at the radio has taken it, and their arm switch is off
    assert room.status in (DroneStatus.FLYING, DroneStatus.LANDED)


async def test_over_udp_it_flies_by_a_bridge_to_its_serial_port(
    room: BetaflightRoom, loopback: str
) -> None:
    config = DroneConfig(kind="betaflight", address=f"udp:{loopback}:{UDP_PORT}")
    with udp_bridge(loopback, TCP_PORT, UDP_PORT):
        room.driver = Betaflight(config, LimitsConfig(), RealClock())
        await room.fly()
        await room.hold(Action.HOVER, 1.0)
        assert room.height == pytest.approx(1.05, abs=0.15)
        await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
        assert room.height < 0.06 and room.world.contact_log == ()


async def test_a_fifth_of_all_commands_and_answers_may_be_lost(loopback: str) -> None:
    async with betaflight_room(loopback, lossy(random.Random(3), 0.2)) as room:
        await room.fly()
        await room.hold(Action.HOVER, 1.0)
        assert room.height == pytest.approx(1.05, abs=0.15)
        await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
        assert room.height < 0.06


async def test_nobody_and_a_stranger_are_told_apart(loopback: str) -> None:
    config = DroneConfig(kind="betaflight", address=loopback)
    driver = Betaflight(config, LimitsConfig(), RealClock())
    with pytest.raises(LinkError, match=f"cannot open tcp:{loopback}:{TCP_PORT}"):
        await driver.connect()
    await driver.close()

    async def answer(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        while await reader.read(100):
            writer.write(b"$M>\x04\x02INAV\x16" + b"$M!\x00\x01\x01")

    server = await asyncio.start_server(answer, loopback, TCP_PORT)
    driver = Betaflight(config, LimitsConfig(), RealClock())
    with pytest.raises(LinkError, match=r"does not speak Betaflight \(INAV"):
        await driver.connect()
    await driver.close()
    server.close()


async def test_an_address_that_is_none_is_refused_before_anything_is_sent() -> None:
    config = DroneConfig(kind="betaflight", address="serial:ttyACM0")
    driver = Betaflight(config, LimitsConfig(), RealClock())
    with pytest.raises(ConfigError, match="serial:/dev/ttyACM0:BAUD"):
        await driver.connect()


async def test_over_a_serial_port_it_flies_the_same(room: BetaflightRoom) -> None:
    address = room.driver._config.address
    with serial_bridge(address, TCP_PORT) as device:
        config = room.driver._config.model_copy(update={"address": f"serial:{device}"})
        room.driver = Betaflight(config, LimitsConfig(), RealClock())
        await room.fly()
        assert room.height > 0.85
        await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
        await room.driver.close()


def test_silence_of_a_channel_is_what_the_room_flies_with() -> None:
    assert DEFAULTS.silent[3][0] is SilentChannel.AUTO, "the firmware's own default lets it fall"
