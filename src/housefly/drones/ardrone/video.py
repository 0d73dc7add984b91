"""The drone's live video: TCP port 5555 to ``VideoFrame``; reconnects for ever.

Whatever arrives, commands come first: a turn of the loop handles one small chunk, and a stream that
is faster than any camera, or garbage, is given up for a while.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable

from housefly.clock import Clock
from housefly.messages import VideoFrame
from housefly.wires.ardrone.pave import (
    CODEC_H264,
    VIDEO_PORT,
    KeyframeGate,
    PaveFrame,
    VideoReassembler,
)

_STALL_TIMEOUT = 2.0
"""After this long without data the link reconnects and no longer counts as connected [s]."""
_RECONNECT_PAUSE = 0.5
"""Pause before reconnecting [s]."""
_CHUNK = 16_384
"""Bytes handled in one turn of the loop: about one picture."""
_BYTES_PER_SECOND_MAX = 4_000_000
"""Faster streams wait in the kernel; a real one has at most 0.5 MB/s."""
_PICTURES_MAX = 120
"""More pictures in a second are no camera's; the connection is given up."""
_BAD_HEADERS_MAX = 256
"""More refused headers in one connection are no video; it is given up."""


class _Flood(Exception):
    """What arrives is no video."""


class VideoLink:
    """Hands on the pictures that can be decoded: from the first key frame after each gap.

    Attributes:
        handlers: called with each picture.
    """

    def __init__(self, address: str, clock: Clock) -> None:
        self.handlers: list[Callable[[VideoFrame], None]] = []
        self._address = address
        self._clock = clock
        self._last_at = float("-inf")
        self._reading: asyncio.Task[None] | None = None
        self._counted_since, self._counted = float("-inf"), 0

    @property
    def connected(self) -> bool:
        """Whether pictures arrive."""
        return self._clock.now() - self._last_at < _STALL_TIMEOUT

    def start(self) -> None:
        """Connect, and reconnect whenever the stream ends or stalls."""
        if self._reading is None:
            self._reading = asyncio.create_task(self._read_for_ever(), name="video")

    async def close(self) -> None:
        """End the stream."""
        if self._reading is not None:
            self._reading.cancel()
            await asyncio.gather(self._reading, return_exceptions=True)
            self._reading = None

    async def _read_for_ever(self) -> None:
        while True:
            with contextlib.suppress(OSError, TimeoutError, _Flood):
                await self._read_once()
            await asyncio.sleep(_RECONNECT_PAUSE)

    async def _read_once(self) -> None:
        async with asyncio.timeout(_STALL_TIMEOUT):
            reader, writer = await asyncio.open_connection(self._address, VIDEO_PORT)
        cutter, gate = VideoReassembler(), KeyframeGate()
        try:
            while True:
                async with asyncio.timeout(_STALL_TIMEOUT):
                    chunk = await reader.read(_CHUNK)
                if not chunk:
                    return
                for frame in cutter.feed(chunk):
                    self._count_picture()
                    if frame.header.codec == CODEC_H264 and gate.passes(frame):
                        self._deliver(frame)
                if cutter.bad_headers > _BAD_HEADERS_MAX:
                    raise _Flood
                await asyncio.sleep(len(chunk) / _BYTES_PER_SECOND_MAX)
        finally:
            writer.transport.abort()

    def _count_picture(self) -> None:
        """Raise _Flood when pictures come faster than any camera makes them."""
        now = self._clock.now()
        if now - self._counted_since > 1.0:
            self._counted_since, self._counted = now, 0
        self._counted += 1
        if self._counted > _PICTURES_MAX:
            raise _Flood

    def _deliver(self, frame: PaveFrame) -> None:
        self._last_at = self._clock.now()
        picture = VideoFrame(
            data=frame.payload,
            keyframe=frame.keyframe,
            width=frame.header.display_width,
            height=frame.header.display_height,
            sequence=frame.header.frame_number,
            received_at=self._last_at,
            drone_time=frame.header.timestamp_ms / 1000.0,
        )
        for handler in self.handlers:
            handler(picture)
