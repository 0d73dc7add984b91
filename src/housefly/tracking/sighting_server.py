"""The room's end of the socket to its pilots: every frame of the tracking system, at once.

The socket lies in a folder that only this user can enter. A pilot that does not read loses frames,
never the newest ones after it reads again, and delays nobody.
"""

from __future__ import annotations

import asyncio
from pathlib import Path

from housefly.bus.private_socket import check_private, is_own_user
from housefly.messages import Sighting, TrackedFrame
from housefly.tracking.contracts import Tracker
from housefly.tracking.tracking_messages import (
    TrackerStatus,
    TrackingMessage,
    encode_tracking_message,
)

STATUS_PERIOD = 0.25
"""How often pilots hear how the tracker is [s]."""
_BACKLOG_MAX = 16_384
"""Bytes that may wait for a pilot that does not read, before frames are thrown away."""


class SightingServer:
    """Hands on what a tracker sees.

    Args:
        tracker: of the tracking system; it runs elsewhere.
        path: of the socket.
    """

    def __init__(self, tracker: Tracker, path: Path) -> None:
        self._tracker, self._path = tracker, path
        self._pilots: set[_PilotLink] = set()

    async def run(self) -> None:
        """Serve until cancelled; raises LinkError when others could reach the socket."""
        check_private(self._path.parent)
        self._path.unlink(missing_ok=True)  # of a process that died
        server = await asyncio.get_running_loop().create_unix_server(
            lambda: _PilotLink(self), str(self._path)
        )
        try:
            while True:
                self._send(self.status())
                await asyncio.sleep(STATUS_PERIOD)
        finally:
            server.close()
            for pilot in tuple(self._pilots):
                pilot.close()

    def send_sightings(self, sightings: tuple[Sighting, ...]) -> None:
        """Hand on the sightings of one frame."""
        if self._pilots:
            self._send(TrackedFrame(sightings))

    def status(self) -> TrackerStatus:
        """Return how the tracker is."""
        return TrackerStatus(self._tracker.connected, self._tracker.problem)

    def admit(self, pilot: _PilotLink) -> None:
        """Take a new pilot."""
        self._pilots.add(pilot)
        pilot.send(encode_tracking_message(self.status()))

    def dismiss(self, pilot: _PilotLink) -> None:
        """Note that a connection ended."""
        self._pilots.discard(pilot)

    def _send(self, message: TrackingMessage) -> None:
        data = encode_tracking_message(message)
        for pilot in tuple(self._pilots):
            pilot.send(data)


class _PilotLink(asyncio.Protocol):
    """One connection of a pilot."""

    def __init__(self, server: SightingServer) -> None:
        self._server = server
        self._transport: asyncio.Transport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        if is_own_user(transport.get_extra_info("socket")):
            self._server.admit(self)
        else:
            transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        self._server.dismiss(self)

    def send(self, data: bytes) -> None:
        """Send bytes unless the pilot does not read."""
        link = self._transport
        if link is not None and link.get_write_buffer_size() <= _BACKLOG_MAX:
            link.write(data)

    def close(self) -> None:
        """End the connection."""
        if self._transport is not None:
            self._transport.close()
