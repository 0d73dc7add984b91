"""One TCP connection of a tracking client, which loses the frames that it reads too late."""

from __future__ import annotations

import asyncio
import socket

_MAX_BACKLOG = 64 * 1024
"""Bytes that may wait for a slow client; about a hundred frames of two bodies."""


class StreamClient:
    """One connection and its send queue."""

    def __init__(self, writer: asyncio.StreamWriter) -> None:
        self._writer = writer
        connection = writer.get_extra_info("socket")
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        # The kernel would otherwise keep megabytes of frames too old to be of use.
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, _MAX_BACKLOG)

    def offer(self, packet: bytes) -> bool:
        """Send a packet unless too much waits already; returns whether it was taken."""
        if (
            self._writer.is_closing()
            or self._writer.transport.get_write_buffer_size() > _MAX_BACKLOG
        ):
            return False
        self._writer.write(packet)
        return True

    def close(self) -> None:
        """Drop the connection with whatever waits for it."""
        self._writer.transport.abort()
