"""The simulated OptiTrack: read by strangers' clients, fair to many, unmoved by garbage."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from itertools import pairwise
from math import cos, sin
from typing import Any

import pytest
from tracking_stage import DRONE, YAW, fed, frame, stranger, until

from housefly.errors import LinkError
from housefly.twin.mocap import natnet_server
from housefly.twin.mocap.natnet_server import NatNetServer, natnet_frame
from housefly.wires.natnet import (
    CommandRequest,
    CommandResponse,
    Connect,
    Disconnect,
    Discovery,
    EchoRequest,
    EchoResponse,
    KeepAlive,
    ModelDef,
    NatNetFrame,
    NatNetMessage,
    NatNetVersion,
    RequestModelDef,
    RigidBodyDescription,
    ServerInfo,
    Unrecognized,
    decode_natnet,
    encode_natnet,
)

pytestmark = pytest.mark.wire


MOTIONCAPTURE = """
import json, sys
import motioncapture
client = motioncapture.connect("optitrack", {"hostname": sys.argv[1], "interface_ip": sys.argv[1]})
client.waitForNextFrame()
rows = []
for _ in range(200):
    client.waitForNextFrame()
    body = client.rigidBodies["ardrone"]
    turn = body.rotation
    rows.append([*map(float, body.position), turn.w, turn.x, turn.y, turn.z])
print(json.dumps({"rows": rows, "names": sorted(client.rigidBodies)}))
"""

NATNET = """
import json, sys, time
from natnet import NatNetClient, Version
address, group, port, wish = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4]
target = group or "239.255.42.99"
client = NatNetClient(address, address, target, data_port=port, use_multicast=bool(group))
frames, models = [], []
# The client reads what was on its way while the version changed with the wrong one: such frames
# have no bodies, and descriptions are lost.
keep = lambda frame: frames.append(frame) if len(frame.rigid_bodies) == 2 or not wish else None
client.on_data_frame_received_event.handlers.append(keep)
client.on_data_description_received_event.handlers.append(models.append)
with client:
    if wish:
        client.protocol_version = Version.from_str(wish)
    client.request_modeldef()
    client.run_async()
    deadline = time.monotonic() + 20.0
    while (len(frames) < 200 or not models) and time.monotonic() < deadline:
        time.sleep(0.1)
        if not models:
            client.request_modeldef()
    client.stop_async()
names = {body.id_num: body.name for body in models[-1].rigid_bodies}
rows = []
for frame in frames:
    body, lost = frame.rigid_bodies
    x, y, z, w = body.rot
    stamps = frame.suffix.stamp_camera_mid_exposure, frame.suffix.stamp_transmit
    rows.append([*body.pos, w, x, y, z, body.tracking_valid, lost.tracking_valid, *stamps])
version = str(client.protocol_version.truncate(2))
print(json.dumps({"version": version, "names": names, "rows": rows}))
"""


def group_of(address: str) -> str:
    return "239" + address[3:]


def data_port_of(address: str) -> int:
    """Return a port of one's own: some clients hear all groups joined on their port."""
    _, a, b, c = map(int, address.split("."))
    return 20000 + (a * 250 * 250 + b * 250 + c) % 20000


@asynccontextmanager
async def served(address: str, **options: Any) -> AsyncIterator[NatNetServer]:
    """Serve 100 frames a second; the drone's x counts the frames in millimetres."""
    server = NatNetServer(address, **options)
    async with fed(server):
        yield server


class Client(asyncio.DatagramProtocol):
    """A bare client that keeps what it hears."""

    def __init__(self, version: NatNetVersion = (3, 1)) -> None:
        self.version = version
        self.heard: list[NatNetMessage] = []

    @classmethod
    async def to(cls, address: str, version: NatNetVersion = (3, 1)) -> Client:
        loop = asyncio.get_running_loop()
        client = cls(version)
        client.transport, _ = await loop.create_datagram_endpoint(
            lambda: client, remote_addr=(address, 1510)
        )
        return client

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        self.heard.append(decode_natnet(data, self.version))

    def say(self, item: NatNetMessage) -> None:
        self.transport.sendto(encode_natnet(item, self.version))

    async def hears(self, item: NatNetMessage) -> None:
        await until(lambda: item in self.heard)


