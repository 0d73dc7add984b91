"""The four ports of the simulated drone, spoken to as a client would."""

from __future__ import annotations

import asyncio
import ftplib
import random
import socket
from collections.abc import AsyncIterator, Callable
from contextlib import suppress
from itertools import pairwise

import pytest
from kinematic_world import KinematicWorld

from housefly.clock import RealClock
from housefly.errors import ConfigError, LinkError
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.contracts import DroneCamera, EncodedPicture, FlightState
from housefly.twin.link_counters import Counters
from housefly.twin.real_time import RealTimeRunner
from housefly.wires.ardrone import at
from housefly.wires.ardrone.config import CONTROL_PORT, parse_dump
from housefly.wires.ardrone.navdata import NAVDATA_PORT, NavdataPacket, StateBits, decode_navdata
from housefly.wires.ardrone.navdata_options import Demo
from housefly.wires.ardrone.pave import (
    VIDEO_PORT,
    FrameType,
    PaveFrame,
    VideoReassembler,
    encode_header,
)

pytestmark = pytest.mark.wire

KEY_PICTURE = b"".join(
    b"\x00\x00\x00\x01" + unit
    for unit in (b"\x67" + 9 * b"s", b"\x68" + 5 * b"p", b"\x65" + 3000 * b"i")
)
OTHER_PICTURE = b"\x00\x00\x00\x01\x41" + 1000 * b"p"


def picture(number: int, keyframe: bool = True) -> EncodedPicture:
    data = KEY_PICTURE if keyframe else OTHER_PICTURE
    return EncodedPicture(number, data, keyframe, 640, 360, at=1.0)


