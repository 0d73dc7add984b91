"""The twin as a process of its own, started, watched and ended from outside."""

from __future__ import annotations

import asyncio
import functools
import signal
import sys
from asyncio.subprocess import PIPE, STDOUT, Process
from collections.abc import AsyncIterator, Awaitable, Callable
from ipaddress import ip_address
from pathlib import Path

import psutil
import pytest

from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.record.truth import read_truth
from housefly.tracking.natnet import NatNetTracker
from housefly.tracking.vicon import ViconTracker
from housefly.tracking.vrpn import VrpnTracker
from housefly.wires.ardrone.navdata import NAVDATA_PORT, decode_navdata
from housefly.wires.ardrone.pave import VIDEO_PORT, PaveFrame, VideoReassembler

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]

Start = Callable[..., Awaitable[Process]]


def site_text(address: str, video: bool = False) -> str:
    where = f'address = "{address}"\n'
    return f"[drone]\n{where}[tracking]\n{where}[twin]\nvideo = {str(video).lower()}\n"


async def line(process: Process) -> str:
    assert process.stdout is not None
    return (await asyncio.wait_for(process.stdout.readline(), 60.0)).decode().strip()


@pytest.fixture
async def start(tmp_path: Path) -> AsyncIterator[Start]:
    started: list[Process] = []

    async def begin(text: str, *options: str) -> Process:
        site = tmp_path / "site.toml"
        site.write_text(text)
        process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-m",
            "housefly.twin.process",
            "--site",
            str(site),
            *options,
            stdout=PIPE,
            stderr=STDOUT,
        )
        started.append(process)
        return process

    yield begin
    for process in started:
        if process.returncode is None:
            process.kill()
        await process.wait()


async def test_it_says_when_it_is_ready_serves_and_ends_on_a_signal(start, loopback):
    process = await start(site_text(loopback))
    assert (
        await line(process)
        == f"twin ready: drone at {loopback}, tracking at {loopback}:{Site().tracking.port},"
        " video off"
    )

    received: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()
    transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
        lambda: _Once(received), remote_addr=(loopback, NAVDATA_PORT)
    )
    transport.sendto(b"\x01")
    decode_navdata(await asyncio.wait_for(received, 5.0))
    transport.close()

    process.send_signal(signal.SIGTERM)
    assert "lost to stalls" in await line(process)
    assert await asyncio.wait_for(process.wait(), 10.0) == 0


async def test_each_drone_of_a_site_answers_at_its_own_address_and_has_its_own_truth(
    start, loopback, tmp_path: Path
):
    anna = loopback
    bert = str(ip_address(anna) + 1)
    process = await start(
        f'[tracking]\naddress = "{anna}"\n[twin]\nvideo = false\n'
        f'[[drones]]\nname = "anna"\naddress = "{anna}"\npad = [10.55, 1.25, 0.0]\n'
        f'[[drones]]\nname = "bert"\naddress = "{bert}"\npad = [8.05, 1.25, 0.0]\n',
        "--truth",
        str(tmp_path / "truth.jsonl"),
    )
    assert f"drones anna at {anna}, bert at {bert}, tracking" in await line(process)
    for address in (anna, bert):
        received: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()
        transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
            functools.partial(_Once, received), remote_addr=(address, NAVDATA_PORT)
        )
        transport.sendto(b"\x01")
        decode_navdata(await asyncio.wait_for(received, 5.0))
        transport.close()
    process.send_signal(signal.SIGTERM)
    assert await asyncio.wait_for(process.wait(), 10.0) == 0
    for name, x in (("anna", 10.55), ("bert", 8.05)):
        truth = read_truth(tmp_path / f"truth-{name}.jsonl")
        assert truth is not None
        assert truth.position[-1][0] == pytest.approx(x, abs=0.05)


class _Once(asyncio.DatagramProtocol):
    def __init__(self, received: asyncio.Future[bytes]) -> None:
        self._received = received

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        if not self._received.done():
            self._received.set_result(data)


async def test_it_poses_as_every_tracking_system_at_once(start, loopback):
    site = site_text(loopback) + 'mocap_wires = ["natnet", "vrpn"]\n'
    process = await start(site)
    assert f"tracking at {loopback}:8010, {loopback}:1510, {loopback}:3883" in await line(process)
    places: dict[str, set[tuple[float, ...]]] = {}
    trackers = [
        kind(TrackingConfig(kind=name, address=loopback), RealClock())
        for name, kind in (
            ("vicon", ViconTracker),
            ("natnet", NatNetTracker),
            ("vrpn", VrpnTracker),
        )
    ]

    def sink(name: str) -> Callable[[tuple[Sighting, ...]], None]:
        def take(frame: tuple[Sighting, ...]) -> None:
            seen = {sighting.body: sighting.pose for sighting in frame}
            if "ardrone" in seen:
                places.setdefault(name, set()).add(
                    tuple(round(value, 4) for value in seen["ardrone"].position)
                )

        return take

    tasks = [asyncio.create_task(tracker.run(sink(type(tracker).__name__))) for tracker in trackers]
    for _ in range(200):
        await asyncio.sleep(0.05)
        if len(places) == 3 and len(set.intersection(*places.values())) >= 20:
            break
    else:
        pytest.fail(f"the three do not agree: {[tracker.problem for tracker in trackers]}")
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)


