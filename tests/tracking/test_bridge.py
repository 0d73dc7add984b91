"""The bridge to motioncapture: what it reads of our own servers, and what happens when it fails."""

from __future__ import annotations

import asyncio
import importlib.util
import json
import math
import sys
from typing import Any

import pytest

from housefly.config.tracking import TrackingConfig
from housefly.messages import Pose, Sighting
from housefly.tracking.bridge import BridgeTracker, connection_settings
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.natnet_server import NatNetServer
from housefly.twin.mocap.vicon_server import ViconServer
from housefly.twin.mocap.vrpn_server import VrpnServer

TURNED = (math.cos(0.3), 0.0, 0.0, math.sin(0.3))


def config(address: str, system: str) -> TrackingConfig:
    return TrackingConfig(kind="bridge", bridge_system=system, address=address)


async def feed(server: Any) -> None:
    """Publish 100 frames a second of a drone that moves: what stands still to the bit is taken for
    lost.
    """
    number = 0
    while True:
        number += 1
        drone = Pose((0.001 * number, 2.0, 1.0), TURNED)
        server.publish(
            MocapFrame(
                number, 0.01 * number, 0.01 * number + 0.01, (("ardrone", drone), ("visitor", None))
            )
        )
        await asyncio.sleep(0.01)


def server_of(system: str, address: str) -> Any:
    if system == "vicon":
        return ViconServer(address)
    if system == "vrpn":
        return VrpnServer(address)
    port = 40000 + sum(map(int, address.split("."))) % 10000
    return NatNetServer(address, group="239" + address[3:], data_port=port)


@pytest.mark.wire
@pytest.mark.parametrize("system", ["vicon", "optitrack", "vrpn"])
async def test_the_bridge_reads_every_server_of_the_twin(
    loopback: str, bench: Any, system: str
) -> None:
    pytest.importorskip("motioncapture")
    server = server_of(system, loopback)
    await server.start()
    tracker = BridgeTracker(config(loopback, system))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(feed(server), tracker.run(frames.append)):
        await bench.until(lambda: len(frames) >= 50)
        assert tracker.connected
        assert tracker.problem == ""
    await server.stop()
    for (seen,) in frames:
        assert seen.body == "ardrone"
        assert seen.pose.position[1:] == pytest.approx((2.0, 1.0), abs=1e-5)
        assert seen.pose.orientation == pytest.approx(TURNED, abs=1e-5)
        assert seen.received_at - seen.captured_at == pytest.approx(0.02)


@pytest.mark.wire
async def test_a_system_that_falls_silent_is_named_and_asked_again(
    loopback: str, bench: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("motioncapture")
    monkeypatch.setattr(BridgeTracker, "SILENCE_TIMEOUT", 2.5)
    server = ViconServer(loopback)
    await server.start()
    tracker = BridgeTracker(config(loopback, "vicon"))
    frames: list[tuple[Sighting, ...]] = []
    async with bench.running(tracker.run(frames.append)):
        async with bench.running(feed(server)):
            await bench.until(lambda: len(frames) >= 3)
        await bench.until(lambda: "nothing new arrives" in tracker.problem)
        await bench.until(lambda: "silent" in tracker.problem)
        frames.clear()
        async with bench.running(feed(server)):
            await bench.until(lambda: len(frames) >= 3)
    await server.stop()


@pytest.mark.wire
async def test_nobody_there_is_named_although_the_library_hangs(
    loopback: str, bench: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("motioncapture")
    monkeypatch.setattr(BridgeTracker, "SILENCE_TIMEOUT", 1.0)
    tracker = BridgeTracker(config(loopback, "optitrack"))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: "silent" in tracker.problem)
        assert not tracker.connected


@pytest.mark.wire
async def test_a_system_that_the_library_does_not_know_is_named(loopback: str, bench: Any) -> None:
    pytest.importorskip("motioncapture")
    tracker = BridgeTracker(config(loopback, "crystal_ball"))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: "Unknown motion capture type" in tracker.problem)


async def test_a_missing_library_is_named_with_its_remedy(
    bench: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    tracker = BridgeTracker(config("127.0.0.1", "qualisys"))
    async with bench.running(tracker.run(lambda frame: None)):
        await bench.until(lambda: "pip install 'housefly[mocap]'" in tracker.problem)


@pytest.mark.wire
async def test_the_child_ends_with_its_parent(loopback: str) -> None:
    pytest.importorskip("motioncapture")
    server = ViconServer(loopback)
    await server.start()
    command = (
        sys.executable,
        "-m",
        "housefly.tracking.bridge_child",
        "vicon",
        json.dumps({"hostname": f"{loopback}:8010"}),
    )
    child = await asyncio.create_subprocess_exec(
        *command, stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE
    )
    assert child.stdin is not None and child.stdout is not None
    server.publish(MocapFrame(1, 0.0, 0.0, ()))
    await asyncio.wait_for(child.stdout.readline(), 10.0)
    child.stdin.close()
    assert await asyncio.wait_for(child.wait(), 10.0) == 0
    await server.stop()


def test_each_system_is_told_where_it_is() -> None:
    assert connection_settings(config("127.0.0.1", "qualisys")) == {"hostname": "127.0.0.1"}
    assert connection_settings(config("127.0.0.1", "vicon")) == {"hostname": "127.0.0.1:8010"}
    assert connection_settings(config("127.0.0.1", "optitrack"))["interface_ip"] == "127.0.0.1"
