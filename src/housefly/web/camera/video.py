"""The drone's own H.264, passed through to any number of browsers.

One message is one access unit behind a ``FRAME_HEADER``: version, flags (bit 0: key frame), width,
height, sequence number, time received [s, server clock]. A browser acknowledges every frame; one
that does not keep up skips to the next key frame.
"""

from __future__ import annotations

import asyncio
import struct
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field

from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.config.house_mode import HouseMode
from housefly.evidence.live_blanker import LiveBlanker
from housefly.messages import VideoFrame

FRAME_HEADER = struct.Struct("<BBHHxxQd")
_FORMAT_VERSION = 1
_MAX_GROUP = 120
"""Frames since the last key frame that are kept for late subscribers."""
MAX_QUEUED_FRAMES = 45
"""Frames that may wait for one browser before it must skip to the next key frame."""
_MAX_UNACKNOWLEDGED = 4
"""Frames that may be on their way to one browser."""


def pack_frame(frame: VideoFrame) -> bytes:
    """Return a frame as one WebSocket message."""
    head = FRAME_HEADER.pack(
        _FORMAT_VERSION,
        int(frame.keyframe),
        frame.width,
        frame.height,
        frame.sequence % 2**64,
        frame.received_at,
    )
    return head + frame.data


@dataclass(eq=False, slots=True)
class FrameQueue:
    """The frames that wait for one browser; ``wake`` is set when there may be one to send."""

    waiting: deque[bytes] = field(default_factory=deque)
    unacknowledged: int = 0
    skipping: bool = False
    wake: asyncio.Event = field(default_factory=asyncio.Event)

    def add(self, message: bytes, *, keyframe: bool) -> None:
        """Queue a frame, or drop what cannot be decoded in time."""
        if len(self.waiting) >= MAX_QUEUED_FRAMES:
            self.waiting.clear()
            self.skipping = True
        if keyframe:
            # Whatever waited before a key frame is out of date.
            if self.skipping or len(self.waiting) > _MAX_UNACKNOWLEDGED:
                self.waiting.clear()
            self.skipping = False
        if not self.skipping:
            self.waiting.append(message)
            self.wake.set()

    def next(self) -> bytes | None:
        """Return the next frame to send, or None while none waits or too many are on their way."""
        if not self.waiting or self.unacknowledged >= _MAX_UNACKNOWLEDGED:
            return None
        self.unacknowledged += 1
        return self.waiting.popleft()

    def acknowledge(self) -> None:
        """Count one frame as arrived."""
        self.unacknowledged = max(0, self.unacknowledged - 1)
        self.wake.set()


class VideoRelay:
    """Copies the drone's frames to every subscriber; a late one begins at the last key frame.

    Args:
        bus: where the frames come from.
        privacy: blanks the privacy zones; None where there are none.
        mode: tells the mode of the house, None while nobody knows; it decides which zones count.
            In mode privacy, and until another is told, nothing is shown.
        topics: of the drone; None for those of the only one.
    """

    def __init__(
        self,
        bus: Bus,
        privacy: LiveBlanker | None = None,
        mode: Callable[[], HouseMode | None] = lambda: None,
        topics: DroneTopics | None = None,
    ) -> None:
        self._topics = topics or DroneTopics()
        self._bus, self._mode = bus, mode
        self._privacy = privacy if privacy is not None and privacy.is_needed else None
        self._is_private = False
        self._group: list[bytes] = []
        self._queues: set[FrameQueue] = set()

    def listen(self, loop: asyncio.AbstractEventLoop) -> None:
        """Subscribe to the drone's frames; the bus closes the subscription."""

        def received(frame: VideoFrame) -> None:
            mode = self._mode()
            self._is_private = self._is_private if mode is None else mode is HouseMode.PRIVACY
            shown = None if self._is_private else self._shown(frame, mode)
            with suppress(RuntimeError):  # the loop may be closed while the bus still delivers
                if shown is not None:
                    loop.call_soon_threadsafe(self._relay, shown)
                elif self._is_private:
                    loop.call_soon_threadsafe(self._forget)

        if self._privacy is not None:
            self._bus.subscribe(self._topics.step, self._privacy.add_step)
        self._bus.subscribe(self._topics.video, received)

    @contextmanager
    def subscribed(self) -> Iterator[FrameQueue]:
        """Yield a queue that begins with the frames since the last key frame."""
        queue = FrameQueue(deque(self._group), skipping=not self._group)
        queue.wake.set()
        self._queues.add(queue)
        try:
            yield queue
        finally:
            self._queues.discard(queue)

    def _shown(self, frame: VideoFrame, mode: HouseMode | None) -> VideoFrame | None:
        """Return what may be seen of a frame; takes some milliseconds where there are zones."""
        if self._privacy is None:
            return frame
        self._privacy.set_mode(mode)
        return self._privacy.blanked_frame(frame)

    def _forget(self) -> None:
        """Drop what waits; the next picture that is shown is a key frame."""
        self._group.clear()
        for queue in self._queues:
            queue.waiting.clear()
            queue.skipping = True

    def _relay(self, frame: VideoFrame) -> None:
        message = pack_frame(frame)
        if frame.keyframe or len(self._group) >= _MAX_GROUP:
            self._group.clear()
        if frame.keyframe or self._group:
            self._group.append(message)
        for queue in self._queues:
            queue.add(message, keyframe=frame.keyframe)
