"""The wire of a firmware's program on the UDP port where its drivers look for it.

The program sends to a port of ours, and from there its datagrams go to every client, unread; those
of clients go to the program. What befalls links befalls them on the way.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from typing import Any

from housefly.errors import LinkError
from housefly.twin.link_filters import Deliver, LinkFilters

_CLIENTS_MAX = 8
_FORGOTTEN_AFTER = 60.0


class Relay:
    """Passes datagrams on; all calls belong to one asyncio loop.

    Args:
        address: IP address that clients know.
        port: UDP port that clients know.
        filters: what stands between a client and the program.
    """

    def __init__(self, address: str, port: int, filters: LinkFilters) -> None:
        self._address, self._port, self._filters = address, port, filters
        self._heard_at: dict[Any, float] = {}
        self._downlinks: dict[Any, Deliver] = {}
        self._outside: asyncio.DatagramTransport | None = None
        self._inside: asyncio.DatagramTransport | None = None
        self._program: Any = None
        self._uplink = filters.uplink(self._to_program)

    async def start(self) -> int:
        """Open both ports; return the one that the program sends to. Raises LinkError."""
        loop = asyncio.get_running_loop()
        try:
            self._outside, _ = await loop.create_datagram_endpoint(
                lambda: _Port(self._from_client), (self._address, self._port)
            )
            self._inside, _ = await loop.create_datagram_endpoint(
                lambda: _Port(self._from_program), ("127.0.0.1", 0)
            )
        except OSError as error:
            self.stop()
            raise LinkError(
                f"cannot serve a drone at {self._address}:{self._port}: {error.strerror or error}"
            ) from error
        port: int = self._inside.get_extra_info("sockname")[1]
        return port

    def stop(self) -> None:
        """Close both ports."""
        for end in (self._outside, self._inside):
            if end is not None:
                end.abort()

    def _from_client(self, data: bytes, place: Any) -> None:
        now = time.monotonic()
        self._heard_at[place] = now
        for silent in [one for one, at in self._heard_at.items() if now - at > _FORGOTTEN_AFTER]:
            self._forget(silent)
        if len(self._heard_at) > _CLIENTS_MAX:
            self._forget(min(self._heard_at, key=lambda one: self._heard_at[one]))
        if place not in self._downlinks:
            self._downlinks[place] = self._filters.downlink(self._sender(place))
        self._uplink(data)

    def _forget(self, place: Any) -> None:
        self._heard_at.pop(place, None)
        self._downlinks.pop(place, None)

    def _sender(self, place: Any) -> Deliver:
        def send(data: bytes) -> None:
            if self._outside is not None and not self._outside.is_closing():
                self._outside.sendto(data, place)

        return send

    def _to_program(self, data: bytes) -> None:
        inside = self._inside
        if inside is not None and self._program is not None and not inside.is_closing():
            inside.sendto(data, self._program)

    def _from_program(self, data: bytes, place: Any) -> None:
        self._program = place
        for deliver in tuple(self._downlinks.values()):
            deliver(data)


class _Port(asyncio.DatagramProtocol):
    """Hands on what arrives."""

    def __init__(self, take: Callable[[bytes, Any], None]) -> None:
        self._take = take

    def datagram_received(self, data: bytes, addr: Any) -> None:
        self._take(data, addr)

    def error_received(self, exc: Exception) -> None:
        """Ignore that the other side is gone: clients are forgotten later."""
