"""Our NatNet client against our server, and against servers that misbehave."""

from __future__ import annotations

import asyncio
import socket
import struct
from contextlib import suppress
from functools import partial
from itertools import count, pairwise
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.tracking import natnet_session
from housefly.tracking.natnet import NatNetTracker
from housefly.tracking.rate_limit import FrameLimiter
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.natnet_server import NatNetServer
from housefly.wires.natnet import (
    CommandRequest,
    CommandResponse,
    Connect,
    KeepAlive,
    ModelDef,
    NatNetFrame,
    NatNetMessage,
    NatNetVersion,
    RequestModelDef,
    RigidBody,
    RigidBodyDescription,
    ServerInfo,
    decode_natnet,
    encode_natnet,
)

pytestmark = pytest.mark.wire

TICKS = 1_000_000
HERE = RigidBody(7, (1.0, 2.0, 3.0), (1.0, 0.0, 0.0, 0.0))


def config(address: str, up_axis: str = "auto") -> TrackingConfig:
    return TrackingConfig(kind="natnet", address=address, up_axis=up_axis)


def group_of(address: str) -> str:
    return "239" + address[3:]


class Motive(asyncio.DatagramProtocol):
    """A server whose every word is decided by the test."""

    def __init__(
        self,
        version: NatNetVersion = (3, 1),
        reply: dict[type[NatNetMessage], bytes | None] | None = None,
    ) -> None:
        self.heard: list[NatNetMessage] = []
        self.client: tuple[str, int] | None = None
        info = ServerInfo("Motive", (3, 1, 0, 0), (*version, 0, 0), TICKS, 1511, False, "0.0.0.0")
        self.replies: dict[type[NatNetMessage], bytes | None] = {
            Connect: encode_natnet(info, version),
            RequestModelDef: encode_natnet(
                ModelDef((RigidBodyDescription(7, "ardrone"),)), version
            ),
            CommandRequest: encode_natnet(CommandResponse(0), version),
        }
        self.replies |= reply or {}

    async def start(self, address: str) -> None:
        loop = asyncio.get_running_loop()
        self.transport, _ = await loop.create_datagram_endpoint(
            lambda: self, local_addr=(address, 1510)
        )

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        item = decode_natnet(data, (3, 1))
        self.heard.append(item)
        self.client = addr
        reply = self.replies.get(type(item))
        if reply is not None:
            self.transport.sendto(reply, addr)

    def say(self, datagram: bytes) -> None:
        assert self.client is not None
        self.transport.sendto(datagram, self.client)

    def tell(self, *frames: NatNetFrame, version: NatNetVersion = (3, 1)) -> None:
        for frame in frames:
            self.say(encode_natnet(frame, version))


@pytest.mark.parametrize("multicast", [False, True])
@pytest.mark.parametrize("version", [(3, 1), (4, 1)])
@pytest.mark.parametrize("rate_hz", [100.0, 10.0])
async def test_poses_arrive_with_their_capture_times(
    loopback: str, bench: Any, rate_hz: float, version: NatNetVersion, multicast: bool
) -> None:
    server = NatNetServer(loopback, version=version, group=group_of(loopback) if multicast else "")
    await server.start()
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(bench.feed(server, rate_hz), tracker.run(frames.append)):
        await bench.until(lambda: len([frame for frame in frames if frame]) >= 15)
        assert tracker.connected
        assert tracker.problem == ""
        assert server.clients == (0 if multicast else 1)
    await server.stop()
    named = [frame for frame in frames if frame]
    for drone, visitor in named:
        assert (drone.body, visitor.body) == ("ardrone", "visitor")
        assert drone.pose.position == pytest.approx(bench.DRONE.position, abs=1e-6)
        assert drone.pose.orientation == pytest.approx(bench.DRONE.orientation, abs=1e-6)
        assert visitor.pose.position == pytest.approx(bench.VISITOR.position, abs=1e-6)
        assert drone.captured_at <= drone.received_at - bench.LATENCY + 1e-6
    steps = [(b[0].captured_at - a[0].captured_at) * rate_hz for a, b in pairwise(named[5:])]
    assert sorted(steps)[len(steps) // 2] == pytest.approx(1.0, abs=0.05)
    assert tracker.counts.malformed == 0


async def test_a_server_of_an_older_version_is_named_with_it_and_with_what_we_read(
    loopback: str, bench: Any
) -> None:
    old = struct.pack("<HH256s8B", 1, 264, b"Motive", 1, 10, 0, 0, 2, 9, 0, 0)
    motive = Motive(reply={Connect: old})
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: "speaks" in tracker.problem)
        assert tracker.problem.startswith(
            f"Motive 1.10 at {loopback}:1510 speaks NatNet 2.9; Housefly reads 3.0 to 4.x"
        )
    motive.transport.close()


