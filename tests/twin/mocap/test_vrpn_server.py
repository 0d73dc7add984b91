"""The simulated VRPN server: read by the genuine VRPN library, fair to many, robust to garbage."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from math import cos, sin

import pytest
from tracking_stage import DRONE, YAW, fed, frame, stranger, until

from housefly.errors import LinkError
from housefly.twin.mocap.vrpn_server import VrpnServer
from housefly.wires.vrpn import (
    COOKIE_SIZE,
    PING_TYPE,
    PONG_TYPE,
    POSE_TYPE,
    SENDER_DESCRIPTION,
    TYPE_DESCRIPTION,
    VrpnMessage,
    VrpnNames,
    VrpnStream,
    decode_pose,
    description_message,
    encode_cookie,
    encode_lob,
    encode_message,
)

pytestmark = pytest.mark.wire


# waitForNextFrame of this client returns at its own pace, often without anything new.
PEER = """
import json, sys, time
import motioncapture
client = motioncapture.connect("vrpn", {"hostname": sys.argv[1]})
start, rows = time.monotonic(), []
while len(rows) < 150 and time.monotonic() - start < 30.0:
    client.waitForNextFrame()
    for name, body in client.rigidBodies.items():
        turn = body.rotation
        row = [name, *map(float, body.position), turn.w, turn.x, turn.y, turn.z]
        if not rows or row != rows[-1]:
            rows.append(row)
print(json.dumps({"rows": rows}))
"""


@asynccontextmanager
async def served(address: str, y_up: bool = False) -> AsyncIterator[VrpnServer]:
    """Serve 100 frames a second; the drone's x counts the frames in millimetres."""
    server = VrpnServer(address, y_up=y_up)
    async with fed(server):
        yield server