class Client:
    """A bare client: one socket for navdata, one for commands."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.sequence = 0
        self.navdata = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.navdata.setblocking(False)
        self.navdata.bind((address, 0))
        self.commands = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def close(self) -> None:
        self.navdata.close()
        self.commands.close()

    def ask(self, request: bytes = b"\x01") -> None:
        self.navdata.sendto(request, (self.address, NAVDATA_PORT))

    def send(self, *commands: at.AtCommand) -> None:
        self.commands.sendto(
            at.encode_datagram(self.sequence + 1, commands), (self.address, at.COMMAND_PORT)
        )
        self.sequence += len(commands)

    async def receive(self) -> NavdataPacket:
        loop = asyncio.get_running_loop()
        data, sender = await asyncio.wait_for(loop.sock_recvfrom(self.navdata, 4096), 3.0)
        assert sender == (self.address, NAVDATA_PORT)
        return decode_navdata(data)

    async def until(self, holds: Callable[[NavdataPacket], bool]) -> NavdataPacket:
        for _ in range(400):
            packet = await self.receive()
            if holds(packet):
                return packet
        raise AssertionError("no such packet among 400")


@pytest.fixture
async def world() -> AsyncIterator[KinematicWorld]:
    world = KinematicWorld()
    running = asyncio.create_task(RealTimeRunner(world, RealClock()).run())
    yield world
    running.cancel()
    await asyncio.gather(running, return_exceptions=True)


@pytest.fixture
async def server(world: KinematicWorld, loopback: str) -> AsyncIterator[ArDroneServer]:
    server = ArDroneServer(world, loopback)
    await server.start()
    yield server
    await server.stop()


@pytest.fixture
async def client(server: ArDroneServer, loopback: str) -> AsyncIterator[Client]:
    client = Client(loopback)
    yield client
    client.close()


@pytest.mark.parametrize(
    "request_bytes", [b"\1", b"\1\0", b"\1\0\0\0", b"Init", b"\1" + 13 * b"\0"]
)
async def test_bring_up_goes_bootstrap_setting_acknowledge_clear_stream(client, request_bytes):
    client.ask(request_bytes)
    first = await client.receive()
    assert first.has(StateBits.NAVDATA_BOOTSTRAP)
    assert first.options == ()

    client.send(at.Config("general:navdata_demo", "TRUE"))
    accepted = await client.until(lambda packet: packet.has(StateBits.COMMAND_ACK))
    assert not accepted.has(StateBits.NAVDATA_BOOTSTRAP)
    assert accepted.has(StateBits.NAVDATA_DEMO)

    client.send(at.Control(at.ControlMode.CLEAR_ACK))
    cleared = await client.until(lambda packet: not packet.has(StateBits.COMMAND_ACK))
    assert cleared.option(Demo) is not None


async def test_full_navdata_comes_far_more_often_than_demo(client, server):
    async def packets_in_half_a_second(demo: bool) -> int:
        client.send(at.Config("general:navdata_demo", "TRUE" if demo else "FALSE"))
        await client.until(
            lambda packet: packet.has(StateBits.NAVDATA_DEMO) == demo and packet.options != ()
        )
        before = server.counters.navdata_sent
        await asyncio.sleep(0.5)
        return server.counters.navdata_sent - before

    client.ask(b"\x01\x00\x00\x00")
    demo, full = await packets_in_half_a_second(True), await packets_in_half_a_second(False)
    assert full > 5 * demo > 0


async def test_navdata_goes_to_whoever_asked_last(client, loopback):
    client.ask()
    await client.receive()
    second = Client(loopback)
    second.ask()
    await second.receive()
    await asyncio.sleep(0.1)
    while True:
        try:
            client.navdata.recv(4096)
        except BlockingIOError:
            break
    await second.receive()
    await second.receive()
    with pytest.raises(BlockingIOError):
        client.navdata.recv(4096)
    second.close()


async def test_silence_ends_the_stream_and_a_new_client_finds_bootstrap(
    server, client, loopback, world
):
    client.ask()
    client.send(at.Config("general:navdata_demo", "TRUE"))
    await client.until(lambda packet: packet.option(Demo) is not None)
    world.advance(2.5)
    sent = None
    while sent != server.counters.navdata_sent:
        sent = server.counters.navdata_sent
        await asyncio.sleep(0.15)

    client.ask()
    last_known = await client.until(lambda packet: packet.has(StateBits.COM_LOST))
    assert last_known.option(Demo) is not None, "the old client finds what it had chosen"

    world.advance(2.5)
    await asyncio.sleep(0.15)
    other = Client(loopback)
    other.ask()
    assert (await other.receive()).has(StateBits.NAVDATA_BOOTSTRAP)
    other.close()


async def test_the_drone_flies_by_datagrams(client, world):
    client.ask()
    client.send(at.Config("general:navdata_demo", "TRUE"))
    client.send(at.Ref(at.RefBits.TAKE_OFF))
    packet = await client.until(lambda packet: packet.has(StateBits.FLYING))
    assert packet.option(Demo).major == 6
    assert world.flight is FlightState.TAKING_OFF


async def test_the_configuration_comes_over_its_own_port(client, loopback):
    reader, writer = await asyncio.open_connection(loopback, CONTROL_PORT)
    client.send(at.Config("control:altitude_max", "1234"), at.Control(at.ControlMode.SEND_CONFIG))
    dump = parse_dump(await asyncio.wait_for(reader.readuntil(b"\0"), 3.0))
    assert dump.values["control:altitude_max"] == 1234
    assert dump.rejects == ()
    client.send(at.Control(at.ControlMode.SEND_CUSTOM_CONFIGS))
    assert b"[sessions]" in await asyncio.wait_for(reader.readuntil(b"\0"), 3.0)
    writer.close()


async def test_a_request_that_overtakes_its_connection_waits_for_it(client, server, loopback):
    client.send(at.Control(at.ControlMode.SEND_CONFIG))
    while server.counters.commands == 0:
        await asyncio.sleep(0.01)
    reader, writer = await asyncio.open_connection(loopback, CONTROL_PORT)
    assert await asyncio.wait_for(reader.readuntil(b"\0"), 3.0)
    writer.close()


async def test_settings_reach_the_world_and_the_camera(client, server, world):
    client.ask()
    client.send(at.Config("control:euler_angle_max", "0.1"), at.Config("video:video_channel", "1"))
    await client.until(lambda packet: packet.has(StateBits.COMMAND_ACK))
    assert world.limits.tilt == 0.1
    assert server.camera is DroneCamera.BOTTOM


async def read_frames(reader: asyncio.StreamReader, count: int) -> list[PaveFrame]:
    reassembler = VideoReassembler()
    frames: list[PaveFrame] = []
    while len(frames) < count:
        frames += reassembler.feed(await asyncio.wait_for(reader.read(65536), 3.0))
    assert reassembler.skipped_bytes == 0
    return frames


async def open_video(
    server: ArDroneServer, address: str
) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
    before = server.viewers
    reader, writer = await asyncio.open_connection(address, VIDEO_PORT)
    while server.viewers == before:
        await asyncio.sleep(0.005)
    return reader, writer


async def test_pictures_come_in_pave_frames(server, loopback):
    reader, writer = await open_video(server, loopback)
    server.publish(picture(7))
    server.publish(picture(8, keyframe=False))
    key, other = await read_frames(reader, 2)
    writer.close()
    assert (key.payload, other.payload) == (KEY_PICTURE, OTHER_PICTURE)
    assert (key.header.frame_type, other.header.frame_type) == (FrameType.IDR, FrameType.P_FRAME)
    assert (key.header.sps_size, key.header.pps_size) == (14, 10)
    assert (key.header.encoded_height, key.header.display_height) == (368, 360)
    assert (key.header.frame_number, key.header.timestamp_ms) == (7, 101_000)


async def test_what_a_viewer_gets_begins_with_a_key_frame(server, loopback):
    reader, writer = await open_video(server, loopback)
    for number, keyframe in ((1, False), (2, True)):
        server.publish(picture(number, keyframe))
    (first,) = await read_frames(reader, 1)
    writer.close()
    assert first.header.frame_number == 2


async def test_no_header_looks_like_the_start_of_a_picture_to_who_reads_the_stream_raw(
    server, loopback
):
    reader, writer = await open_video(server, loopback)
    for number in range(2, 12):
        server.publish(picture(number))
    frames = await read_frames(reader, 10)
    writer.close()
    assert all(b"\0\0\1" not in encode_header(frame.header) for frame in frames)


async def test_the_firmwares_version_is_read_by_ftp(server, loopback):
    def downloaded() -> bytes:
        with ftplib.FTP() as ftp:
            ftp.connect(loopback, 5551, timeout=3.0)
            ftp.login()
            content: list[bytes] = []
            ftp.retrbinary("RETR version.txt", content.append)
            with pytest.raises(ftplib.error_perm):
                ftp.retrbinary("RETR /etc/passwd", content.append)
            ftp.quit()
            return b"".join(content)

    assert await asyncio.to_thread(downloaded) == b"2.4.8\n"


async def test_the_longer_header_of_some_firmware_can_be_had(world, loopback):
    server = ArDroneServer(world, loopback, pave_header_size=68)
    await server.start()
    reader, writer = await open_video(server, loopback)
    server.publish(picture(1))
    (frame,) = await read_frames(reader, 1)
    assert frame.header.header_size == 68
    assert frame.payload == KEY_PICTURE
    writer.close()
    await server.stop()


async def drain(slow: socket.socket, reassembler: VideoReassembler) -> list[int]:
    """Read until nothing more comes and return the numbers of the pictures."""
    loop, numbers = asyncio.get_running_loop(), list[int]()
    with suppress(TimeoutError):
        while True:
            data = await asyncio.wait_for(loop.sock_recv(slow, 65536), 0.3)
            numbers += [frame.header.frame_number for frame in reassembler.feed(data)]
    return numbers


async def test_a_slow_client_loses_pictures_up_to_a_key_and_delays_nobody(server, loopback):
    slow = socket.socket()
    slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 65536)
    slow.connect((loopback, VIDEO_PORT))
    slow.setblocking(False)
    reader, writer = await open_video(server, loopback)
    quick, late = VideoReassembler(), VideoReassembler()
    received, numbers = list[int](), list[int]()
    for number in range(920):
        if number == 899:
            numbers += await drain(slow, late)
        server.publish(picture(number, keyframe=number % 15 == 0))
        received += [
            frame.header.frame_number
            for frame in quick.feed(await asyncio.wait_for(reader.read(65536), 3.0))
        ]
    numbers += await drain(slow, late)

    assert received == list(range(received[0], 920)), "the quick client misses nothing"
    gaps = [after for before, after in pairwise(numbers) if after != before + 1]
    assert gaps and all(after % 15 == 0 for after in gaps), "after a gap comes a key picture"
    slow.close()
    writer.close()


async def test_no_pictures_leave_while_the_client_switched_video_off(server, client, loopback):
    client.send(at.Config("general:video_enable", "FALSE"))
    _, writer = await open_video(server, loopback)
    while server.counters.commands == 0:
        await asyncio.sleep(0.01)
    server.publish(picture(1))
    assert server.counters.frames_sent == 0
    writer.close()


async def test_garbage_on_every_port_is_counted_and_the_drone_serves_on(server, client, loopback):
    surprises: list[dict[str, object]] = []
    asyncio.get_running_loop().set_exception_handler(
        lambda loop, context: surprises.append(context)
    )
    chance = random.Random(1)
    for _ in range(300):
        garbage = chance.randbytes(chance.randrange(0, 1200))
        client.commands.sendto(garbage, (loopback, at.COMMAND_PORT))
        client.navdata.sendto(garbage, (loopback, NAVDATA_PORT))
        if chance.random() < 0.2:
            await asyncio.sleep(0)
    for port in (VIDEO_PORT, CONTROL_PORT):
        for _ in range(20):
            with socket.create_connection((loopback, port)) as connection:
                connection.send(chance.randbytes(2000) + b"AT*CTRL=1,4,0\r")
        await asyncio.sleep(0.05)
    assert surprises == []
    assert server.counters.malformed > 0
    assert server.counters.refused_requests > 0

    client.ask()
    client.send(at.Config("general:navdata_demo", "TRUE"))
    assert (await client.until(lambda packet: packet.option(Demo) is not None)).has(
        StateBits.NAVDATA_DEMO
    )


async def test_clients_beyond_the_limit_are_turned_away(server, loopback):
    connections = [await asyncio.open_connection(loopback, VIDEO_PORT) for _ in range(12)]
    for _ in range(100):
        server.publish(picture(1))
        await asyncio.sleep(0.005)
        if sum(reader.at_eof() for reader, _ in connections) == 4:
            break
    assert server.viewers == 8
    for _, writer in connections:
        writer.close()


async def test_counters_start_at_zero(server):
    assert server.counters == Counters()


async def test_a_taken_address_is_told_in_words_and_nothing_stays_open(server, world, loopback):
    with pytest.raises(LinkError, match=f"cannot serve an AR.Drone at {loopback}"):
        await ArDroneServer(world, loopback).start()


@pytest.mark.parametrize("address", ["0.0.0.0", "192.168.1.1", "localhost", "::"])
def test_only_loopback_is_served_unless_asked(address):
    with pytest.raises(ConfigError, match=r"drone\.address"):
        ArDroneServer(KinematicWorld(), address)


def test_another_address_is_served_when_asked():
    assert ArDroneServer(KinematicWorld(), "192.168.1.1", beyond_loopback=True)
