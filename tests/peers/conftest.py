"""A twin in real time on its real ports, for clients that other people wrote."""

from __future__ import annotations

import asyncio
import json
import shutil
from collections.abc import AsyncIterator, Awaitable, Callable
from dataclasses import dataclass, field
from fractions import Fraction
from math import cos, sin
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest

from housefly.bus.rate import Rate
from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.geometry import wrap_angle
from housefly.room.files import load_room
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.contracts import EncodedPicture, FlightState, GroundTruth, TwinWorld
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld

HERE = Path(__file__).resolve().parent
NODE_TIMEOUT = 60.0

RunNode = Callable[..., Awaitable[list[Any]]]


@dataclass
class Twin:
    """A world in real time behind a server, and what really happened in it."""

    world: TwinWorld
    server: ArDroneServer
    address: str
    trail: list[GroundTruth] = field(default_factory=list)

    @property
    def flight(self) -> FlightState:
        return self.world.onboard().flight

    @property
    def displacement(self) -> tuple[float, float]:
        """How far forward and left [m] of where it started, in the heading that it had then."""
        start, end = self.trail[0].pose, self.world.truth().pose
        dx, dy = (end.position[axis] - start.position[axis] for axis in (0, 1))
        return cos(start.yaw) * dx + sin(start.yaw) * dy, cos(start.yaw) * dy - sin(start.yaw) * dx

    @property
    def turned(self) -> float:
        """Change of heading since the start [rad]."""
        return wrap_angle(self.world.truth().pose.yaw - self.trail[0].pose.yaw)

    @property
    def highest(self) -> float:
        return max(truth.pose.position[2] for truth in self.trail)


@pytest.fixture
async def twin(loopback: str, pictures: list[EncodedPicture]) -> AsyncIterator[Twin]:
    site = Site()
    world = SimulatedWorld(site, load_room(site.room.model))
    server = ArDroneServer(world, loopback)
    await server.start()
    flying = Twin(world, server, loopback)
    tasks = [
        asyncio.create_task(coroutine)
        for coroutine in (RealTimeRunner(world, RealClock()).run(), _film(flying, pictures))
    ]
    try:
        yield flying
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await server.stop()


async def _film(twin: Twin, pictures: list[EncodedPicture]) -> None:
    rate = Rate(30.0)
    number = 0
    while True:
        await rate.sleep()
        number += 1
        twin.trail.append(twin.world.truth())
        known = pictures[number % len(pictures)]
        twin.server.publish(
            EncodedPicture(
                number, known.data, known.keyframe, known.width, known.height, twin.world.now
            )
        )


@pytest.fixture(scope="session")
def pictures() -> list[EncodedPicture]:
    """Thirty pictures of a moving edge, H.264 640x360 in groups of 15."""
    encoder = av.CodecContext.create("libx264", "w")
    encoder.width, encoder.height, encoder.pix_fmt = 640, 360, "yuv420p"
    encoder.time_base = Fraction(1, 30)
    encoder.options = {
        "preset": "ultrafast",
        "tune": "zerolatency",
        "x264-params": "keyint=15:min-keyint=15:scenecut=0",
    }
    made: list[EncodedPicture] = []
    for number in range(30):
        image = np.zeros((360, 640, 3), np.uint8)
        image[:, : 20 * number] = 200
        for packet in encoder.encode(av.VideoFrame.from_ndarray(image, format="rgb24")):
            made.append(
                EncodedPicture(number, bytes(packet), packet.is_keyframe, 640, 360, number / 30)
            )
    return made


@pytest.fixture
def run_node() -> RunNode:
    """Return a function that runs a script of this folder and reads its lines of JSON."""
    node = shutil.which("node")
    if node is None or not (HERE / "node_modules").is_dir():
        pytest.skip(
            "node, or the packages of tests/peers, are not installed: npm ci --prefix tests/peers"
        )

    async def run(script: str, *arguments: str, text: str = "") -> list[Any]:
        process = await asyncio.create_subprocess_exec(
            node,
            script,
            *arguments,
            cwd=HERE,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            stderr=-1,
        )
        try:
            output, complaints = await asyncio.wait_for(
                process.communicate(text.encode()), NODE_TIMEOUT
            )
        finally:
            if process.returncode is None:
                process.kill()
        lines = [line for line in output.decode().splitlines() if line.startswith("{")]
        assert process.returncode == 0, complaints.decode()
        return [json.loads(line) for line in lines]

    return run