@pytest.mark.parametrize("up_axis", ["y", "z"])
async def test_both_axes_can_point_up(loopback: str, bench: Any, up_axis: str) -> None:
    server = NatNetServer(loopback, y_up=up_axis == "y")
    await server.start()
    tracker = NatNetTracker(config(loopback, up_axis))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(bench.feed(server), tracker.run(frames.append)):
        await bench.until(lambda: bool(frames) and bool(frames[-1]))
    await server.stop()
    assert frames[-1][0].pose.position == pytest.approx(bench.DRONE.position, abs=1e-6)


async def test_a_body_that_the_cameras_lost_is_not_in_the_frame(loopback: str, bench: Any) -> None:
    server = NatNetServer(loopback)
    await server.start()
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(bench.feed(server, drone=None), tracker.run(frames.append)):
        await bench.until(lambda: len(frames) >= 10 and bool(frames[-1]))
    await server.stop()
    assert {seen.body for frame in frames for seen in frame} == {"visitor"}


@pytest.mark.parametrize("ahead", [3600.0, 0.0])
async def test_a_server_whose_clock_is_ahead_makes_no_poses_of_the_future(
    loopback: str, bench: Any, ahead: float
) -> None:
    server = NatNetServer(loopback)
    await server.start()
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(bench.feed(server, ahead=ahead), tracker.run(frames.append)):
        await bench.until(lambda: len(frames) >= 30)
    await server.stop()
    seen = [sighting for frame in frames for sighting in frame]
    assert all(
        bench.LATENCY - 1e-6 <= sighting.received_at - sighting.captured_at < 0.5
        for sighting in seen
    )


async def test_a_clock_that_leaps_costs_no_frame(loopback: str, bench: Any) -> None:
    server = NatNetServer(loopback)
    await server.start()
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        for ahead in (0.0, 7200.0, 0.0):
            before = len(frames)
            async with bench.running(bench.feed(server, ahead=ahead)):
                await bench.until(lambda before=before: len(frames) >= before + 20)  # type: ignore[misc]
    await server.stop()
    assert tracker.counts.jumps >= 2
    seen = [sighting for frame in frames for sighting in frame]
    assert all(0 <= sighting.received_at - sighting.captured_at < 0.5 for sighting in seen)


async def test_frames_of_a_stranger_are_not_believed(loopback: str, bench: Any) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    forged = RigidBody(7, (9.0, 9.0, 9.0), (1.0, 0.0, 0.0, 0.0))
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        assert motive.client is not None
        for number in count(1):  # the first come before it knows which bodies there are
            at = number * TICKS
            motive.tell(NatNetFrame(number, (HERE,), exposed=at, sent=at + 10_000))
            await asyncio.sleep(0.05)
            if any(frames):
                break
        for host in ("127.0.0.1", loopback):  # another machine; another port of the server's
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
                stranger.bind((host, 0))
                for serial in range(1000, 1020):
                    at = serial * TICKS
                    frame = NatNetFrame(serial, (forged,), exposed=at, sent=at + 10_000)
                    stranger.sendto(encode_natnet(frame, (3, 1)), motive.client)
        await asyncio.sleep(0.1)
        (here,) = {seen.pose.position for frame in frames for seen in frame}
        at = (number + 1) * TICKS
        motive.tell(NatNetFrame(number + 1, (forged,), exposed=at, sent=at + 10_000))
        # the attack itself works from the server
        await bench.until(lambda: frames[-1] != () and frames[-1][0].pose.position != here)
    motive.transport.close()


async def test_a_server_that_sends_before_it_exposes_is_counted(loopback: str, bench: Any) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        for number in range(1, 20):
            motive.tell(
                NatNetFrame(number, (HERE,), exposed=TICKS + 10_000 * number, sent=10_000 * number)
            )
            await asyncio.sleep(0.01)
        await bench.until(lambda: len(frames) >= 19)
        assert tracker.counts.misstamped == 19
        assert all(
            seen.captured_at <= seen.received_at - 0.02 + 1e-6 for frame in frames for seen in frame
        )
    motive.transport.close()


async def test_the_client_comes_back_when_the_server_does(loopback: str, bench: Any) -> None:
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: "nobody answers" in tracker.problem)
        assert (
            tracker.problem
            == f"nobody answers at {loopback}:1510; is the simulated room running, and does it"
            " stream?"
        )
        for _ in range(2):
            frames.clear()
            server = NatNetServer(loopback)
            await server.start()
            async with bench.running(bench.feed(server)):
                await bench.until(lambda: len(frames) >= 3)
                assert tracker.problem == ""
            await server.stop()
            await bench.until(lambda: tracker.problem != "")


