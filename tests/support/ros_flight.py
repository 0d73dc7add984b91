"""A whole simulated room that ROS flies: a node tells the poses, and goals are orders."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import ros_mocap
from ros_stage import RosClient

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site, site_from_tree

READY = 120.0
"""Longest wait for the room, on a machine three times slower than this one [s]."""


@dataclass
class RosFlight:
    """What a test has.

    Attributes:
        client: a node.
        folder: of the logs.
        phases, odometry, events: what the drone tells.
    """

    client: RosClient
    folder: Path
    phases: list[Any] = field(default_factory=list)
    odometry: list[Any] = field(default_factory=list)
    events: list[Any] = field(default_factory=list)

    @property
    def truth(self) -> Path:
        """Where the twin writes what really happened."""
        return self.folder / "truth.jsonl"

    def log(self) -> str:
        """Return what node and pilot say."""
        names = ("ros2", "pilot")
        logs = "".join((self.folder / f"{name}.log").read_text() for name in names)
        return "\n".join([logs, *(one.msg for one in self.events)])


@contextmanager
def ros_flight(folder: Path, domain: int) -> Iterator[RosFlight]:
    """Run the room until the test is done.

    Args:
        folder: for its files.
        domain: of ROS, of this test alone.
    """
    site = _site(folder, domain)
    runtime, flight = new_runtime(site, folder), RosFlight(RosClient(domain), folder)
    processes = tuple(
        replace(spec, arguments=(*spec.arguments, "--truth", str(flight.truth)))
        if spec.name == "twin"
        else spec
        for spec in processes_of(runtime)
    )
    client = flight.client
    try:
        with (
            Launcher(runtime, folder, processes),
            _mocap_node(site, domain),
            ZenohBus(connect=runtime.bus) as bus,
        ):
            assert Readiness(site, bus, web=False, video=False).wait(READY) == ""
            flight.phases = client.heard("/lab/drone/phase", latched=True)
            flight.odometry = client.heard("/lab/drone/odom")
            flight.events = client.heard("/lab/drone/events")
            assert client.spin(lambda: flight.phases and flight.odometry)
            yield flight
    finally:
        client.close()


def _site(folder: Path, domain: int) -> Site:
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
                "ros_domain": domain,
            },
            "hub": {"store": str(folder / "room.db")},
            "ros2": {"enabled": True, "domain": domain, "requests": "auto"},
            "tasks": {"enabled": False},
            "web": {"port": port},
            "twin": {"seed": 1, "mocap_wires": ["vicon"], "video": False},
        }
    )


@contextmanager
def _mocap_node(site: Site, domain: int) -> Iterator[None]:
    """Run a ROS driver of the simulated Vicon."""
    where = (site.tracking.address, str(site.tracking.port), str(domain))
    command = [sys.executable, ros_mocap.__file__, *where]
    with subprocess.Popen(command, stdin=subprocess.PIPE):
        yield
