"""What the tests of the twin's tracking servers share: a drone that counts frames, and strangers in
processes of their own.
"""

from __future__ import annotations

import asyncio
import json
import sys
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from typing import Any, Protocol

from housefly.geometry import quaternion_from_euler
from housefly.messages import Pose
from housefly.twin.contracts import MocapFrame

YAW = 2.0
DRONE = Pose((1.5, -2.25, 0.75), quaternion_from_euler(0.0, 0.0, YAW))


class Server(Protocol):
    """Any of the twin's tracking servers."""

    async def start(self) -> None: ...

    async def stop(self) -> None: ...

    def publish(self, frame: MocapFrame) -> None: ...


def frame(number: int, drone: Pose | None = DRONE) -> MocapFrame:
    return MocapFrame(
        number, 0.01 * number, 0.01 * number + 0.02, (("ardrone", drone), ("visitor", None))
    )


@asynccontextmanager
async def fed(server: Server, first: int = 1) -> AsyncIterator[None]:
    """Serve 100 frames a second; the drone's x counts the frames in millimetres."""
    await server.start()

    async def feed() -> None:
        loop = asyncio.get_running_loop()
        start, number = loop.time(), first - 1
        while True:
            number += 1
            server.publish(
                frame(number, Pose((0.001 * number, *DRONE.position[1:]), DRONE.orientation))
            )
            await asyncio.sleep(start + 0.01 * (number - first + 1) - loop.time())

    task = asyncio.create_task(feed())
    await asyncio.sleep(0.05)
    try:
        yield
    finally:
        task.cancel()
        with suppress(asyncio.CancelledError):
            await task
        await server.stop()


async def stranger(program: str, *arguments: str) -> Any:
    """Return what a child process printed last, as JSON; it is killed when it blocks for ever."""
    peer = await asyncio.create_subprocess_exec(
        sys.executable, "-c", program, *arguments, stdout=asyncio.subprocess.PIPE
    )
    try:
        output, _ = await asyncio.wait_for(peer.communicate(), 60.0)
    finally:
        if peer.returncode is None:
            peer.kill()
    return json.loads(output.splitlines()[-1])


async def until(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(20.0):
        while not condition():
            await asyncio.sleep(0.005)