async def test_a_server_that_freezes_is_named_and_greeted_again(loopback: str, bench: Any) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        motive.tell(NatNetFrame(1, (HERE,), exposed=100, sent=200))
        await bench.until(lambda: len(frames) == 1)
        motive.heard.clear()
        await bench.until(lambda: "nothing new arrives" in tracker.problem)
        assert not tracker.connected
        await bench.until(lambda: Connect((4, 1)) in motive.heard)
        motive.tell(NatNetFrame(2, (HERE,), exposed=2 * TICKS, sent=2 * TICKS + 100))
        await bench.until(lambda: tracker.problem == "" and len(frames) == 2)
    motive.transport.close()


@pytest.mark.parametrize("version", [(3, 1), (4, 1)])
async def test_a_server_that_comes_back_with_other_numbers_is_asked_for_names_again(
    loopback: str, bench: Any, version: NatNetVersion
) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    names: list[str] = []

    async def told_until_named(spoken: NatNetVersion) -> None:
        while not names:
            now = round(asyncio.get_running_loop().time() * TICKS)
            motive.tell(NatNetFrame(1, (HERE,), exposed=now, sent=now + 100), version=spoken)
            await asyncio.sleep(0.02)

    async with bench.running(tracker.run(lambda frame: names.extend(seen.body for seen in frame))):
        await bench.until(lambda: KeepAlive() in motive.heard)
        await told_until_named((3, 1))
        assert set(names) == {"ardrone"}
        motive.heard.clear()
        motive.replies = Motive(version).replies
        motive.replies[RequestModelDef] = encode_natnet(
            ModelDef((RigidBodyDescription(7, "guest"),)), version
        )
        await bench.until(lambda: Connect((4, 1)) in motive.heard)
        names.clear()
        async with asyncio.timeout(20.0):
            await told_until_named(version)
        assert set(names) == {"guest"}
    motive.transport.close()


async def test_a_server_whose_time_stands_still_is_named(loopback: str, bench: Any) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        async with asyncio.timeout(10.0):
            while "time stands still" not in tracker.problem:
                motive.tell(NatNetFrame(1, (HERE,), exposed=100, sent=200))
                await asyncio.sleep(0.05)
    assert tracker.counts.frames == 1
    assert tracker.counts.repeated > 5
    motive.transport.close()


async def test_frames_out_of_order_are_dropped(loopback: str, bench: Any) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        motive.tell(
            *[
                NatNetFrame(n, (HERE,), exposed=10_000 * n, sent=10_000 * n + 100)
                for n in (5, 4, 6, 6)
            ]
        )
        await bench.until(lambda: tracker.counts.repeated == 1)
    assert (tracker.counts.frames, tracker.counts.backward) == (2, 1)
    motive.transport.close()


@pytest.mark.parametrize(("version", "words"), [((2, 10), "NatNet 2.10"), ((5, 0), "NatNet 5.0")])
async def test_a_version_that_nobody_checked_is_refused_in_words(
    loopback: str, bench: Any, version: NatNetVersion, words: str
) -> None:
    motive = Motive(version)
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: words in tracker.problem)
        assert "3.0 to 4.x" in tracker.problem
    motive.transport.close()


@pytest.mark.parametrize(("granted", "version"), [(0, (4, 1)), (1, (4, 3))])
async def test_a_newer_server_is_asked_for_a_version_that_was_checked(
    loopback: str, bench: Any, granted: int, version: NatNetVersion
) -> None:
    motive = Motive((4, 3), {CommandRequest: encode_natnet(CommandResponse(granted), (4, 1))})
    motive.replies[RequestModelDef] = encode_natnet(
        ModelDef((RigidBodyDescription(7, "ardrone"),)), version
    )
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: RequestModelDef() in motive.heard)
        await asyncio.sleep(0.1)
        motive.tell(NatNetFrame(1, (HERE,), exposed=100, sent=200), version=version)
        await bench.until(lambda: len(frames) == 1)
    assert CommandRequest("Bitstream,4.1") in motive.heard
    assert [seen.body for seen in frames[0]] == ["ardrone"]
    motive.transport.close()


async def test_a_multicast_that_does_not_arrive_is_named(loopback: str, bench: Any) -> None:
    info = ServerInfo("Motive", (3, 1, 0, 0), (3, 1, 0, 0), TICKS, 1511, True, group_of(loopback))
    motive = Motive(reply={Connect: encode_natnet(info, (3, 1))})
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: f"multicast group {group_of(loopback)}:1511" in tracker.problem)
        assert "nothing arrives" in tracker.problem
        sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        sender.bind(("127.0.0.1", 0))
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
        sender.sendto(encode_natnet(NatNetFrame(1, ()), (3, 1)), (group_of(loopback), 1511))
        await bench.until(lambda: "set tracking.address to 127.0.0.1" in tracker.problem)
        assert tracker.counts.other_hosts == 1
        sender.close()
    motive.transport.close()