async def test_a_signal_makes_the_visitor_leave_and_the_tracking_sees_it(start, loopback):
    process = await start(site_text(loopback))
    await line(process)
    seen: set[str] = set()
    config = TrackingConfig(address=loopback)
    tracker = ViconTracker(config, RealClock())
    tracking = asyncio.create_task(
        tracker.run(lambda sightings: seen.update(sighting.body for sighting in sightings))
    )

    async def visitor_is(present: bool) -> bool:
        for _ in range(50):
            seen.clear()
            await asyncio.sleep(0.1)
            if config.body in seen and (config.visitor in seen) == present:
                return True
        return False

    assert await visitor_is(True)
    process.send_signal(signal.SIGUSR1)
    assert await line(process) == "twin: the visitor has left"
    assert await visitor_is(False)
    tracking.cancel()
    await asyncio.gather(tracking, return_exceptions=True)


async def test_the_drone_serves_on_while_its_camera_is_killed_and_comes_back(start, loopback):
    process = await start(site_text(loopback, video=True))
    assert (await line(process)).endswith("video on")
    reader, writer = await asyncio.open_connection(loopback, VIDEO_PORT)
    await pictures(reader, 5)

    (camera,) = [
        child
        for child in psutil.Process(process.pid).children()
        if "camera.child" in " ".join(child.cmdline())
    ]
    camera.kill()
    text = await line(process)
    while "started again" not in text:
        text = await line(process)
    after = await pictures(reader, 20)
    assert any(frame.keyframe for frame in after)
    writer.close()

    process.send_signal(signal.SIGTERM)
    assert await asyncio.wait_for(process.wait(), 10.0) == 0
    assert psutil.pid_exists(camera.pid) is False


async def pictures(reader: asyncio.StreamReader, count: int) -> list[PaveFrame]:
    reassembler, frames = VideoReassembler(), list[PaveFrame]()
    while len(frames) < count:
        frames += reassembler.feed(await asyncio.wait_for(reader.read(65536), 40.0))
    return frames


@pytest.mark.parametrize("key", ["drone", "tracking"])
async def test_an_address_that_others_can_reach_is_refused_in_words(start, key):
    process = await start(f'[{key}]\naddress = "0.0.0.0"\n[twin]\nvideo = false\n')
    assert f"{key}.address: is 0.0.0.0" in await line(process)
    assert await process.wait() == 1


async def test_a_taken_port_is_told_in_words(start, loopback):
    first = await start(site_text(loopback))
    await line(first)
    second = await start(site_text(loopback))
    assert f"cannot serve an AR.Drone at {loopback}" in await line(second)
    assert await second.wait() == 1


async def test_it_writes_the_truth_while_its_tracking_lies_and_stamps_it_with_our_clock(
    start, loopback, tmp_path
):
    site = site_text(loopback) + '[[faults]]\nfault = "mocap.x:wrong=3"\n'
    file = tmp_path / "truth.jsonl"
    began = RealClock().now()
    process = await start(site, "--truth", str(file))
    assert "made to fail: mocap.x:wrong@0s=3" in await line(process)
    tracker = ViconTracker(TrackingConfig(address=loopback), RealClock())
    sightings: list[Sighting] = []
    tracking = asyncio.create_task(tracker.run(sightings.extend))
    while not any(seen.body == "ardrone" for seen in sightings) or not file.stat().st_size:
        await asyncio.sleep(0.02)
    tracking.cancel()
    await asyncio.gather(tracking, return_exceptions=True)
    told = next(seen for seen in sightings if seen.body == "ardrone")
    process.send_signal(signal.SIGTERM)
    assert await asyncio.wait_for(process.wait(), 20.0) == 0
    truth = read_truth(file)
    assert truth is not None
    assert began < truth.time[0] < truth.time[-1] < RealClock().now()
    assert told.pose.position[0] - truth.position[0][0] == pytest.approx(3.0, abs=0.05)
    assert truth.contacts == () and not truth.airborne.any()


async def test_a_fault_that_cannot_be_is_told_in_one_line(start, loopback):
    process = await start(site_text(loopback) + '[[faults]]\nfault = "pilot:off"\n')
    assert "cannot be made in wires, only in lock step" in await line(process)
    assert await asyncio.wait_for(process.wait(), 20.0) == 1
