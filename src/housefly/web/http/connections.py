"""Bounds the HTTP connections: whoever only holds one open gives way to whoever wants to speak.

When there are too many, the one that has waited longest without a request is cut, and not the new
one refused: a flood of idle connections cannot keep a browser out. WebSockets are bounded per
session, by ``web.http.seats``.
"""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable
from typing import Any

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

MAX_CONNECTIONS = 128
"""Open HTTP connections."""
MAX_OF_ONE_ADDRESS = 96
"""Open HTTP connections of one address."""
HEADER_TIMEOUT = 5.0
"""How long a connection may take to send the head of its next request [s]."""
_SWEEP_PERIOD = 1.0


class ConnectionLimiter:
    """Knows the open connections, oldest first; everything happens on one asyncio loop.

    Attributes:
        cut: connections closed because there were too many, or because they said nothing.
        on_connection: is told of every connection that HTTP may begin on.
    """

    def __init__(self) -> None:
        self.cut = 0
        self.on_connection: Callable[[asyncio.BaseTransport], None] = lambda transport: None
        self._waiting: dict[LimitedProtocol, float] = {}
        self._speaking: dict[LimitedProtocol, None] = {}
        self._sweeping: asyncio.TimerHandle | None = None

    def add(self, connection: LimitedProtocol) -> None:
        """Add a new connection; another may be cut for it."""
        self.wait(connection)
        if len(self._waiting) + len(self._speaking) > MAX_CONNECTIONS:
            self._cut_one(connection, lambda other: True)
        elif self._of(connection) > MAX_OF_ONE_ADDRESS:
            self._cut_one(connection, lambda other: other.address == connection.address)

    def wait(self, connection: LimitedProtocol) -> None:
        """Note that a connection waits for its next request from now on."""
        self._speaking.pop(connection, None)
        self._waiting[connection] = connection.loop.time()
        if self._sweeping is None:
            self._sweeping = connection.loop.call_later(_SWEEP_PERIOD, self._sweep, connection.loop)

    def speak(self, connection: LimitedProtocol) -> None:
        """Note that a request has begun."""
        if self._waiting.pop(connection, None) is not None:
            self._speaking[connection] = None

    def remove(self, connection: LimitedProtocol) -> None:
        """Forget a connection."""
        self._waiting.pop(connection, None)
        self._speaking.pop(connection, None)

    def _of(self, connection: LimitedProtocol) -> int:
        return Counter(other.address for other in (*self._waiting, *self._speaking))[
            connection.address
        ]

    def _cut_one(self, newest: LimitedProtocol, may: Callable[[LimitedProtocol], bool]) -> None:
        for other in (*self._waiting, *self._speaking):
            if other is not newest and may(other):
                self._cut(other)
                return

    def _cut(self, connection: LimitedProtocol) -> None:
        self.cut += 1
        self.remove(connection)
        connection.transport.abort()

    def _sweep(self, loop: asyncio.AbstractEventLoop) -> None:
        self._sweeping = None
        before = loop.time() - HEADER_TIMEOUT
        for connection in [one for one, since in self._waiting.items() if since < before]:
            self._cut(connection)
        if self._waiting:
            self._sweeping = loop.call_later(_SWEEP_PERIOD, self._sweep, loop)


class LimitedProtocol(H11Protocol):
    """uvicorn's HTTP protocol that tells a limiter what its connection does."""

    limiter: ConnectionLimiter
    address: str = ""

    def connection_made(self, transport: Any) -> None:
        """Register the connection."""
        super().connection_made(transport)
        self.limiter.on_connection(transport)
        self.address = self.client[0] if self.client else ""
        self.limiter.add(self)

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget it."""
        self.limiter.remove(self)
        super().connection_lost(exc)

    def handle_events(self) -> None:
        """Note the beginning of a request."""
        super().handle_events()
        if self.cycle is not None and not self.cycle.response_complete:
            self.limiter.speak(self)

    def handle_websocket_upgrade(self, event: h11.Request) -> None:
        """Hand the connection over."""
        self.limiter.remove(self)
        super().handle_websocket_upgrade(event)

    def on_response_complete(self) -> None:
        """Note the end of a request."""
        if not self.transport.is_closing():
            self.limiter.wait(self)
        super().on_response_complete()


def limited_protocol(limiter: ConnectionLimiter) -> type[asyncio.Protocol]:
    """Return the protocol class of one server."""
    return type("LimitedProtocol", (LimitedProtocol,), {"limiter": limiter})
