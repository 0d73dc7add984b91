"""The simulated Vicon: read by the genuine SDK client, fair to many clients, unmoved by garbage."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from itertools import pairwise
from math import cos, sin

import pytest
from tracking_stage import DRONE, YAW, fed, frame, stranger, until

from housefly.errors import LinkError
from housefly.twin.mocap.vicon_server import _OFFERED_KINDS, ViconServer
from housefly.wires.vicon import (
    VICON_HEADER_SIZE,
    FrameContents,
    FrameInfo,
    GlobalSegments,
    ObjectEnums,
    RequestFrame,
    RequestNextFrame,
    ViconObject,
    ViconPing,
    decode_packet,
    encode_packet,
    packet_length,
)

pytestmark = pytest.mark.wire

MAGIC = b"\x01\x00\x2b\x1a"

PEER = """
import json, sys
import motioncapture
client = motioncapture.connect("vicon", {"hostname": sys.argv[1]})
client.waitForNextFrame()
rows = []
for _ in range(200):
    client.waitForNextFrame()
    body = client.rigidBodies["ardrone"]
    turn = body.rotation
    rows.append([*map(float, body.position), turn.w, turn.x, turn.y, turn.z])
print(json.dumps({"rows": rows, "names": sorted(client.rigidBodies)}))
"""


@asynccontextmanager
async def served(address: str, first: int = 1) -> AsyncIterator[ViconServer]:
    """Serve 100 frames a second; the drone's x counts the frames in millimetres."""
    server = ViconServer(address)
    async with fed(server, first):
        yield server


async def read_packet(reader: asyncio.StreamReader) -> tuple[ViconObject, ...]:
    async with asyncio.timeout(10.0):
        length = packet_length(await reader.readexactly(VICON_HEADER_SIZE))
        return decode_packet(await reader.readexactly(length))


async def test_the_genuine_client_reads_our_poses_frame_by_frame(loopback: str) -> None:
    pytest.importorskip("motioncapture")
    async with served(loopback):
        answer = await stranger(PEER, f"{loopback}:8010")
    assert answer["names"] == ["ardrone"]
    steps = [1000.0 * (b[0] - a[0]) for a, b in pairwise(answer["rows"])]
    assert sum(round(step) == 1 for step in steps) >= 0.9 * len(steps), (
        "frames were lost on the way"
    )
    for _, y, z, *rotation in answer["rows"]:
        assert (y, z) == pytest.approx(DRONE.position[1:], abs=1e-6)
        assert rotation == pytest.approx((cos(YAW / 2), 0.0, 0.0, sin(YAW / 2)), abs=1e-6)


async def test_the_server_speaks_first_and_streams_only_what_was_asked(loopback: str) -> None:
    async with served(loopback):
        reader, writer = await asyncio.open_connection(loopback, 8010)
        assert await read_packet(reader) == (ObjectEnums(_OFFERED_KINDS),)
        writer.write(
            encode_packet(
                [
                    ObjectEnums(frozenset({FrameInfo.KIND, FrameContents.KIND, 77})),
                    RequestFrame(True),
                ]
            )
        )
        contents, number = await read_packet(reader)
        assert contents == FrameContents(((FrameInfo.KIND, 1),))
        assert isinstance(number, FrameInfo)
        writer.close()


async def test_a_client_may_ask_for_single_frames(loopback: str) -> None:
    server = ViconServer(loopback)
    await server.start()
    reader, writer = await asyncio.open_connection(loopback, 8010)
    await read_packet(reader)
    server.publish(frame(1))
    writer.write(encode_packet([RequestFrame(False)]))
    assert FrameInfo(1) in await read_packet(reader)
    writer.write(encode_packet([RequestNextFrame(2), ViconPing(5)]))
    assert await read_packet(reader) == (ViconPing(5),)
    for number in range(2, 6):
        server.publish(frame(number))
    assert FrameInfo(2) in await read_packet(reader)
    assert FrameInfo(3) in await read_packet(reader)
    writer.write(encode_packet([ViconPing(6)]))
    assert await read_packet(reader) == (ViconPing(6),), "frames that nobody asked for were sent"
    writer.close()
    await server.stop()


async def test_a_body_out_of_sight_keeps_its_name_but_has_no_segment(loopback: str) -> None:
    async with served(loopback):
        reader, writer = await asyncio.open_connection(loopback, 8010)
        await read_packet(reader)
        writer.write(encode_packet([RequestFrame(True)]))
        items = await read_packet(reader)
        assert [item.subject for item in items if isinstance(item, GlobalSegments)] == [1]
        writer.close()


async def test_a_client_that_does_not_read_loses_frames_and_delays_nobody(loopback: str) -> None:
    server = ViconServer(loopback)
    await server.start()
    slow_socket = socket.socket()
    slow_socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    slow_socket.connect((loopback, 8010))
    slow_socket.sendall(encode_packet([RequestFrame(True)]))
    reader, writer = await asyncio.open_connection(loopback, 8010)
    await read_packet(reader)
    writer.write(encode_packet([RequestFrame(True), ViconPing(1)]))
    assert await read_packet(reader) == (ViconPing(1),)
    for number in range(1, 3000):
        server.publish(frame(number))
        assert FrameInfo(number) in await read_packet(reader)
    assert server.lost > 1000
    assert server.clients == 2
    slow_socket.close()
    writer.close()
    await server.stop()


@pytest.mark.parametrize(
    "garbage",
    [
        b"GET / HTTP/1.1\r\n\r\n",
        b"\x01\x00\x2b\x1a\xff\xff\xff\xff",
        b"\x01\x00\x2b\x1a\x09\0\0\0" + b"\xff" * 9,
    ],
)
async def test_garbage_closes_only_its_own_connection(loopback: str, garbage: bytes) -> None:
    async with served(loopback) as server:
        reader, writer = await asyncio.open_connection(loopback, 8010)
        await read_packet(reader)
        _, stranger = await asyncio.open_connection(loopback, 8010)
        stranger.write(garbage)
        await until(lambda: server.malformed == 1)
        writer.write(encode_packet([ViconPing(9)]))
        assert await read_packet(reader) == (ViconPing(9),)
        assert server.clients == 1
        stranger.close()
        writer.close()


async def test_too_many_clients_are_turned_away(loopback: str) -> None:
    async with served(loopback) as server:
        links = [await asyncio.open_connection(loopback, 8010) for _ in range(40)]
        await until(lambda: server.clients == 32)
        for _, writer in links:
            writer.close()
        await until(lambda: server.clients == 0)


async def test_a_taken_port_is_named(loopback: str) -> None:
    async with served(loopback):
        with pytest.raises(LinkError, match=f"{loopback}:8010"):
            await ViconServer(loopback).start()
