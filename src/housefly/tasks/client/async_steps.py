"""The steps of a pilot for asyncio, from the bus of a run on this machine."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncGenerator
from concurrent.futures import Future
from contextlib import suppress

from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.messages import PilotStep

WAITING_MAX = 1000
"""Steps that wait for a slow reader, who gets the newest."""


async def pilot_steps(endpoint: str, drone: str) -> AsyncGenerator[PilotStep]:
    """Yield the steps of a drone's pilot, a hundred a second, until cancelled.

    Args:
        endpoint: of the run's bus.
        drone: its name.

    Raises:
        LinkError: the bus cannot be joined.
    """
    loop, arrived = asyncio.get_running_loop(), asyncio.Event()
    waiting: deque[PilotStep] = deque(maxlen=WAITING_MAX)

    def heard(step: PilotStep) -> None:
        waiting.append(step)
        if len(waiting) == 1:
            with suppress(RuntimeError):  # the loop is closed
                loop.call_soon_threadsafe(arrived.set)

    bus = await _joined(endpoint)
    try:
        bus.subscribe(DroneTopics(drone).step, heard)
        while True:
            await arrived.wait()
            arrived.clear()
            while waiting:
                yield waiting.popleft()
    finally:
        await asyncio.to_thread(bus.close)


async def _joined(endpoint: str) -> ZenohBus:
    """Return a member of the bus; one that is cancelled meanwhile leaves it again."""
    loop = asyncio.get_running_loop()
    opening = loop.run_in_executor(None, lambda: ZenohBus(connect=endpoint))
    try:
        return await asyncio.shield(opening)
    except asyncio.CancelledError:
        opening.add_done_callback(_leave)
        raise


def _leave(opening: asyncio.Future[ZenohBus] | Future[ZenohBus]) -> None:
    if not opening.cancelled() and opening.exception() is None:
        opening.result().close()
