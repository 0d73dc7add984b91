"""The wire to one vehicle: UDP or TCP, our heartbeats, and whose messages count.

The first autopilot that is heard is the vehicle; messages of others on the same wire, of cameras
and of other ground stations, do not count. A connection that ends is made again, for ever.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from typing import Any, cast

from housefly.clock import Clock
from housefly.errors import LinkError, WireError
from housefly.wires.mavlink import requests
from housefly.wires.mavlink.endpoint import Endpoint
from housefly.wires.mavlink.framing import FrameReader, FrameWriter
from housefly.wires.mavlink.reports import VehicleReport, report_in

_HEARTBEAT_PERIOD, _RECONNECT_PAUSE = 1.0, 0.5
_BACKLOG_MAX = 4096
"""Bytes that may wait on a stream that is not read, before more is thrown away."""
_DATAGRAMS_MAX = 2000
"""More datagrams in a second are thrown away unread; a vehicle sends some hundreds."""
_AUTOPILOT = 1
_UNKNOWN_SYSTEM = 1

Hear = Callable[[VehicleReport], None]


class MavlinkLink(asyncio.DatagramProtocol, asyncio.Protocol):
    """Sends messages to one vehicle and hands on what it tells.

    Args:
        endpoint: of the vehicle.
        clock: for ages.
        hear: called with each report of the vehicle.

    Attributes:
        target: system and component of the vehicle; 1 and 1 before it is heard.
        heard: whether it was heard yet.
        unread: datagrams thrown away because there were too many.
    """

    def __init__(self, endpoint: Endpoint, clock: Clock, hear: Hear) -> None:
        self.target: requests.Target = (_UNKNOWN_SYSTEM, _AUTOPILOT)
        self.heard, self.unread = False, 0
        self._endpoint, self._clock, self._hear = endpoint, clock, hear
        self._reader, self._writer = (
            FrameReader(),
            FrameWriter(requests.GROUND_SYSTEM, requests.GROUND_COMPONENT),
        )
        self._transport: asyncio.BaseTransport | None = None
        self._lost = asyncio.Event()
        self._tasks: list[asyncio.Task[None]] = []
        self._second, self._count = float("-inf"), 0

    @property
    def broken(self) -> int:
        """How many pieces were no message, or were refused."""
        return self._reader.broken

    @property
    def is_open(self) -> bool:
        """Whether what is sent goes anywhere."""
        return self._transport is not None

    async def open(self) -> None:
        """Open the wire and send heartbeats from now on.

        Raises:
            LinkError: the address cannot be used; a stream that is refused is tried again.
        """
        if self._tasks:
            return
        try:
            await self._connect()
        except OSError as error:
            if not self._endpoint.is_stream:
                raise LinkError(
                    f"cannot open a socket to {self._endpoint}: {error.strerror or error}"
                ) from error
        self._tasks = [asyncio.create_task(work()) for work in (self._beat, self._keep)]

    async def close(self) -> None:
        """Release the wire."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        self._tasks.clear()
        if self._transport is not None:
            cast(Any, self._transport).abort()
        self._transport = None

    def send(self, *messages: Any) -> None:
        """Send messages at once; without a wire, or where it does not drain, they are dropped."""
        link = self._transport
        if link is None or not messages:
            return
        data = [self._writer.packed(message) for message in messages]
        if not self._endpoint.is_stream:
            for one in data:
                cast(asyncio.DatagramTransport, link).sendto(one)
        elif cast(asyncio.Transport, link).get_write_buffer_size() <= _BACKLOG_MAX:
            cast(asyncio.Transport, link).write(b"".join(data))

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Use a wire."""
        self._transport, self._reader = transport, FrameReader()
        self._lost.clear()
        self.send(requests.heartbeat())

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget it."""
        self._transport = None
        self._lost.set()

    def datagram_received(self, data: bytes, addr: Any) -> None:
        """Take in a datagram of the vehicle; a flood is not read."""
        now = self._clock.now()
        if now - self._second > 1.0:
            self._second, self._count = now, 0
        self._count += 1
        if self._count > _DATAGRAMS_MAX:
            self.unread += 1
        else:
            self.data_received(data)

    def data_received(self, data: bytes) -> None:
        """Take in the next bytes of the vehicle."""
        for message in self._reader.feed(data):
            try:
                report = report_in(message)
            except WireError as error:
                self._reader.refuse(error)
                continue
            if report is not None and self._is_ours(message):
                self._hear(report)

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens yet: heartbeats go on."""

    def _is_ours(self, message: Any) -> bool:
        sender = message.get_srcSystem(), message.get_srcComponent()
        if not self.heard and sender[1] == _AUTOPILOT and message.get_type() == "HEARTBEAT":
            self.heard, self.target = True, sender
        return self.heard and sender == self.target

    async def _beat(self) -> None:
        while True:
            self.send(requests.heartbeat())
            await asyncio.sleep(_HEARTBEAT_PERIOD)

    async def _keep(self) -> None:
        while True:
            if self._transport is None:
                with suppress(OSError):
                    await self._connect()
            if self._transport is not None:
                await self._lost.wait()
            await asyncio.sleep(_RECONNECT_PAUSE)

    async def _connect(self) -> None:
        loop, end = asyncio.get_running_loop(), self._endpoint
        if end.is_stream:
            await loop.create_connection(lambda: self, end.host, end.port)
            return
        own = (_any(end.host), end.own_port) if end.own_port else None
        await loop.create_datagram_endpoint(
            lambda: self,
            local_addr=own,
            remote_addr=(end.host, end.port),
            reuse_port=None if own is None else True,
        )


def _any(host: str) -> str:
    return "::" if ":" in host else "0.0.0.0"
