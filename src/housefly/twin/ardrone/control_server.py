"""TCP 5559 of the simulated drone: sends the configuration when asked by ``CTRL 4`` or ``CTRL 6``.

The request comes by UDP and may overtake its connection, so it waits a moment for one.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.twin.link_counters import Counters
from housefly.wires.ardrone.config import CONTROL_PORT

_MAX_CLIENTS = 8
_MAX_BACKLOG = 256 * 1024
"""Bytes that may wait for a client that asks but does not read."""
_CONNECTION_TIMEOUT = 0.5
"""How long a request waits for its connection [s]."""


class _Listener(asyncio.Protocol):
    """One client of the control port; whatever it sends is ignored."""

    def __init__(self, port: ControlServer) -> None:
        self._port = port
        self._transport: asyncio.Transport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        if not self._port.admit(self):
            transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        self._transport = None
        self._port.dismiss(self)

    def close(self) -> None:
        if self._transport is not None:
            self._transport.abort()

    def send(self, text: bytes) -> None:
        """Send an answer, unless earlier ones pile up."""
        if self._transport is not None and self._transport.get_write_buffer_size() < _MAX_BACKLOG:
            self._transport.write(text)


class ControlServer:
    """Sends the configuration to all connected clients when asked by ``answer``.

    Args:
        describe: returns the text for a request; its argument is True for the list of custom
            configurations.
        counters: where answers are counted.
    """

    def __init__(self, describe: Callable[[bool], bytes], counters: Counters) -> None:
        self._describe = describe
        self._counters = counters
        self._clients: set[_Listener] = set()
        self._server: asyncio.Server | None = None
        self._waiting: tuple[bool, float] | None = None

    async def start(self, address: str) -> None:
        """Listen; raises OSError when the address is taken."""
        loop = asyncio.get_running_loop()
        self._server = await loop.create_server(lambda: _Listener(self), address, CONTROL_PORT)

    async def stop(self) -> None:
        """Close the port and every connection."""
        if self._server is not None:
            self._server.close()
        for client in tuple(self._clients):
            client.close()

    def answer(self, customs: bool) -> None:
        """Send the configuration or the list of custom ones, now or to the next client."""
        if not self._clients:
            self._waiting = customs, asyncio.get_running_loop().time() + _CONNECTION_TIMEOUT
            return
        text = self._describe(customs)
        for client in self._clients:
            client.send(text)
        self._counters.config_dumps += 1

    def admit(self, client: _Listener) -> bool:
        """Take a new client, unless there are too many, and give it the answer that waits."""
        if len(self._clients) >= _MAX_CLIENTS:
            return False
        self._clients.add(client)
        waiting, self._waiting = self._waiting, None
        if waiting is not None and asyncio.get_running_loop().time() < waiting[1]:
            self.answer(waiting[0])
        return True

    def dismiss(self, client: _Listener) -> None:
        """Forget a client."""
        self._clients.discard(client)
