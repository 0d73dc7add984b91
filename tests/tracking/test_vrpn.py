"""Our VRPN client against our server, and against servers that misbehave."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.tracking import vrpn
from housefly.tracking.vrpn import VrpnTracker
from housefly.twin.mocap.vrpn_server import VrpnServer
from housefly.wires.vrpn import (
    COOKIE_SIZE,
    POSE_TYPE,
    SENDER_DESCRIPTION,
    TYPE_DESCRIPTION,
    TrackerPose,
    VrpnMessage,
    decode_lob,
    description_message,
    encode_cookie,
    encode_message,
    encode_pose,
)

pytestmark = pytest.mark.wire

NAMES = encode_message(description_message(TYPE_DESCRIPTION, 3, POSE_TYPE)) + encode_message(
    description_message(SENDER_DESCRIPTION, 5, "ardrone")
)
HERE = TrackerPose(0, (1.0, 2.0, 3.0), (1.0, 0.0, 0.0, 0.0))
Say = Callable[[asyncio.StreamWriter], Awaitable[None]]


def config(address: str, transport: str = "tcp", up_axis: str = "auto") -> TrackingConfig:
    return TrackingConfig(kind="vrpn", address=address, vrpn_transport=transport, up_axis=up_axis)


def told(stamp: int, pose: TrackerPose = HERE, sender: int = 5) -> bytes:
    return encode_message(VrpnMessage(3, sender, stamp, encode_pose(pose)))


@asynccontextmanager
async def saying(address: str, say: Say) -> AsyncIterator[list[int]]:
    """Serve cookie and names, then what the test says; yields a list that grows with each
    connection.
    """
    connections: list[int] = []

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        connections.append(len(connections))
        writer.write(encode_cookie())
        with suppress(asyncio.IncompleteReadError, OSError):
            await reader.readexactly(COOKIE_SIZE)
            writer.write(NAMES)
            await say(writer)
        writer.close()

    server = await asyncio.start_server(serve, address, 3883)
    try:
        yield connections
    finally:
        server.close()


@pytest.mark.parametrize("transport", ["tcp", "udp"])
@pytest.mark.parametrize("rate_hz", [100.0, 10.0])
async def test_poses_arrive_with_their_capture_times(
    loopback: str, bench: Any, transport: str, rate_hz: float
) -> None:
    server = VrpnServer(loopback)
    await server.start()
    tracker = VrpnTracker(config(loopback, transport))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(bench.feed(server, rate_hz), tracker.run(frames.append)):
        await bench.until(lambda: len(frames) >= 15)
        assert tracker.connected
        assert tracker.problem == ""
        assert server.clients == 1
    await bench.until(lambda: server.clients == 0)
    await server.stop()
    for drone, visitor in frames:
        assert (drone.body, visitor.body) == ("ardrone", "visitor")
        assert drone.pose.position == pytest.approx(bench.DRONE.position)
        assert drone.pose.orientation == pytest.approx(bench.DRONE.orientation)
        assert drone.captured_at <= drone.received_at - 0.02 + 1e-6
    steps = [(b[0].captured_at - a[0].captured_at) * rate_hz for a, b in pairwise(frames[5:])]
    assert sorted(steps)[len(steps) // 2] == pytest.approx(1.0, abs=0.05)


@pytest.mark.parametrize("transport", ["tcp", "udp"])
async def test_the_genuine_server_is_read(
    loopback: str, bench: Any, tmp_path: Path, transport: str
) -> None:
    program = shutil.which("vrpn_server")
    if program is None:
        pytest.skip("vrpn_server (github.com/vrpn/vrpn) is not installed")
    settings_file = tmp_path / "vrpn.cfg"
    settings_file.write_text(
        "vrpn_Tracker_NULL Still 2 100.0\nvrpn_Tracker_Spin Spinning 1 100.0 0 0 1 0.5\n"
    )
    server = await asyncio.create_subprocess_exec(
        program, "-f", str(settings_file), "-NIC", loopback, "3883"
    )
    tracker = VrpnTracker(config(loopback, transport))
    frames: list[tuple[Sighting, ...]] = []
    try:
        async with bench.running(tracker.run(frames.append)):
            await bench.until(lambda: len(frames) >= 300)
    finally:
        server.kill()
        await server.wait()
    seen = [sighting for frame in frames for sighting in frame]
    assert {sighting.body for sighting in seen} == {"Still", "Still/1", "Spinning"}
    assert len({sighting.pose.yaw for sighting in seen if sighting.body == "Spinning"}) > 50
    times = [sighting.captured_at for sighting in seen if sighting.body == "Still"]
    assert (len(times) - 1) / (times[-1] - times[0]) == pytest.approx(100.0, rel=0.2)
    assert (tracker.malformed, tracker.counts.unnamed) == (0, 0)


async def test_both_axes_can_point_up(loopback: str, bench: Any) -> None:
    server = VrpnServer(loopback, y_up=True)
    await server.start()
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(
        bench.feed(server), VrpnTracker(config(loopback, up_axis="y")).run(frames.append)
    ):
        await bench.until(lambda: bool(frames))
    await server.stop()
    assert frames[-1][0].pose.position == pytest.approx(bench.DRONE.position)


async def test_a_stranger_who_connects_first_is_not_taken_for_the_server(
    loopback: str, bench: Any
) -> None:
    asked: asyncio.Queue[tuple[str, int]] = asyncio.Queue()
    server, stranger = loopback, f"127.251.{loopback.split('.', 2)[2]}"

    class Server(asyncio.DatagramProtocol):
        def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
            asked.put_nowait(decode_lob(data))

    async def tell(host: str, where: tuple[str, int], pose: TrackerPose) -> None:
        with suppress(OSError):
            _, writer = await asyncio.open_connection(*where, local_addr=(host, 0))
            writer.write(encode_cookie() + NAMES)
            for _ in range(20):
                writer.write(told(1_000_000, pose))
                await writer.drain()
                await asyncio.sleep(0.02)
            writer.close()

    loop = asyncio.get_running_loop()
    listening, _ = await loop.create_datagram_endpoint(Server, local_addr=(server, 3883))
    tracker = VrpnTracker(config(loopback, "udp"))
    frames: list[tuple[Sighting, ...]] = []
    forged = TrackerPose(0, (9.0, 9.0, 9.0), (1.0, 0.0, 0.0, 0.0))
    async with bench.running(tracker.run(frames.append)):
        where = await asyncio.wait_for(asked.get(), 5.0)
        await tell(stranger, where, forged)
        assert frames == [] and not tracker.connected
        await tell(server, where, HERE)
        assert frames
    assert {abs(seen.pose.position[0]) for frame in frames for seen in frame} <= {1.0, 2.0, 3.0}
    listening.close()


async def test_a_body_that_the_cameras_lost_is_not_in_the_frame(loopback: str, bench: Any) -> None:
    server = VrpnServer(loopback)
    await server.start()
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(
        bench.feed(server, drone=None), VrpnTracker(config(loopback)).run(frames.append)
    ):
        await bench.until(lambda: len(frames) >= 5)
    await server.stop()
    assert {seen.body for frame in frames for seen in frame} == {"visitor"}


async def test_a_clock_that_leaps_ahead_and_back_costs_no_pose_and_makes_none_of_the_future(
    loopback: str, bench: Any
) -> None:
    server = VrpnServer(loopback)
    await server.start()
    tracker = VrpnTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        for ahead in (0.0, 7200.0, 0.0):
            before = len(frames)
            async with bench.running(bench.feed(server, ahead=ahead)):
                await bench.until(lambda before=before: len(frames) >= before + 20)  # type: ignore[misc]
    await server.stop()
    assert tracker.counts.jumps >= 2
    assert all(0 <= seen.received_at - seen.captured_at < 0.5 for frame in frames for seen in frame)


@pytest.mark.parametrize(
    ("transport", "words"), [("tcp", "nobody answers"), ("udp", "does not connect back")]
)
async def test_the_client_comes_back_when_the_server_does(
    loopback: str, bench: Any, transport: str, words: str
) -> None:
    tracker = VrpnTracker(config(loopback, transport))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: words in tracker.problem)
        for _ in range(2):
            frames.clear()
            server = VrpnServer(loopback)
            await server.start()
            async with bench.running(bench.feed(server)):
                await bench.until(lambda: len(frames) >= 3)
                assert tracker.problem == ""
            await server.stop()
            await bench.until(lambda: tracker.problem != "")


async def test_a_server_that_freezes_is_named_and_connected_to_anew(
    loopback: str, bench: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(VrpnTracker, "SILENCE_TIMEOUT", 1.5)

    async def freeze(writer: asyncio.StreamWriter) -> None:
        writer.write(told(1_000_000))
        await asyncio.sleep(60.0)

    tracker = VrpnTracker(config(loopback))
    async with (
        saying(loopback, freeze) as connections,
        bench.running(tracker.run(lambda frame: None)),
    ):
        await bench.until(lambda: "nothing new arrives" in tracker.problem)
        assert not tracker.connected
        await bench.until(lambda: "silent" in tracker.problem)
        await bench.until(lambda: len(connections) >= 2)


async def test_a_server_without_a_cookie_is_named(
    loopback: str, bench: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(vrpn, "VRPN_TIMEOUT", 0.3)

    async def mute(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.read()
        writer.close()

    server = await asyncio.start_server(mute, loopback, 3883)
    tracker = VrpnTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: "no VRPN cookie" in tracker.problem)
    server.close()


async def test_a_connection_lost_in_the_middle_of_a_message_is_made_anew(
    loopback: str, bench: Any
) -> None:
    async def cut(writer: asyncio.StreamWriter) -> None:
        writer.write(told(1_000_000) + told(2_000_000)[:40])
        await writer.drain()

    tracker = VrpnTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with saying(loopback, cut) as connections, bench.running(tracker.run(frames.append)):
        await bench.until(lambda: len(connections) >= 3)
        await bench.until(lambda: "lost" in tracker.problem)
    assert len(frames) >= 2


async def test_a_version_that_we_do_not_speak_is_named(loopback: str, bench: Any) -> None:
    async def speak(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(b"vrpn: ver. 08.01  0".ljust(COOKIE_SIZE, b"\0"))
        await reader.read()
        writer.close()

    server = await asyncio.start_server(speak, loopback, 3883)
    tracker = VrpnTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: "speaks VRPN 08.01; Housefly speaks 07.x" in tracker.problem)
    server.close()


async def test_a_server_of_another_protocol_is_named_and_asked_again(
    loopback: str, bench: Any
) -> None:
    async def speak_http(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(b"HTTP/1.1 400 Bad Request\r\n\r\n")
        await reader.read()
        writer.close()

    stranger = await asyncio.start_server(speak_http, loopback, 3883)
    tracker = VrpnTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: tracker.malformed >= 2)
        assert "does not speak VRPN" in tracker.problem
    stranger.close()


async def test_a_flood_is_cut_to_what_a_tracking_system_can_send_and_named(
    loopback: str, bench: Any
) -> None:
    async def flood(writer: asyncio.StreamWriter) -> None:
        for number in range(20_000):
            writer.write(told(1000 * number))
            if number % 100 == 0:
                await writer.drain()
        await asyncio.sleep(60.0)

    tracker = VrpnTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with saying(loopback, flood), bench.running(tracker.run(frames.append)):
        await bench.until(lambda: tracker.counts.flooded > 1000)
        assert "more than 2000 frames a second" in tracker.problem
    assert tracker.counts.frames < 20_000


async def test_sensors_beyond_the_first_are_bodies_of_their_own(loopback: str, bench: Any) -> None:
    async def speak(writer: asyncio.StreamWriter) -> None:
        for sensor in (0, 2, 5000, -1):
            writer.write(told(1_000_000, TrackerPose(sensor, HERE.position, HERE.orientation)))
        writer.write(told(1_000_000, sender=77))
        writer.write(told(1_000_000, TrackerPose(1, (float("nan"), 0.0, 0.0), HERE.orientation)))
        writer.write(told(900_000) + told(1_000_000))
        await asyncio.sleep(60.0)

    tracker = VrpnTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with saying(loopback, speak), bench.running(tracker.run(frames.append)):
        await bench.until(lambda: tracker.counts.repeated == 1)
    assert [seen.body for frame in frames for seen in frame] == ["ardrone", "ardrone/2"]
    counts = tracker.counts
    assert (counts.unnamed, counts.refused, counts.backward) == (3, 1, 1)


@settings(
    max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.lists(st.binary(max_size=200), max_size=4), st.booleans())
async def test_garbage_never_ends_the_client(
    loopback: str, chunks: list[bytes], with_cookie: bool
) -> None:
    async def babble(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        for chunk in [encode_cookie() + NAMES if with_cookie else b"", *chunks]:
            writer.write(chunk)
        writer.close()

    server = await asyncio.start_server(babble, loopback, 3883)
    task = asyncio.create_task(VrpnTracker(config(loopback)).run(lambda frame: None))
    await asyncio.sleep(0.02)
    assert not task.done()
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
    server.close()
    await server.wait_closed()
