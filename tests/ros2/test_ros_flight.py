"""A whole room in ROS: a node tells poses, another gives a goal, the drone flies; on the truth."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import ros_mocap
from ros_stage import RosClient

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site, site_from_tree
from housefly.record.truth import read_truth

pytest.importorskip("rclpy")

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(400)]
DOMAIN = 1 + os.getpid() % 90
READY, FLIGHT = 120.0, 120.0
"""Longest waits, on a machine three times slower than this one [s]."""


def site_of(folder: Path) -> Site:
    number = os.getpid()
    address = f"127.{1 + number % 250}.{number // 250 % 250}.78"
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    return site_from_tree(
        {
            "name": "lab",
            "room": {"model": "bsen"},
            "drone": {"address": address},
            "tracking": {
                "kind": "ros2",
                "address": address,
                "ros_topic": "/mocap/{body}/pose",
                "ros_domain": DOMAIN,
            },
            "hub": {"store": str(folder / "room.db")},
            "ros2": {"enabled": True, "domain": DOMAIN, "requests": "auto"},
            "tasks": {"enabled": False},
            "web": {"port": port},
            "twin": {"seed": 1, "mocap_wires": ["vicon"], "video": False},
        }
    )


@contextmanager
def mocap_node(site: Site) -> Iterator[None]:
    """Run a ROS driver of the simulated Vicon."""
    where = (site.tracking.address, str(site.tracking.port), str(DOMAIN))
    command = [sys.executable, ros_mocap.__file__, *where]
    with subprocess.Popen(command, stdin=subprocess.PIPE):
        yield


def test_a_goal_of_a_ros_node_is_flown_by_poses_of_another(tmp_path: Path) -> None:
    from geometry_msgs.msg import PoseStamped

    site, truth = site_of(tmp_path), tmp_path / "truth.jsonl"
    runtime = new_runtime(site, tmp_path)
    processes = tuple(
        replace(spec, arguments=(*spec.arguments, "--truth", str(truth)))
        if spec.name == "twin"
        else spec
        for spec in processes_of(runtime)
    )
    client = RosClient(DOMAIN)

    events: list[Any] = []

    def log() -> str:
        logs = "".join((tmp_path / f"{name}.log").read_text() for name in ("ros2", "pilot"))
        return "\n".join([logs, *(one.msg for one in events)])

    try:
        with (
            Launcher(runtime, tmp_path, processes),
            mocap_node(site),
            ZenohBus(connect=runtime.bus) as bus,
        ):
            assert Readiness(site, bus, web=False, video=False).wait(READY) == ""
            phases = client.heard("/lab/drone/phase", latched=True)
            odometry, events = client.heard("/lab/drone/odom"), client.heard("/lab/drone/events")
            assert client.spin(lambda: phases and odometry)
            goal = PoseStamped()
            goal.header.frame_id = "map"
            goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = 3.9, 4.2, 1.0
            client.says("/lab/drone/goal_pose", goal)
            assert client.spin(lambda: phases[-1].data == "holding", FLIGHT), log()
            there = odometry[-1].pose.pose.position
            assert (there.x, there.y) == pytest.approx((3.9, 4.2), abs=0.3)
            assert client.calls("/lab/drone/home").success
            assert client.spin(lambda: phases[-1].data == "idle", FLIGHT), log()
            time.sleep(1.0)  # the truth is written in batches
    finally:
        client.close()
    flown = read_truth(truth)
    assert flown is not None and flown.airborne.any() and not flown.airborne[-1]
    assert [one for one in flown.contacts if one.motors_turned] == []