async def test_an_unusable_group_is_named(loopback: str, bench: Any) -> None:
    info = ServerInfo("Motive", (3, 1, 0, 0), (3, 1, 0, 0), TICKS, 1511, True, "10.1.2.3")
    motive = Motive(reply={Connect: encode_natnet(info, (3, 1))})
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(
            lambda: "cannot join the multicast group 10.1.2.3:1511" in tracker.problem
        )
    motive.transport.close()


async def test_a_flood_is_cut_and_named(
    loopback: str, bench: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A busy machine cannot send itself 2000 frames a second.
    monkeypatch.setattr(natnet_session, "FrameLimiter", partial(FrameLimiter, 100))
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        number = 0
        async with asyncio.timeout(30.0):
            while tracker.counts.flooded < 100:
                for _ in range(50):
                    number += 1
                    motive.tell(
                        NatNetFrame(number, (HERE,), exposed=100 * number, sent=100 * number + 50)
                    )
                await asyncio.sleep(0)
        assert "more than 2000 frames a second" in tracker.problem
        await asyncio.sleep(1.1)
        motive.tell(
            NatNetFrame(
                number + 1, (HERE,), exposed=100 * number + TICKS, sent=100 * number + TICKS
            )
        )
        await bench.until(lambda: tracker.problem == "")
    motive.transport.close()


async def test_garbage_between_frames_is_counted_and_harms_nothing(
    loopback: str, bench: Any
) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    whole = encode_natnet(NatNetFrame(1, (HERE,)), (3, 1))
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        for number in range(1, 11):
            motive.say(b"\xff" * number)
            motive.say(whole[: 40 + number])
            motive.tell(
                NatNetFrame(number, (HERE,), exposed=10_000 * number, sent=10_000 * number + 100)
            )
        await bench.until(lambda: len(frames) == 10)
        assert tracker.counts.malformed == 20
        assert tracker.problem == ""
    motive.transport.close()


async def test_a_server_of_another_protocol_is_named_and_asked_again(
    loopback: str, bench: Any
) -> None:
    motive = Motive(reply={Connect: b"HTTP/1.1 400 Bad Request\r\n"})
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: "does not speak NatNet" in tracker.problem)
        motive.heard.clear()
        await bench.until(lambda: bool(motive.heard))
    motive.transport.close()


async def test_a_body_added_later_gets_its_name(loopback: str, bench: Any) -> None:
    server = NatNetServer(loopback)
    await server.start()
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        async with bench.running(bench.feed(server)):
            await bench.until(lambda: any(frames))
        for number in range(200):
            captured = 1e5 + 0.01 * number
            server.publish(
                MocapFrame(number, captured, captured + 0.01, (("guest", bench.VISITOR),))
            )
            if frames[-1] and frames[-1][0].body == "guest":
                break
            await asyncio.sleep(0.02)
        else:
            pytest.fail("the guest was never named")
    await server.stop()


async def test_poses_that_cannot_be_are_refused_one_by_one(loopback: str, bench: Any) -> None:
    motive = Motive()
    await motive.start(loopback)
    tracker = NatNetTracker(config(loopback))
    frames: list[tuple[Sighting, ...]] = []
    bad = (
        RigidBody(7, (float("nan"), 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)),
        RigidBody(7, (1e6, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)),
        RigidBody(7, (1.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)),
        RigidBody(7, (1.0, 0.0, 0.0), (float("inf"), 0.0, 0.0, 0.0)),
    )
    async with bench.running(tracker.run(frames.append)):
        await bench.until(lambda: KeepAlive() in motive.heard)
        motive.tell(NatNetFrame(1, (*bad, HERE), exposed=100, sent=200))
        await bench.until(lambda: len(frames) == 1)
    assert tracker.counts.refused == 4
    assert [seen.pose.position for seen in frames[0]] == [(1.0, -3.0, 2.0)]
    motive.transport.close()


@settings(
    max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.lists(st.binary(max_size=200), max_size=6))
async def test_garbage_never_ends_the_client(loopback: str, chunks: list[bytes]) -> None:
    class Babbler(asyncio.DatagramProtocol):
        def connection_made(self, transport: asyncio.BaseTransport) -> None:
            self.transport = transport

        def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
            for chunk in chunks:
                self.transport.sendto(chunk, addr)  # type: ignore[attr-defined]

    transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
        Babbler, local_addr=(loopback, 1510)
    )
    task = asyncio.create_task(NatNetTracker(config(loopback)).run(lambda frame: None))
    await asyncio.sleep(0.02)
    assert not task.done()
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
    transport.abort()
    await asyncio.sleep(0)
