"""Live video: the drone's own H.264, passed through to any number of browsers (WebSocket, decoded
there by WebCodecs).

One message is one access unit behind a header of ``HEADER``: version, flags (bit 0: key frame),
width, height, sequence number, time received [s, server clock]. The browser answers every picture
with one byte; one that does not keep up skips to a key frame.
"""

from __future__ import annotations

import asyncio
import struct
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field

from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.bus.bus import Bus
from housefly.bus.topics import VIDEO
from housefly.messages import VideoFrame

HEADER = struct.Struct("<BBHHxxQd")
VERSION = 1
GROUP_MAX = 120
"""Pictures since the last key frame that are kept for those who come late."""
WAITING_MAX = 45
"""Pictures that may wait for one browser before it has to skip to the next key frame."""
UNANSWERED_MAX = 4
"""Pictures that may be on their way to one browser."""


def pack(frame: VideoFrame) -> bytes:
    """Return a picture as one WebSocket message."""
    head = HEADER.pack(
        VERSION,
        int(frame.keyframe),
        frame.width,
        frame.height,
        frame.sequence % 2**64,
        frame.received_at,
    )
    return head + frame.data


@dataclass(eq=False, slots=True)
class Watcher:
    """One browser's queue of pictures."""

    waiting: deque[bytes] = field(default_factory=deque)
    unanswered: int = 0
    skipping: bool = False
    wake: asyncio.Event = field(default_factory=asyncio.Event)

    def offer(self, message: bytes, *, keyframe: bool) -> None:
        """Queue a picture, or drop what cannot be decoded in time."""
        if len(self.waiting) >= WAITING_MAX:
            self.waiting.clear()
            self.skipping = True
        if keyframe:
            # Whatever waited before a key frame is out of date.
            if self.skipping or len(self.waiting) > UNANSWERED_MAX:
                self.waiting.clear()
            self.skipping = False
        if not self.skipping:
            self.waiting.append(message)
            self.wake.set()


class VideoRoom:
    """Everybody who watches, and the pictures since the last key frame for those who come late."""

    def __init__(self, bus: Bus) -> None:
        self._bus = bus
        self._group: list[bytes] = []
        self._watchers: set[Watcher] = set()

    def listen(self, loop: asyncio.AbstractEventLoop) -> None:
        """Subscribe to the drone's pictures; the bus closes the subscription."""

        def heard(frame: VideoFrame) -> None:
            with suppress(RuntimeError):  # the loop may be closed while the bus still delivers
                loop.call_soon_threadsafe(self._spread, frame)

        self._bus.subscribe(VIDEO, heard)

    def _spread(self, frame: VideoFrame) -> None:
        message = pack(frame)
        if frame.keyframe or len(self._group) >= GROUP_MAX:
            self._group.clear()
        if frame.keyframe or self._group:
            self._group.append(message)
        for watcher in self._watchers:
            watcher.offer(message, keyframe=frame.keyframe)

    async def serve(self, socket: WebSocket) -> None:
        """Send pictures to one browser until it leaves."""
        await socket.accept()
        with self.watching() as watcher:
            writer = asyncio.create_task(_write(socket, watcher))
            try:
                while (await socket.receive())["type"] != "websocket.disconnect":
                    watcher.unanswered = max(0, watcher.unanswered - 1)
                    watcher.wake.set()
            finally:
                writer.cancel()
                with suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError):
                    await writer

    @contextmanager
    def watching(self) -> Iterator[Watcher]:
        """Yield a queue of pictures that begins with those since the last key frame."""
        watcher = Watcher(deque(self._group), skipping=not self._group)
        watcher.wake.set()
        self._watchers.add(watcher)
        try:
            yield watcher
        finally:
            self._watchers.discard(watcher)


async def _write(socket: WebSocket, watcher: Watcher) -> None:
    while True:
        await watcher.wake.wait()
        watcher.wake.clear()
        while watcher.waiting and watcher.unanswered < UNANSWERED_MAX:
            watcher.unanswered += 1
            await socket.send_bytes(watcher.waiting.popleft())
