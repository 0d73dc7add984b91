"""Bounds the connections that are still agreeing on encryption: whoever says nothing is cut.

The HTTP server hears of a connection only when its handshake is done.
"""

from __future__ import annotations

import asyncio
import socket
from contextlib import suppress
from typing import Any

MAX_HANDSHAKES = 128
"""Handshakes at a time; with more the oldest is cut."""
HANDSHAKE_TIMEOUT = 5.0
"""How long one may take [s]."""
_SWEEP_PERIOD = 1.0


class HandshakeListener(socket.socket):
    """A listening socket that knows which of its connections are not encrypted yet."""

    def __init__(self, *given: Any, **named: Any) -> None:
        super().__init__(*given, **named)
        self._shaking: dict[socket.socket, float] = {}
        self._sweeping: asyncio.TimerHandle | None = None

    def accept(self) -> tuple[socket.socket, Any]:
        """Accept a connection and wait for its handshake; on asyncio's loop."""
        connection, address = super().accept()
        loop = asyncio.get_running_loop()
        self._shaking[connection] = loop.time()
        self._forget_closed()
        while len(self._shaking) > MAX_HANDSHAKES:
            self._cut(next(iter(self._shaking)))
        if self._sweeping is None:
            self._sweeping = loop.call_later(_SWEEP_PERIOD, self._sweep, loop)
        return connection, address

    def finished(self, transport: asyncio.BaseTransport) -> None:
        """Note that the handshake of a connection is done."""
        found = transport.get_extra_info("socket")
        number = found.fileno() if found is not None else -1
        for connection in [one for one in self._shaking if one.fileno() == number]:
            del self._shaking[connection]

    def _forget_closed(self) -> None:
        for connection in [one for one in self._shaking if one.fileno() == -1]:
            del self._shaking[connection]

    def _cut(self, connection: socket.socket) -> None:
        del self._shaking[connection]
        with suppress(OSError):
            connection.shutdown(socket.SHUT_RDWR)  # asyncio sees its end and closes it

    def _sweep(self, loop: asyncio.AbstractEventLoop) -> None:
        self._sweeping = None
        self._forget_closed()
        before = loop.time() - HANDSHAKE_TIMEOUT
        for connection in [one for one, since in self._shaking.items() if since < before]:
            self._cut(connection)
        if self._shaking:
            self._sweeping = loop.call_later(_SWEEP_PERIOD, self._sweep, loop)
