"""The drone as the pilot sees it: its driver runs in a process of its own.

Every command carries its time. When the driver does not read, commands are thrown away: the next
one follows within a tick, and an old one would count for nothing.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable
from pathlib import Path

from housefly.bus.private_socket import is_own_user
from housefly.clock import Clock, RealClock
from housefly.config.capabilities import Capabilities
from housefly.drones.driver_messages import (
    DriverStatus,
    LightOrder,
    MessageReader,
    PoseNews,
    TimedCommand,
    encode_driver_message,
)
from housefly.errors import LinkError, WireError
from housefly.messages import Command, KnownMotion, Sighting, Telemetry, VideoFrame
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.messages.words import Words

_UNREACHED = Words("the driver's process does not answer (its log: driver.log)")
_CONNECT_TIMEOUT = 5.0
"""How long ``connect`` waits for the driver [s]."""
_RECONNECT_PAUSE = 0.05
"""Pause between two attempts to reach the driver [s]."""
_BACKLOG_MAX = 1024
"""Bytes that may wait for a driver that does not read, before commands are thrown away."""


class RemoteDrone(asyncio.Protocol):
    """Implements ``drones.contract.Drone`` over the socket of a ``DriverServer``.

    Args:
        path: of the socket.
        clock: the machine's monotonic clock, which the driver has too.
    """

    def __init__(self, path: Path, clock: Clock | None = None) -> None:
        self._path = path
        self._clock = clock or RealClock()
        self._reader = MessageReader()
        self._transport: asyncio.Transport | None = None
        self._telemetry: Telemetry | None = None
        self._status = DriverStatus()
        self._handlers: list[Callable[[VideoFrame], None]] = []
        self._keeping: asyncio.Task[None] | None = None
        self._reached = asyncio.Event()
        self._lost = asyncio.Event()

    async def connect(self) -> None:
        """Reach the driver; later this is tried again by itself.

        Raises:
            LinkError: it does not answer in time.
        """
        if self._keeping is None:
            self._keeping = asyncio.create_task(self._keep_connected(), name="driver link")
        try:
            async with asyncio.timeout(_CONNECT_TIMEOUT):
                await self._reached.wait()
        except TimeoutError as error:
            raise LinkError(_UNREACHED) from error

    async def close(self) -> None:
        """End the connection; in the air the driver takes that as a pilot that is gone."""
        if self._keeping is not None:
            self._keeping.cancel()
            await asyncio.gather(self._keeping, return_exceptions=True)
            self._keeping = None
        if self._transport is not None:
            self._transport.close()

    def send(self, command: Command, motion: KnownMotion | None = None) -> None:
        """Hand over the command in force from now on, and how the drone moves; returns at once."""
        self._write(TimedCommand(command, self._clock.now(), motion))

    def send_pose(self, seen: Sighting) -> None:
        """Hand over where tracking saw the drone; returns at once."""
        self._write(PoseNews(seen))

    @property
    def capabilities(self) -> Capabilities | None:
        """What the drone can do; None while the driver is not reached."""
        return self._status.capabilities

    def show_recording(self, records: bool) -> None:
        """Blink while the camera is recorded, where the drone can; to be said again and again."""
        self._write(LightOrder(records))

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
        return self._telemetry

    @property
    def telemetry_rate_hz(self) -> float:
        """Reports per second over the last second, as the driver counts them."""
        return self._status.telemetry_rate_hz

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        report = self._telemetry
        is_young = report is not None and self._clock.now() - report.received_at < REPORT_AGE_MAX
        return self._status.connected and is_young

    @property
    def video_connected(self) -> bool:
        """Whether pictures arrive."""
        return self._status.video_connected

    @property
    def problem(self) -> Words:
        """What is wrong with drone, driver or link; UNSAID for nothing."""
        return self._status.problem if self._reached.is_set() else _UNREACHED

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """Call the handler with each picture from the first key frame on."""
        self._handlers.append(handler)

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Use a connection whose other end is our user's."""
        assert isinstance(transport, asyncio.Transport)
        if not is_own_user(transport.get_extra_info("socket")):
            transport.abort()
            return
        self._transport, self._reader = transport, MessageReader()
        self._lost.clear()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the connection; the last report stays, and its age tells."""
        self._transport = None
        self._status = DriverStatus()
        self._reached.clear()
        self._lost.set()

    def data_received(self, data: bytes) -> None:
        """Take in reports, pictures and the driver's health."""
        try:
            messages = self._reader.feed(data)
        except WireError:
            if self._transport is not None:
                self._transport.abort()
            return
        for message in messages:
            match message:
                case Telemetry():
                    self._telemetry = message
                case DriverStatus():
                    self._status = message
                    self._reached.set()
                case VideoFrame():
                    for handler in self._handlers:
                        handler(message)

    def _write(self, message: TimedCommand | LightOrder | PoseNews) -> None:
        link = self._transport
        if link is not None and link.get_write_buffer_size() <= _BACKLOG_MAX:
            link.write(encode_driver_message(message))

    async def _keep_connected(self) -> None:
        loop = asyncio.get_running_loop()
        while True:
            with contextlib.suppress(OSError):
                self._lost.clear()
                await loop.create_unix_connection(lambda: self, str(self._path))
                await self._lost.wait()
            await asyncio.sleep(_RECONNECT_PAUSE)
