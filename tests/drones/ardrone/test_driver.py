"""The driver on real sockets against the simulated drone's own server, through a radio link that
can be bad.
"""

from __future__ import annotations

import asyncio
import contextlib
import io
import socket
from pathlib import Path

import pytest
from full_disk import full_output
from virtual_time import loop_time

from housefly.clock import RealClock
from housefly.config.airframe import airframe_named
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.ardrone import driver as driver_module
from housefly.drones.ardrone import limits_keeper
from housefly.drones.ardrone.driver import ArDrone
from housefly.drones.ardrone.video import VideoLink
from housefly.drones.failsafe import HOVER_AFTER, LAND_AFTER
from housefly.errors import LinkError
from housefly.messages import Action, Command, DroneStatus, Setpoint, VideoFrame
from housefly.twin import contracts as twin
from housefly.wires.ardrone import at, navdata_options, pave
from housefly.wires.ardrone.config import VideoChannel
from housefly.wires.ardrone.navdata import NAVDATA_PORT, encode_navdata
from housefly.wires.ardrone.pave import (
    VIDEO_PORT,
    PaveHeader,
    VideoReassembler,
    encode_frame,
)

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.usefixtures("fresh_log")]

ARDRONE = airframe_named("ardrone")
FORWARD = Setpoint(theta=0.1)


def status(flight) -> DroneStatus:
    return flight.drone.telemetry.status


async def flying(flight) -> None:
    await flight.drone.connect()
    await flight.until(lambda: status(flight) is DroneStatus.FLYING, Action.TAKE_OFF)


async def test_connecting_sets_limits_and_reads_them_back(flight) -> None:
    await flight.drone.connect()
    assert flight.drone.connected
    assert flight.drone.notes == ()
    assert flight.drone.configuration["control:euler_angle_max"] == "2.1000000e-01"
    assert flight.drone.configuration["video:max_bitrate"] == "4000"
    assert flight.world.limits.tilt == pytest.approx(0.21)
    assert flight.world.limits.climb == pytest.approx(1.0)
    assert flight.server.counters.refused_settings == 0
    assert status(flight) is DroneStatus.LANDED


async def test_a_whole_flight(flight) -> None:
    await flying(flight)
    assert flight.world.trims >= 1
    await flight.hold(Action.FLY, FORWARD, seconds=0.5)
    assert flight.world.asked.forward == pytest.approx(0.1 / 0.21, rel=1e-3)
    assert flight.drone.telemetry.theta == pytest.approx(0.1, abs=0.01)
    assert flight.drone.telemetry.velocity[0] > 0.1
    await flight.hold(Action.FLY, Setpoint(phi=0.1, vz=0.5, yaw_rate=1.75), seconds=0.3)
    asked = flight.world.asked
    assert (asked.left, asked.up, asked.turn) == pytest.approx((-0.1 / 0.21, 0.5, 1.0), rel=1e-3)
    await flight.hold(Action.HOVER, seconds=0.2)
    assert flight.world.asked.hover
    await flight.until(lambda: status(flight) is DroneStatus.LANDED, Action.LAND)
    assert flight.drone.telemetry_rate_hz > 50


async def test_a_change_of_action_leaves_in_the_same_call_and_setpoints_keep_the_cadence(
    flight,
) -> None:
    await flying(flight)
    await flight.hold(Action.FLY, FORWARD, seconds=1.0)
    heard = len(flight.radio.commands)
    before = loop_time()
    await flight.hold(Action.FLY, FORWARD, seconds=1.0)
    expected = (loop_time() - before) / ARDRONE.link.interval
    assert 0.4 * expected < len(flight.radio.commands) - heard < 1.2 * expected
    flight.drone.send(Command(Action.FLY, FORWARD))
    flight.drone.send(Command(Action.HOVER))
    await asyncio.sleep(0.005)
    newest = at.parse_datagram(flight.radio.commands[-1]).commands[0].command
    assert newest == at.Pcmd()


async def test_numbers_only_rise_in_a_steady_flight(flight) -> None:
    await flying(flight)
    await flight.hold(Action.FLY, FORWARD, seconds=0.5)
    numbers = [
        numbered.sequence
        for datagram in flight.radio.commands
        for numbered in at.parse_datagram(datagram).commands
    ]
    assert numbers == list(range(1, len(numbers) + 1))
    assert flight.server.counters.stale_commands == 0


async def test_cutting_motors_and_coming_back_toggles_once_each(flight) -> None:
    await flying(flight)
    await flight.until(lambda: status(flight) is DroneStatus.EMERGENCY, Action.CUT)
    await flight.hold(Action.CUT, seconds=1.0)
    assert flight.world.flight is twin.FlightState.EMERGENCY
    await flight.until(lambda: status(flight) is DroneStatus.LANDED, Action.RESET)
    await flight.hold(Action.RESET, seconds=1.0)
    assert flight.world.flight is twin.FlightState.LANDED


