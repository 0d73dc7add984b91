"""Client of a Vicon motion capture system (Vicon Tracker, Nexus, Blade), over its DataStream
protocol.
"""

from __future__ import annotations

import asyncio
import socket

from housefly.bus.reconnect import Trouble, reconnect_for_ever
from housefly.clock import Clock, RealClock
from housefly.config.site import TrackingConfig
from housefly.errors import LinkError, WireError
from housefly.tracking.contracts import Sink
from housefly.tracking.counts import FrameCounts
from housefly.tracking.vicon_frames import FrameReader
from housefly.wires.vicon import (
    HEADER_SIZE,
    ApplicationInfo,
    Contents,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    ObjectEnums,
    RequestFrame,
    StreamInfo,
    SubjectInfo,
    decode_packet,
    encode_packet,
    packet_length,
)

WANTED = frozenset(
    item.KIND
    for item in (
        StreamInfo,
        SubjectInfo,
        FrameInfo,
        GlobalSegments,
        LatencyInfo,
        ApplicationInfo,
        Contents,
    )
)
FRESH = 1.0
"""``connected`` means a frame within this time [s]."""
_CONNECT_TIMEOUT = 2.0
_SILENCE = 5.0
"""A server silent for this long [s] is connected to anew: a pulled cable says nothing."""


class ViconTracker:
    """Connects, asks for every frame, hands each to a sink as it arrives, and reconnects for ever.

    Attributes:
        counts: frames and what was dropped.
        malformed: connections given up because of bytes that are not the protocol.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        self.counts = FrameCounts()
        self.malformed = 0
        self._config = config
        self._clock = clock or RealClock()
        self._frame_at = float("-inf")
        self._problem = f"not connected to {self._where} yet"

    @property
    def connected(self) -> bool:
        """Whether a frame arrived within the last second."""
        return self._clock.now() - self._frame_at <= FRESH

    @property
    def problem(self) -> str:
        """Why no poses arrive, in words, or ""."""
        if self._problem or self.connected:
            return self._problem
        return (
            f"connected to {self._where}, but no frames arrive; is the Vicon Tracker live, not"
            " paused?"
        )

    async def run(self, sink: Sink) -> None:
        """Connect and read for ever; ends only when cancelled."""
        await reconnect_for_ever(
            lambda: self._session(sink), lambda: self.counts.frames, self._ended
        )

    def _ended(self, error: Trouble) -> None:
        if isinstance(error, WireError):
            self.malformed += 1
            self._problem = (
                f"what answers at {self._where} does not speak Vicon DataStream ({error})"
            )
        else:
            self._problem = str(error)

    @property
    def _where(self) -> str:
        return f"{self._config.address}:{self._config.port}"

    async def _session(self, sink: Sink) -> None:
        """Read one connection to its end; raises WireError or LinkError."""
        reader, writer = await self._connect()
        try:
            frames = FrameReader(self._config.latency, self.counts)
            await self._ask(reader, writer)
            while True:
                items = decode_packet(await self._packet(reader))
                now = self._clock.now()
                sightings = frames.read(items, now)
                if sightings is None:
                    continue
                self._frame_at = now
                self._problem = (
                    ""
                    if not frames.y_up
                    else f"{self._where} streams with y up; choose z up in the Vicon software"
                )
                sink(sightings)
        except (asyncio.IncompleteReadError, OSError) as error:
            raise LinkError(f"the connection to {self._where} was lost") from error
        finally:
            writer.transport.abort()

    async def _connect(self) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
        try:
            async with asyncio.timeout(_CONNECT_TIMEOUT):
                reader, writer = await asyncio.open_connection(
                    self._config.address, self._config.port
                )
        except (OSError, UnicodeError) as error:
            raise LinkError(
                f"nobody answers at {self._where}; is the Vicon Tracker running and streaming?"
            ) from error
        writer.get_extra_info("socket").setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return reader, writer

    async def _ask(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Wait for the server's offer, then ask for poses and for every frame."""
        offers = [
            item.kinds
            for item in decode_packet(await self._packet(reader))
            if isinstance(item, ObjectEnums)
        ]
        if not offers:
            raise WireError("the server's first packet does not say what it offers")
        if GlobalSegments.KIND not in offers[0]:
            raise WireError("the server offers no segments")
        self._problem = ""
        writer.write(encode_packet([ObjectEnums(WANTED & offers[0])]))
        writer.write(encode_packet([RequestFrame(streaming=True)]))

    async def _packet(self, reader: asyncio.StreamReader) -> bytes:
        try:
            async with asyncio.timeout(_SILENCE):
                length = packet_length(await reader.readexactly(HEADER_SIZE))
                return await reader.readexactly(length)
        except TimeoutError as error:
            raise LinkError(
                f"connected to {self._where}, but it is silent; is the Vicon Tracker live, not"
                " paused?"
            ) from error
