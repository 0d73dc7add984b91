"""The tracking system as a pilot sees it: its client runs in the room's process."""

from __future__ import annotations

import asyncio
import contextlib
from math import inf
from pathlib import Path

from housefly.bus.private_socket import is_own_user
from housefly.clock import Clock
from housefly.errors import WireError
from housefly.messages import TrackedFrame
from housefly.messages.words import Words
from housefly.tracking.contracts import SightingSink
from housefly.tracking.tracking_messages import TrackerStatus, TrackingMessageReader

_RECONNECT_PAUSE = 0.05
"""Pause between two attempts to reach the room's process [s]."""
_SILENT_AFTER = 1.0
"""The room's process, which tells how tracking is four times a second, does not answer [s]."""
_UNREACHED = TrackerStatus(problem=Words("the room's process does not answer (its log: room.log)"))


class RemoteTracker:
    """Implements ``tracking.contracts.Tracker`` over the socket of a ``SightingServer``.

    Args:
        path: of the socket.
        clock: for ages.
    """

    def __init__(self, path: Path, clock: Clock) -> None:
        self._path, self._clock = path, clock
        self._status, self._heard_at = _UNREACHED, -inf

    async def run(self, sink: SightingSink) -> None:
        """Connect, hand on each frame's sightings, reconnect for ever; ends only when cancelled."""
        loop = asyncio.get_running_loop()
        while True:
            link: _RoomLink | None = None
            with contextlib.suppress(OSError):
                _, link = await loop.create_unix_connection(
                    lambda: _RoomLink(self, sink), str(self._path)
                )
            try:
                if link is not None:
                    await link.lost.wait()
            finally:
                self._status = _UNREACHED
                if link is not None:
                    link.close()
            await asyncio.sleep(_RECONNECT_PAUSE)

    @property
    def connected(self) -> bool:
        """Whether frames arrive (within the last second)."""
        return self._told().connected

    @property
    def problem(self) -> Words:
        """Why not; UNSAID where all is well."""
        return self._told().problem

    def note(self, status: TrackerStatus) -> None:
        """Take in how the room's tracker is."""
        self._status, self._heard_at = status, self._clock.now()

    def _told(self) -> TrackerStatus:
        """Return the newest word; a process that stands still says nothing, and nothing is well."""
        is_heard = self._clock.now() - self._heard_at < _SILENT_AFTER
        return self._status if is_heard else _UNREACHED


class _RoomLink(asyncio.Protocol):
    """One connection to the room's process."""

    def __init__(self, tracker: RemoteTracker, sink: SightingSink) -> None:
        self.lost = asyncio.Event()
        self._tracker, self._sink = tracker, sink
        self._reader = TrackingMessageReader()
        self._transport: asyncio.Transport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        if not is_own_user(transport.get_extra_info("socket")):
            transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        self.lost.set()

    def data_received(self, data: bytes) -> None:
        try:
            messages = self._reader.feed(data)
        except WireError:
            self.close()
            return
        for message in messages:
            if isinstance(message, TrackedFrame):
                self._sink(message.sightings)
            else:
                self._tracker.note(message)

    def close(self) -> None:
        """End the connection at once."""
        if self._transport is not None:
            self._transport.abort()
