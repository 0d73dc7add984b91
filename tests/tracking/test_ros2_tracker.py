"""Poses of real ROS 2 nodes, through the child, on our clock."""

from __future__ import annotations

import asyncio
import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from ros_stage import RosClient

from housefly.clock import RealClock
from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.tracking.ros2 import Ros2Tracker
from housefly.tracking.trackers import tracker_of

pytest.importorskip("rclpy")

pytestmark = [pytest.mark.wire, pytest.mark.slow]
DOMAIN = 40 + os.getpid() % 50
AGE = 0.03
"""How long before it is sent a pose was captured [s]."""


@pytest.fixture(scope="module")
def client() -> Iterator[RosClient]:
    client = RosClient(DOMAIN)
    yield client
    client.close()


def stamped(message: Any) -> Any:
    at = time.time() - AGE
    message.header.stamp.sec, message.header.stamp.nanosec = int(at), int(at % 1.0 * 1e9)
    return message


async def heard(client: RosClient, until: int, tracker: Ros2Tracker | Any) -> list[Sighting]:
    """Publish poses of two kinds at 50 Hz until so many arrived."""
    from geometry_msgs.msg import PoseStamped, TransformStamped

    pose = client.node.create_publisher(PoseStamped, "/mocap/ardrone/pose", 10)
    moved = client.node.create_publisher(TransformStamped, "/mocap/visitor/pose", 10)
    found: list[Sighting] = []
    running = asyncio.create_task(tracker.run(found.extend))
    try:
        async with asyncio.timeout(60.0):
            while len(found) < until:
                one, two = stamped(PoseStamped()), stamped(TransformStamped())
                one.pose.position.x, one.pose.orientation.w = 1.5, 1.0
                two.transform.translation.y, two.transform.rotation.w = 2.5, 1.0
                pose.publish(one)
                moved.publish(two)
                await asyncio.sleep(0.02)
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
    return found


async def test_poses_of_any_node_arrive_by_the_name_in_their_topic(client: RosClient) -> None:
    config = TrackingConfig(kind="ros2", ros_topic="/mocap/{body}/pose", ros_domain=DOMAIN)
    tracker = tracker_of(config, RealClock())
    found = await heard(client, 60, tracker)
    bodies = {one.body: one.pose.position for one in found}
    assert bodies == {"ardrone": (1.5, 0.0, 0.0), "visitor": (0.0, 2.5, 0.0)}
    ages = [one.received_at - one.captured_at for one in found]
    assert min(ages) >= config.latency - 1e-6 and tracker.problem == ""
    times = [one.captured_at for one in found if one.body == "ardrone"]
    assert times == sorted(times)


async def test_a_child_that_is_killed_is_started_again(client: RosClient) -> None:
    config = TrackingConfig(kind="ros2", ros_topic="/mocap/{body}/pose", ros_domain=DOMAIN)
    tracker = Ros2Tracker(config, RealClock())
    before = children()
    first = asyncio.create_task(heard(client, 20, tracker))
    while not (born := children() - before):
        await asyncio.sleep(0.02)
    await asyncio.sleep(1.0)
    for pid in born:
        os.kill(pid, signal.SIGKILL)
    assert len(await first) >= 20


async def test_where_nobody_publishes_that_is_said(client: RosClient) -> None:
    config = TrackingConfig(kind="ros2", ros_topic="/nobody/{body}", ros_domain=DOMAIN)
    tracker = Ros2Tracker(config, RealClock())
    running = asyncio.create_task(tracker.run(lambda _: None))
    async with asyncio.timeout(60.0):
        while "nobody publishes there" not in str(tracker.problem):
            await asyncio.sleep(0.1)
    running.cancel()
    await asyncio.gather(running, return_exceptions=True)


def children() -> set[int]:
    listed = Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children")
    return {int(pid) for pid in listed.read_text(encoding="ascii").split()}