async def test_a_pilot_that_falls_silent_lets_it_hover_and_then_land(flight) -> None:
    await flying(flight)
    await flight.hold(Action.FLY, FORWARD, seconds=0.3)
    assert not flight.world.asked.hover
    await flight.silence(HOVER_AFTER + ARDRONE.brake.time_max + 0.1)
    assert flight.world.asked.hover and status(flight) is DroneStatus.FLYING
    await flight.silence(LAND_AFTER)
    assert status(flight) in (DroneStatus.LANDING, DroneStatus.LANDED)


async def test_a_watchdog_that_fails_lands_the_drone_although_its_log_takes_no_more(
    flight, monkeypatch
) -> None:
    def fail(*_: object) -> tuple[at.AtCommand, ...]:
        raise ZeroDivisionError("float division by zero")

    await flying(flight)
    await flight.hold(Action.FLY, FORWARD, seconds=0.3)
    monkeypatch.setattr(flight.drone._failsafe, "decide", fail)
    with full_output():
        await asyncio.sleep(1.0)
    sent = at.parse_datagram(flight.radio.commands[-1]).commands[0].command
    assert sent == at.Ref(at.RefBits.LAND)
    assert not flight.drone._tasks["repeat commands"].done()
    async with asyncio.timeout(10.0):
        while flight.world.flight is not twin.FlightState.LANDED:
            await asyncio.sleep(0.02)


async def test_a_watchdog_that_fails_lands_the_drone_before_it_says_so(flight, monkeypatch) -> None:
    sent: list[int] = []

    def fail(*_: object) -> tuple[at.AtCommand, ...]:
        raise ZeroDivisionError("float division by zero")

    class Watched(io.StringIO):
        def write(self, text: str) -> int:
            sent.append(flight.drone._commands.datagrams)
            return super().write(text)

    await flying(flight)
    before = flight.drone._commands.datagrams
    monkeypatch.setattr(flight.drone._failsafe, "decide", fail)
    with contextlib.redirect_stderr(Watched()) as said:
        await asyncio.sleep(0.2)
    assert "ZeroDivisionError" in said.getvalue()
    assert sent[0] == before + 1


async def test_a_flight_over_a_radio_that_loses_a_third_and_mixes_the_rest(flight) -> None:
    flight.radio.loss, flight.radio.duplicates, flight.radio.delay = 0.3, 0.1, 0.04
    await flying(flight)
    await flight.hold(Action.FLY, FORWARD, seconds=1.0)
    assert flight.drone.telemetry.velocity[0] > 0.2
    await flight.until(lambda: status(flight) is DroneStatus.LANDED, Action.LAND)
    await flight.until(lambda: status(flight) is DroneStatus.EMERGENCY, Action.CUT)
    await flight.until(lambda: status(flight) is DroneStatus.LANDED, Action.RESET)


async def test_a_link_that_was_gone_is_found_again(flight) -> None:
    await flying(flight)
    flight.radio.up = flight.radio.down = False
    await flight.hold(Action.HOVER, seconds=0.8)
    assert not flight.drone.connected
    assert flight.drone.telemetry_rate_hz < 100
    await flight.hold(Action.HOVER, seconds=2.0)
    assert flight.world.onboard().com_lost
    flight.radio.up = flight.radio.down = True
    await flight.until(
        lambda: flight.drone.connected and not flight.world.onboard().com_lost,
        Action.LAND,
        seconds=3.0,
    )
    await flight.until(lambda: status(flight) is DroneStatus.LANDED, Action.LAND)


async def test_a_drone_that_obeyed_another_client_before_obeys_us_soon(flight) -> None:
    await flight.drone.connect()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.sendto(
            at.encode_command(50_000, at.ComWatchdog()), (flight.radio.drone, at.COMMAND_PORT)
        )
    await flight.until(lambda: status(flight) is DroneStatus.FLYING, Action.TAKE_OFF)


async def test_a_drone_that_was_switched_off_and_on_is_configured_again(flight, world) -> None:
    await flight.drone.connect()
    await flight.server.stop()
    await flight.hold(Action.IDLE, seconds=0.8)
    assert not flight.drone.connected
    again = type(flight.server)(world, flight.radio.drone)
    world.limits = twin.OnboardLimits()
    await again.start()
    try:
        await flight.until(
            lambda: world.limits.tilt == pytest.approx(0.21), Action.IDLE, seconds=8.0
        )
        await flight.until(
            lambda: flight.drone.connected and flight.drone.telemetry_rate_hz > 50, Action.IDLE
        )
    finally:
        await again.stop()