class Client:
    """A bare client that keeps what it hears."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.reader, self.writer = reader, writer
        self.stream, self.names = VrpnStream(), VrpnNames()
        self.heard: list[VrpnMessage] = []

    async def greet(self) -> None:
        self.writer.write(encode_cookie())
        assert await self.reader.readexactly(COOKIE_SIZE) == encode_cookie()

    async def hear(self, kind: str) -> VrpnMessage:
        """Return the next message of a type."""
        async with asyncio.timeout(10.0):
            while True:
                for message in self.stream.feed(await self.reader.read(65536)):
                    self.names.learn(message)
                    self.heard.append(message)
                found = [message for message in self.heard if self.names.kind(message) == kind]
                if found:
                    self.heard.clear()
                    return found[-1]


async def connected(address: str) -> Client:
    client = Client(*await asyncio.open_connection(address, 3883))
    await client.greet()
    return client


async def test_the_genuine_library_reads_our_poses(loopback: str) -> None:
    pytest.importorskip("motioncapture")
    async with served(loopback):
        answer = await stranger(PEER, loopback)
    assert len(answer["rows"]) == 150
    for name, _, y, z, *rotation in answer["rows"]:
        assert name == "ardrone"
        assert (y, z) == pytest.approx(DRONE.position[1:], abs=1e-6)
        assert rotation == pytest.approx((cos(YAW / 2), 0.0, 0.0, sin(YAW / 2)), abs=1e-6)
    # The x of a pose says its number: what is read moves on, none twice.
    numbers = [round(1000.0 * row[1]) for row in answer["rows"]]
    assert numbers == sorted(set(numbers))


async def test_a_client_learns_names_then_poses(loopback: str) -> None:
    async with served(loopback):
        client = await connected(loopback)
        message = await client.hear(POSE_TYPE)
        assert client.names.sender(message) == "ardrone"
        pose = decode_pose(message.body)
        assert pose.position[1:] == DRONE.position[1:]
        assert pose.orientation == DRONE.orientation
        assert message.stamp == pytest.approx(1e4 * 1000.0 * pose.position[0], abs=2)
        client.writer.close()


async def test_a_server_with_y_up_turns_positions(loopback: str) -> None:
    async with served(loopback, y_up=True):
        client = await connected(loopback)
        _, y, z = decode_pose((await client.hear(POSE_TYPE)).body).position
        assert (y, -z) == (DRONE.position[2], DRONE.position[1])
        client.writer.close()


async def test_a_client_that_asks_by_datagram_is_called_back(loopback: str) -> None:
    async with served(loopback) as server:
        links: list[Client] = []
        listener = await asyncio.start_server(
            lambda r, w: links.append(Client(r, w)), "127.0.0.1", 0
        )
        port = listener.sockets[0].getsockname()[1]
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
            asking.bind(("127.0.0.1", 0))
            asking.connect((loopback, 3883))
            # Whoever is named in the datagram, only the asker itself is called.
            for _ in range(3):
                asking.send(encode_lob("192.0.2.77", port))
            await until(lambda: len(links) == 1)
        await links[0].greet()
        assert links[0].names.sender(await links[0].hear(POSE_TYPE)) == "ardrone"
        assert server.clients == 1
        links[0].writer.close()
        listener.close()


async def test_pings_are_answered(loopback: str) -> None:
    async with served(loopback):
        client = await connected(loopback)
        for number, name in ((4, "ardrone"), (5, "nobody")):
            client.writer.write(
                encode_message(description_message(SENDER_DESCRIPTION, number, name))
            )
        client.writer.write(encode_message(description_message(TYPE_DESCRIPTION, 9, PING_TYPE)))
        for sender in (5, 6, 4):
            client.writer.write(encode_message(VrpnMessage(9, sender, 0, b"")))
        assert client.names.sender(await client.hear(PONG_TYPE)) == "ardrone"
        client.writer.close()


async def test_a_body_out_of_sight_is_not_spoken_of(loopback: str) -> None:
    server = VrpnServer(loopback)
    await server.start()
    client = await connected(loopback)
    await until(lambda: server.clients == 1)
    server.publish(frame(1, None))
    server.publish(frame(2))
    assert (await client.hear(POSE_TYPE)).stamp == 20_000
    client.writer.close()
    await server.stop()


async def test_a_client_that_does_not_read_loses_frames_and_delays_nobody(loopback: str) -> None:
    server = VrpnServer(loopback)
    await server.start()
    slow = socket.socket()
    slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    slow.connect((loopback, 3883))
    slow.sendall(encode_cookie())
    client = await connected(loopback)
    await until(lambda: server.clients == 2)
    for number in range(1, 6000):
        server.publish(frame(number))
        assert (await client.hear(POSE_TYPE)).stamp == 10_000 * number
    assert server.lost > 1000
    assert server.clients == 2
    slow.close()
    client.writer.close()
    await server.stop()


@pytest.mark.parametrize(
    "garbage",
    [
        b"GET / HTTP/1.1\r\nHost: here\r\n\r\n",
        b"vrpn: ver. 08.01  0\0\0\0\0\0",
        encode_cookie() + b"\xff" * 24,
        encode_cookie() + encode_message(VrpnMessage(SENDER_DESCRIPTION, -7, 0, b"")),
    ],
)
async def test_garbage_closes_only_its_own_connection(loopback: str, garbage: bytes) -> None:
    async with served(loopback) as server:
        client = await connected(loopback)
        _, stranger = await asyncio.open_connection(loopback, 3883)
        stranger.write(garbage)
        await until(lambda: server.malformed == 1)
        await client.hear(POSE_TYPE)
        assert server.clients == 1
        stranger.close()
        client.writer.close()


async def test_a_datagram_that_asks_for_nothing_is_counted(loopback: str) -> None:
    async with served(loopback) as server:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
            asking.sendto(b"\xff\xfe", (loopback, 3883))
            asking.sendto(encode_lob("127.0.0.1", 9), (loopback, 3883))
        await until(lambda: server.malformed == 1)
        client = await connected(loopback)
        await client.hear(POSE_TYPE)
        client.writer.close()


async def test_too_many_clients_are_turned_away(loopback: str) -> None:
    async with served(loopback) as server:
        links = [await asyncio.open_connection(loopback, 3883) for _ in range(40)]
        for _, writer in links:
            writer.write(encode_cookie())
        await until(lambda: server.clients == 32)
        for _, writer in links:
            writer.close()
        await until(lambda: server.clients == 0)


async def test_a_taken_port_is_named(loopback: str) -> None:
    async with served(loopback):
        with pytest.raises(LinkError, match=f"{loopback}:3883"):
            await VrpnServer(loopback).start()
