"""Scans of real ROS 2 nodes, of other processes, through the child, on our clock."""

from __future__ import annotations

import asyncio
import os
import signal
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from math import inf
from pathlib import Path

import pytest
from ros_scanner import BEAMS, ros_scanner

from housefly.clock import RealClock
from housefly.config.laser import LaserConfig
from housefly.messages import Scan
from housefly.sensors.lasers import laser_client
from housefly.sensors.ros2_laser import Ros2LaserClient

pytest.importorskip("rclpy")

pytestmark = [pytest.mark.wire, pytest.mark.slow]
DOMAIN = 130 + os.getpid() % 90
PATIENCE = 60.0
"""A machine three times slower than this one has heard it by then [s]."""


async def until(done: Callable[[], object]) -> None:
    async with asyncio.timeout(PATIENCE):
        while not done():
            await asyncio.sleep(0.02)


@asynccontextmanager
async def heard(topic: str) -> AsyncIterator[tuple[Ros2LaserClient, list[Scan]]]:
    config = LaserConfig(name="hall", kind="ros2", ros_topic=topic, ros_domain=DOMAIN)
    client = laser_client(config, RealClock())
    assert isinstance(client, Ros2LaserClient)
    scans: list[Scan] = []
    running = asyncio.create_task(client.run(scans.append))
    try:
        yield client, scans
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)


@pytest.mark.parametrize("manner", ["good", "best_effort"])
async def test_scans_of_a_node_of_either_quality_arrive_with_their_age(manner: str) -> None:
    async with heard(f"/{manner}") as (client, scans):
        with ros_scanner(DOMAIN, f"/{manner}", manner):
            await until(lambda: len(scans) > 20 and not client.problem)
            assert client.connected
    scan = scans[-1]
    assert len(scan.ranges) == BEAMS and scan.ranges[-1] == inf
    assert scan.ranges[0] == pytest.approx(2.0, abs=0.01)
    assert min(one.received_at - one.captured_at for one in scans) >= 0.03 - 1e-6
    times = [one.captured_at for one in scans]
    assert times == sorted(times)


async def test_a_scanner_that_comes_late_dies_and_comes_back_is_told_so() -> None:
    async with heard("/late") as (client, scans):
        await until(lambda: "nobody publishes there" in client.problem)
        with ros_scanner(DOMAIN, "/late") as process:
            await until(lambda: client.connected)
            process.send_signal(signal.SIGKILL)
            await until(lambda: not client.connected)
            assert "no scans arrive" in client.problem
        count = len(scans)
        with ros_scanner(DOMAIN, "/late"):
            # The dead node counts until its lease ends: ROS does not tell one from the other.
            await until(lambda: len(scans) > count + 5 and client.connected)


async def test_a_child_that_is_killed_is_started_again() -> None:
    with ros_scanner(DOMAIN, "/killed"):
        before = children()
        async with heard("/killed") as (client, scans):
            await until(lambda: len(scans) > 5)
            for pid in children() - before:
                os.kill(pid, signal.SIGKILL)
            count = len(scans)
            await until(lambda: len(scans) > count + 5 and client.connected)


@pytest.mark.parametrize(
    ("manner", "words"),
    [
        ("nan", "no beam has a distance"),
        ("count", "17 ranges"),
        ("giant", "bytes, which is no scan"),
        ("absurd", "its stamp is -5 s"),
        ("text", "std_msgs/msg/String"),
    ],
)
async def test_what_is_no_scan_is_refused_in_words_and_handed_on_to_nobody(
    manner: str, words: str
) -> None:
    before = children()
    async with heard(f"/{manner}") as (client, scans):
        with ros_scanner(DOMAIN, f"/{manner}", manner, 5.0):
            await until(lambda: words in client.problem)
            assert len(children() - before) == 2, "the child stays"
        assert not scans and not client.connected


async def test_a_clock_that_stands_still_is_no_measurement() -> None:
    async with heard("/frozen") as (client, scans):
        with ros_scanner(DOMAIN, "/frozen", "frozen"):
            await until(lambda: client.stale > 40)
            assert len(scans) == 1 and not client.connected
            assert "no scans arrive" in client.problem


async def test_a_flood_is_thinned_out_and_said() -> None:
    async with heard("/flood") as (client, scans):
        with ros_scanner(DOMAIN, "/flood", "good", 1000.0):
            await until(lambda: "more than 100" in client.problem)
            assert client.connected and len(scans) > 20


async def test_of_two_nodes_on_one_topic_none_is_believed() -> None:
    async with heard("/two") as (client, scans):
        with ros_scanner(DOMAIN, "/two"):
            await until(lambda: scans)
            with ros_scanner(DOMAIN, "/two"):
                await until(lambda: "2 nodes publish on /two" in client.problem)
                await until(lambda: not client.connected)


def children() -> set[int]:
    listed = Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children")
    return {int(pid) for pid in listed.read_text(encoding="ascii").split()}