@pytest.mark.parametrize("y_up", [False, True])
@pytest.mark.parametrize("version", [(3, 1), (4, 1)])
async def test_motioncapture_reads_our_poses_frame_by_frame(
    loopback: str, version: NatNetVersion, y_up: bool
) -> None:
    pytest.importorskip("motioncapture")
    group, port = group_of(loopback), data_port_of(loopback)
    async with served(loopback, version=version, group=group, data_port=port, y_up=y_up):
        answer = await stranger(MOTIONCAPTURE, loopback)
    assert answer["names"] == ["ardrone"]
    steps = [1000.0 * (b[0] - a[0]) for a, b in pairwise(answer["rows"])]
    assert sum(round(step) == 1 for step in steps) >= 0.9 * len(steps), (
        "frames were lost on the way"
    )
    _, y, z = DRONE.position
    up, turn = (
        ((z, -y), (cos(YAW / 2), 0.0, sin(YAW / 2), 0.0))
        if y_up
        else ((y, z), (cos(YAW / 2), 0.0, 0.0, sin(YAW / 2)))
    )
    for _, second, third, *rotation in answer["rows"]:
        assert (second, third) == pytest.approx(up, abs=1e-6)
        assert rotation == pytest.approx(turn, abs=1e-6)


@pytest.mark.parametrize(
    ("version", "wish", "multicast"),
    [
        ((3, 1), "", False),
        ((3, 1), "", True),
        ((4, 1), "", False),
        ((4, 1), "", True),
        ((4, 1), "3.1", False),
    ],
)
async def test_natnet_of_pypi_reads_our_poses_and_stamps(
    loopback: str, version: NatNetVersion, wish: str, multicast: bool
) -> None:
    pytest.importorskip("natnet")
    group, port = (group_of(loopback) if multicast else ""), data_port_of(loopback)
    async with served(loopback, version=version, group=group, data_port=port, y_up=False) as server:
        answer = await stranger(NATNET, loopback, group, str(port), wish)
        assert server.malformed == 0
    assert answer["version"] == (wish or f"{version[0]}.{version[1]}")
    assert answer["names"] == {"1": "ardrone", "2": "visitor"}
    assert len(answer["rows"]) >= 200
    steps = [1000.0 * (b[0] - a[0]) for a, b in pairwise(answer["rows"])]
    assert sum(round(step) == 1 for step in steps) >= 0.9 * len(steps), (
        "frames were lost on the way"
    )
    for x, y, z, w, i, j, k, seen, lost_seen, exposed, sent in answer["rows"]:
        assert (y, z) == pytest.approx(DRONE.position[1:], abs=1e-6)
        assert (w, i, j, k) == pytest.approx((cos(YAW / 2), 0.0, 0.0, sin(YAW / 2)), abs=1e-6)
        assert (seen, lost_seen) == (True, False)
        assert exposed == pytest.approx(1e7 * 0.01 * (1000.0 * x), abs=100)
        assert sent - exposed == pytest.approx(0.02 * 1e7, abs=2)


async def test_a_client_learns_who_serves_and_what_is_tracked(loopback: str) -> None:
    async with served(loopback) as server:
        client = await Client.to(loopback)
        client.say(Connect())
        await until(lambda: bool(client.heard))
        info = client.heard[0]
        assert isinstance(info, ServerInfo)
        assert (info.version, info.clock_hz, info.multicast) == ((3, 1, 0, 0), 10_000_000, False)
        client.say(Discovery())
        await until(lambda: client.heard.count(info) == 2)
        client.say(EchoRequest(77))
        await until(lambda: any(isinstance(item, EchoResponse) for item in client.heard))
        (echo,) = (item for item in client.heard if isinstance(item, EchoResponse))
        assert echo.client_time == 77 and echo.server_time > 0
        client.say(RequestModelDef())
        await client.hears(
            ModelDef((RigidBodyDescription(1, "ardrone"), RigidBodyDescription(2, "visitor")))
        )
        await until(lambda: isinstance(client.heard[-1], NatNetFrame))
        client.say(Disconnect())
        await until(lambda: server.clients == 0)
        client.transport.close()


