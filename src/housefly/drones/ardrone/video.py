"""The drone's live video: TCP port 5555 to ``VideoFrame``; reconnects for ever."""

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
_CHUNK = 65_536


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
            with contextlib.suppress(OSError, TimeoutError):
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
                    if frame.header.codec == CODEC_H264 and gate.passes(frame):
                        self._deliver(frame)
        finally:
            writer.transport.abort()

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