async def test_reports_from_a_stranger_are_not_heard(flight) -> None:
    await flight.drone.connect()
    lie = encode_navdata(0, 2**31, [navdata_options.Demo(battery_percent=1)])
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        for _ in range(10):
            stranger.sendto(lie, flight.radio.clients[NAVDATA_PORT])
    await flight.hold(Action.IDLE, seconds=0.1)
    assert flight.drone.telemetry.battery == 1.0


async def test_who_speaks_in_the_drones_name_cannot_make_the_drone_itself_count_as_late(
    flight,
) -> None:
    await flight.drone.connect()
    lie = encode_navdata(0, 2**31, [navdata_options.Demo(battery_percent=1)])
    for _ in range(10):
        flight.radio.say(NAVDATA_PORT, lie)
    await flight.hold(Action.IDLE, seconds=0.1)
    assert flight.drone.telemetry.battery == 1.0
    assert flight.drone.telemetry_rate_hz > 50


async def test_garbage_from_the_drone_is_survived(flight) -> None:
    await flight.drone.connect()
    for data in (
        b"\0",
        b"\x88\x77\x66\x55",
        bytes(3000),
        b"PaVE" * 100,
        encode_navdata(0, 2**31)[:-1] + b"\1",
    ):
        flight.radio.say(NAVDATA_PORT, data)
        flight.radio.say(at.COMMAND_PORT, data)
    await flight.hold(Action.IDLE, seconds=0.3)
    assert flight.drone.connected and flight.drone.telemetry_rate_hz > 30
    assert status(flight) is DroneStatus.LANDED


async def test_recorded_pictures_arrive_from_the_first_key_frame_on_and_again_after_a_break(
    flight, shared_data: Path
) -> None:
    recorded = (shared_data / "ardrone" / "pave_64byte_headers_node-ar-drone.bin").read_bytes()
    frames = VideoReassembler().feed(recorded)
    pictures: list[VideoFrame] = []
    flight.drone.on_video(pictures.append)
    await flight.drone.connect()

    async def play_until(count: int) -> None:
        end = loop_time() + 6.0
        while len(pictures) < count:
            assert loop_time() < end, f"{len(pictures)} pictures"
            for frame in frames:
                flight.server.publish(_Picture(frame))
            await asyncio.sleep(0.1)

    await play_until(17)
    assert pictures[0].keyframe and (pictures[0].width, pictures[0].height) == (640, 360)
    assert [picture.sequence for picture in pictures[:3]] == [17565, 17566, 17567]
    assert flight.drone.video_connected
    flight.radio.cut_connections()
    seen = len(pictures)
    await play_until(seen + 17)
    assert pictures[seen].keyframe


class _Picture:
    def __init__(self, frame) -> None:
        self.number, self.data, self.keyframe = (
            frame.header.frame_number,
            frame.payload,
            frame.keyframe,
        )
        self.width, self.height, self.at = 640, 360, frame.header.timestamp_ms / 1000


async def test_camera_lights_and_trim(flight) -> None:
    await flight.drone.connect()
    await flight.drone.select_camera(VideoChannel.BOTTOM)
    assert flight.server.camera is twin.DroneCamera.BOTTOM
    await flight.drone.leds(3, 2.0, 5)
    assert flight.server.settings.value("leds:leds_anim") == "3,1073741824,5"
    flight.drone.flat_trim()
    await flight.hold(Action.IDLE, seconds=0.1)
    assert flight.world.trims == 1
    await flight.until(lambda: status(flight) is DroneStatus.FLYING, Action.TAKE_OFF)
    with pytest.raises(LinkError, match="flying"):
        flight.drone.flat_trim()


async def test_where_no_drone_is_the_error_says_where_and_what_to_look_for(
    loopback: str, monkeypatch
) -> None:
    monkeypatch.setattr(driver_module, "FIRST_REPORT_TIMEOUT", 0.3)
    drone = ArDrone(DroneConfig(address=loopback), LimitsConfig())
    drone.send(Command(Action.IDLE))
    for _ in range(2):
        with pytest.raises(LinkError, match=rf"no drone answers at {loopback}:5554.*Wi-Fi"):
            await drone.connect()
    assert not drone.connected and not drone.video_connected and drone.telemetry is None
    with pytest.raises(LinkError, match="unknown"):
        drone.flat_trim()
    await drone.close()
    await drone.close()


async def test_a_drone_that_does_not_acknowledge_is_named_with_the_key(flight) -> None:
    flight.radio.swallows = b"AT*CONFIG="
    with pytest.raises(LinkError, match="did not acknowledge general:navdata_demo"):
        await flight.drone.connect()


async def test_short_reports_for_a_weak_radio(flight) -> None:
    drone = ArDrone(
        DroneConfig(address=flight.radio.drone, has_video=False), LimitsConfig(), full_navdata=False
    )
    await drone.connect()
    await asyncio.sleep(1.0)
    assert 2 < drone.telemetry_rate_hz < 25
    await drone.close()


