"""What the tests of the tracking clients share: a room with two bodies, told at a steady rate."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from math import pi
from typing import Protocol

from housefly.clock import RealClock
from housefly.geometry import quaternion_from_euler
from housefly.messages import Pose
from housefly.twin.contracts import MocapFrame


class Publisher(Protocol):
    """Any of the twin's tracking servers."""

    def publish(self, frame: MocapFrame) -> None: ...


class Bench:
    """A room with two bodies, told at a steady rate."""

    DRONE = Pose((1.25, -0.5, 1.1), quaternion_from_euler(0.05, -0.03, pi / 2))
    VISITOR = Pose((3.0, 2.0, 0.9))
    LATENCY = 0.015

    @staticmethod
    async def feed(
        server: Publisher, rate_hz: float = 100.0, drone: Pose | None = DRONE, ahead: float = 0.0
    ) -> None:
        """Publish frames for ever; ``ahead`` is what the sender's clock is ahead of ours [s]."""
        start, clock = RealClock().now(), RealClock()
        number = 0
        while True:
            number += 1
            captured = start + number / rate_hz
            await asyncio.sleep(captured + Bench.LATENCY - clock.now())
            stamp = captured + ahead
            server.publish(
                MocapFrame(
                    number,
                    stamp,
                    stamp + Bench.LATENCY,
                    (("ardrone", drone), ("visitor", Bench.VISITOR)),
                )
            )

    @staticmethod
    @asynccontextmanager
    async def running(*work: object) -> AsyncIterator[None]:
        tasks = [asyncio.ensure_future(item) for item in work]  # type: ignore[call-overload]
        try:
            yield
        finally:
            for task in tasks:
                task.cancel()
                with suppress(asyncio.CancelledError):
                    await task

    @staticmethod
    async def until(condition: Callable[[], bool], seconds: float = 20.0) -> None:
        async with asyncio.timeout(seconds):
            while not condition():
                await asyncio.sleep(0.005)
