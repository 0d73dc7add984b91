"""Our Vicon client against our server, and against servers that misbehave."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from itertools import pairwise

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tracking_bench import Bench

from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.tracking.vicon import ViconTracker
from housefly.twin.mocap.vicon_server import ViconServer
from housefly.wires.vicon import ObjectEnums, ViconPing, encode_packet

pytestmark = pytest.mark.wire

feed, running, until = Bench.feed, Bench.running, Bench.until
DRONE, VISITOR, LATENCY = Bench.DRONE, Bench.VISITOR, Bench.LATENCY


def config(address: str) -> TrackingConfig:
    return TrackingConfig(address=address)


@pytest.mark.parametrize("rate_hz", [100.0, 30.0, 10.0])
async def test_poses_arrive_at_every_rate_with_their_capture_times(
    loopback: str, rate_hz: float
) -> None:
    server = ViconServer(loopback, 8010, rate_hz)
    await server.start()
    tracker = ViconTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with running(feed(server, rate_hz), tracker.run(frames.append)):
        await until(lambda: len(frames) >= 15)
        assert tracker.connected
        assert tracker.problem == ""
    await server.stop()
    for drone, visitor in frames:
        assert (drone.body, visitor.body) == ("ardrone", "visitor")
        assert drone.pose.position == pytest.approx(DRONE.position)
        assert drone.pose.orientation == pytest.approx(DRONE.orientation)
        assert drone.captured_at <= drone.received_at - LATENCY + 1e-9
    steps = [(b[0].captured_at - a[0].captured_at) * rate_hz for a, b in pairwise(frames[5:])]
    assert sorted(steps)[len(steps) // 2] == pytest.approx(1.0, abs=0.05)


async def test_a_body_that_the_cameras_lost_is_not_in_the_frame(loopback: str) -> None:
    server = ViconServer(loopback)
    await server.start()
    tracker = ViconTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with running(feed(server, 100.0, drone=None), tracker.run(frames.append)):
        await until(lambda: len(frames) >= 3)
    await server.stop()
    assert {seen.body for frame in frames for seen in frame} == {"visitor"}


async def test_the_client_comes_back_when_the_server_does(loopback: str) -> None:
    tracker = ViconTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with running(tracker.run(frames.append)):
        await until(lambda: "nobody answers" in tracker.problem)
        assert (
            tracker.problem
            == f"nobody answers at {loopback}:8010; is the simulated room running, and does it"
            " stream?"
        )
        for _ in range(2):
            frames.clear()
            server = ViconServer(loopback)
            await server.start()
            async with running(feed(server, 100.0)):
                await until(lambda: len(frames) >= 3)
                assert tracker.problem == ""
            await server.stop()
            await until(lambda: tracker.problem != "")
        assert tracker.counts.backward == 0


async def test_a_server_without_frames_is_named(loopback: str) -> None:
    server = ViconServer(loopback)
    await server.start()
    tracker = ViconTracker(config(loopback))
    async with running(tracker.run(lambda frame: None)):
        await until(lambda: "nothing new arrives" in tracker.problem)
        assert not tracker.connected
    await server.stop()


async def test_a_server_of_another_protocol_is_named_and_asked_again(loopback: str) -> None:
    async def speak_http(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(b"HTTP/1.1 400 Bad Request\r\n\r\n")
        await reader.read()
        writer.close()

    stranger = await asyncio.start_server(speak_http, loopback, 8010)
    tracker = ViconTracker(config(loopback))
    async with running(tracker.run(lambda frame: None)):
        await until(lambda: tracker.malformed >= 2)
        assert "does not speak Vicon DataStream" in tracker.problem
    stranger.close()


@pytest.mark.parametrize(
    ("first", "words"),
    [
        (encode_packet([ObjectEnums(frozenset({1, 2, 5}))]),
         "is of an older version: it offers the objects 1, 2, 5; Housefly also needs 9"),
        (encode_packet([ViconPing(1)]), "does not begin with what it offers: its version"),
        (b"", "does not begin with what it offers, as Vicon DataStream does: is that its port"),
    ],
)  # fmt: skip
async def test_a_server_of_an_older_version_is_said_to_be_one(
    loopback: str, monkeypatch: pytest.MonkeyPatch, first: bytes, words: str
) -> None:
    monkeypatch.setattr(ViconTracker, "SILENCE_TIMEOUT", 0.2)

    async def greet(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(first)
        await reader.read()
        writer.close()

    old = await asyncio.start_server(greet, loopback, 8010)
    tracker = ViconTracker(config(loopback))
    async with running(tracker.run(lambda frame: None)):
        await until(lambda: words in tracker.problem)
    old.close()


@settings(
    max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.lists(st.binary(max_size=200), max_size=4), st.booleans())
async def test_garbage_never_ends_the_client(
    loopback: str, chunks: list[bytes], with_header: bool
) -> None:
    async def babble(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        for chunk in chunks:
            header = b"\x01\x00\x2b\x1a" + len(chunk).to_bytes(4, "little") if with_header else b""
            writer.write(header + chunk)
        writer.close()

    server = await asyncio.start_server(babble, loopback, 8010)
    task = asyncio.create_task(ViconTracker(config(loopback)).run(lambda frame: None))
    await asyncio.sleep(0.02)
    assert not task.done()
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
    server.close()
    await server.wait_closed()


async def test_a_cancelled_client_closes_its_connection(loopback: str) -> None:
    server = ViconServer(loopback)
    await server.start()
    async with running(ViconTracker(config(loopback)).run(lambda frame: None)):
        await until(lambda: server.clients == 1)
    await until(lambda: server.clients == 0)
    await server.stop()