async def test_a_tilt_limit_that_is_never_acknowledged_keeps_it_down_and_is_said(flight) -> None:
    flight.radio.swallows = b"control:euler_angle_max"
    connecting = asyncio.create_task(flight.drone.connect())
    await flight.until(
        lambda: flight.drone.telemetry is not None and connecting.done(), Action.TAKE_OFF
    )
    with pytest.raises(LinkError, match="euler_angle_max"):
        await connecting
    await flight.hold(Action.TAKE_OFF, seconds=0.5)
    assert flight.world.flight is twin.FlightState.LANDED
    assert not flight.drone.telemetry.configured
    assert any("euler_angle_max" in note for note in flight.drone.telemetry.notes)
    assert "euler_angle_max" in flight.drone.problem
    flight.radio.swallows = None
    await flight.drone.connect()
    assert flight.drone.telemetry.configured and flight.drone.problem == ""
    await flight.hold(Action.IDLE, seconds=0.1)
    await flight.until(lambda: status(flight) is DroneStatus.FLYING, Action.TAKE_OFF)


async def test_it_does_not_take_off_while_it_is_being_configured(flight) -> None:
    connecting = asyncio.create_task(flight.drone.connect())
    while not connecting.done():
        flight.drone.send(Command(Action.TAKE_OFF))
        assert flight.world.flight is twin.FlightState.LANDED
        assert flight.drone.telemetry is None or not flight.drone.telemetry.configured
        await asyncio.sleep(0.005)
    await connecting
    await flight.until(lambda: status(flight) is DroneStatus.FLYING, Action.TAKE_OFF)


@pytest.mark.parametrize(
    ("key", "stays_down"), [("control:control_yaw", True), ("video:bitrate", False)]
)
async def test_a_setting_that_the_drone_keeps_is_told_and_a_limit_keeps_it_down(
    flight, monkeypatch, key: str, stays_down: bool
) -> None:
    wanted = limits_keeper.wanted_settings
    monkeypatch.setattr(
        limits_keeper,
        "wanted_settings",
        lambda limits: tuple(pair for pair in wanted(limits) if pair[0] != key),
    )
    await flight.drone.connect()
    await flight.hold(Action.TAKE_OFF, seconds=1.0)
    assert any(key in note for note in flight.drone.telemetry.notes)
    assert flight.drone.telemetry.configured is not stays_down
    assert (flight.world.flight is twin.FlightState.LANDED) is stays_down


async def test_a_rebooted_drone_is_not_configured_until_it_is_again(flight, world) -> None:
    await flight.drone.connect()
    assert flight.drone.telemetry.configured
    flight.radio.swallows = b"AT*CONFIG="
    await flight.server.stop()
    await flight.hold(Action.IDLE, seconds=0.8)
    again = type(flight.server)(world, flight.radio.drone)
    await again.start()
    try:
        await flight.until(lambda: flight.drone.connected, Action.IDLE)
        await flight.hold(Action.TAKE_OFF, seconds=0.5)
        assert not flight.drone.telemetry.configured
        assert world.flight is twin.FlightState.LANDED
        flight.radio.swallows = None
        await flight.until(lambda: flight.drone.telemetry.configured, Action.IDLE)
    finally:
        await again.stop()


@pytest.mark.parametrize(
    "flood",
    [
        pytest.param(b"PaVE" * 4096, id="headers without end"),
        pytest.param(bytes(16384), id="nothing"),
        pytest.param(encode_frame(PaveHeader(0, 1), b"") * 200, id="empty pictures"),
    ],
)
async def test_a_flood_of_video_delays_no_command(flight, monkeypatch, flood: bytes) -> None:
    async def pour(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with contextlib.suppress(ConnectionError):
            while True:
                writer.write(flood)
                await writer.drain()
                await asyncio.sleep(len(flood) / 4e6)

    await flying(flight)
    await flight.drone._video.close()
    a, b, c, d = flight.radio.drone.split(".")
    elsewhere = f"{a}.{b}.{c}.{(int(d) + 97) % 250 + 1}"
    server = await asyncio.start_server(pour, elsewhere, VIDEO_PORT)
    headers = 0

    def counted(data: bytes) -> PaveHeader:
        nonlocal headers
        headers += 1
        return decode(data)

    decode = pave.decode_header
    monkeypatch.setattr(pave, "decode_header", counted)
    flight.drone._video = VideoLink(elsewhere, RealClock())
    flight.drone._video.start()
    await flight.hold(Action.FLY, FORWARD, seconds=2.0)
    server.close()
    assert headers < 3000, "video keeps the loop busy"
    assert not flight.world.asked.hover