async def test_a_client_that_falls_silent_gets_no_more_frames(
    loopback: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(natnet_server, "_CLIENT_TIMEOUT", 0.3)
    async with served(loopback) as server:
        silent, alive = await Client.to(loopback), await Client.to(loopback)
        for client in (silent, alive):
            client.say(Connect())
        await until(lambda: server.clients == 2)
        for _ in range(8):
            alive.say(KeepAlive())
            await asyncio.sleep(0.05)
        assert server.clients == 1
        silent.heard.clear()
        alive.heard.clear()
        await until(lambda: bool(alive.heard))
        assert silent.heard == []
        for client in (silent, alive):
            client.transport.close()


async def test_only_a_server_of_4_lets_its_clients_choose(loopback: str) -> None:
    for version, wish, answer in (((3, 1), (4, 1), 1), ((4, 1), (3, 1), 0)):
        server = NatNetServer(loopback, version=version)
        await server.start()
        client = await Client.to(loopback, version)
        client.say(Connect(wish))
        await until(lambda client=client: bool(client.heard))  # type: ignore[misc]
        info = client.heard[0]
        assert isinstance(info, ServerInfo)
        assert info.version[:2] == (version if answer else wish)
        client.say(CommandRequest("Bitstream,3.0"))
        await client.hears(CommandResponse(answer))
        client.say(CommandRequest("Bitstream,9.9"))
        await client.hears(CommandResponse(1))
        client.say(CommandRequest("FrameRate"))
        await client.hears(Unrecognized())
        client.transport.close()
        await server.stop()


@pytest.mark.parametrize(
    "garbage", [b"GET / HTTP/1.1\r\n\r\n", b"\x07\0\xff\xff", b"\x01\0\x04\0\0\0\0\0", b"x"]
)
async def test_garbage_is_counted_and_delays_nobody(loopback: str, garbage: bytes) -> None:
    async with served(loopback) as server:
        client = await Client.to(loopback)
        client.say(Connect())
        client.transport.sendto(garbage)
        await until(lambda: server.malformed == 1)
        client.heard.clear()
        await until(lambda: bool(client.heard))
        client.transport.close()


async def test_a_client_that_does_not_read_loses_frames_and_delays_nobody(loopback: str) -> None:
    server = NatNetServer(loopback)
    await server.start()
    slow = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    slow.connect((loopback, 1510))
    slow.send(encode_natnet(Connect(), (3, 1)))
    client = await Client.to(loopback)
    client.say(Connect())
    await until(lambda: server.clients == 2)
    for number in range(1, 1000):
        server.publish(frame(number))
        await until(lambda number=number: getattr(client.heard[-1], "number", 0) == number)  # type: ignore[misc]
    slow.close()
    client.transport.close()
    await server.stop()


async def test_too_many_clients_are_not_served(loopback: str) -> None:
    async with served(loopback) as server:
        clients = [await Client.to(loopback) for _ in range(40)]
        for client in clients:
            client.say(Connect())
        await until(lambda: server.clients == 32)
        for client in clients:
            client.transport.close()


async def test_a_taken_port_is_named(loopback: str) -> None:
    async with served(loopback):
        with pytest.raises(LinkError, match=f"{loopback}:1510"):
            await NatNetServer(loopback).start()


def test_a_body_out_of_sight_keeps_its_place_with_the_tracking_bit_cleared() -> None:
    drone, visitor = natnet_frame(frame(1), {"ardrone": 1, "visitor": 2}, y_up=True).bodies
    assert (drone.tracked, visitor.tracked) == (True, False)
    assert drone.position == (1.5, 0.75, 2.25)
