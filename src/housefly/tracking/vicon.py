"""Client of Vicon motion capture (Tracker, Nexus, Blade) over its DataStream protocol."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from math import inf

from housefly.bus.reconnect import DATA_AGE_MAX, ReconnectingClient, open_tcp
from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig
from housefly.errors import LinkError, WireError
from housefly.messages import Sighting
from housefly.messages.words import UNSAID, Words, figure
from housefly.tracking.contracts import SightingSink
from housefly.tracking.counts import FrameCounts
from housefly.tracking.rate_limit import FRAMES_PER_SECOND_MAX, FrameLimiter
from housefly.tracking.software import software_at
from housefly.tracking.vicon_frames import ViconFrames
from housefly.wires.vicon import (
    VICON_HEADER_SIZE,
    ApplicationInfo,
    FrameContents,
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

_WANTED = frozenset(
    item.KIND
    for item in (
        StreamInfo,
        SubjectInfo,
        FrameInfo,
        GlobalSegments,
        LatencyInfo,
        ApplicationInfo,
        FrameContents,
    )
)
_CONNECT_TIMEOUT = 2.0
_PACKETS_AT_ONCE = 8
"""Packets read before others may run: what is buffered is read without waiting."""


class ViconTracker(ReconnectingClient[tuple[Sighting, ...]]):
    """Asks for every frame and hands each to a sink as it arrives.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        super().__init__(f"{config.address}:{config.port}", clock)
        self.counts = FrameCounts()
        self._config = config
        self._limiter = FrameLimiter()
        self._at_once = 0
        self._flooded_at = -inf

    @property
    def problem(self) -> Words:
        """Why no data arrive, or what is wrong with those that do; UNSAID where all is well."""
        if not self._problem and self._clock.now() - self._flooded_at <= DATA_AGE_MAX:
            return Words(
                "{name} sends more than {n} frames a second; the rest is dropped",
                name=self._where,
                n=figure(FRAMES_PER_SECOND_MAX),
            )
        return super().problem

    def _no_data_problem(self) -> Words:
        return Words(
            "connected to {name}, but nothing new arrives; is {what} live, not paused?",
            name=self._where,
            what=software_at(self._config.address, "Vicon Tracker"),
        )

    def _protocol_problem(self, error: WireError) -> Words:
        return Words(
            "what answers at {name} does not speak {protocol} ({error})",
            name=self._where,
            protocol="Vicon DataStream",
            error=str(error),
        )

    async def _read_connection(self, sink: SightingSink) -> None:
        stream = await open_tcp(
            self._config.address,
            self._config.port,
            _CONNECT_TIMEOUT,
            Words(
                "nobody answers at {name}; is {what} running, and does it stream?",
                name=self._where,
                what=software_at(self._config.address, "Vicon Tracker"),
            ),
        )
        async with self._open(stream) as (reader, writer):
            frames = ViconFrames(self._config.latency, self.counts)
            await self._request_frames(reader, writer)
            while True:
                packet = await self._packet(reader)
                now = self._clock.now()
                if not await self._admits(now):
                    continue
                items = decode_packet(packet)
                sightings = frames.read(items, now)
                if sightings is None:
                    continue
                self._data_arrived(now)
                self._problem = (
                    UNSAID
                    if not frames.y_up
                    else Words(
                        "{name} streams with y up; choose z up in the tracking software",
                        name=self._where,
                    )
                )
                sink(sightings)

    async def _admits(self, now: float) -> bool:
        """Return whether to read a packet; lets others run, because buffered ones never wait."""
        admitted = self._limiter.admits(now)
        self._at_once += 1
        if not admitted or self._at_once >= _PACKETS_AT_ONCE:
            self._at_once = 0
            await asyncio.sleep(0)
        if not admitted:
            self.counts.flooded += 1
            self._flooded_at = now
        return admitted

    async def _request_frames(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        """Wait for the server's offer, then ask for poses and for every frame."""
        silence = (
            f"connected to {self._where}, but it does not begin with what it offers, as Vicon"
            " DataStream does: is that its port (801), and no older real-time server (port 800)?"
        )
        first = await self._before_timeout(_read_packet(reader), silence)
        offers = [item.kinds for item in decode_packet(first) if isinstance(item, ObjectEnums)]
        if not offers:
            raise LinkError(
                f"the Vicon DataStream server at {self._where} does not begin with what it offers:"
                " its version is another than Housefly reads; update the Vicon software"
            )
        if lacking := sorted({GlobalSegments.KIND, FrameInfo.KIND} - offers[0]):
            raise LinkError(
                f"the Vicon DataStream server at {self._where} is of an older version: it offers"
                f" the objects {_listed(offers[0]) or 'none'}; Housefly also needs"
                f" {_listed(lacking)} (9 is the poses of segments in the room, 5 the numbers of"
                " frames); update the Vicon software"
            )
        self._problem = UNSAID
        writer.write(encode_packet([ObjectEnums(_WANTED & offers[0])]))
        writer.write(encode_packet([RequestFrame(streaming=True)]))

    async def _packet(self, reader: asyncio.StreamReader) -> bytes:
        return await self._before_timeout(_read_packet(reader), self._no_data_problem())


def _listed(kinds: Iterable[int]) -> str:
    return ", ".join(map(str, sorted(kinds)))


async def _read_packet(reader: asyncio.StreamReader) -> bytes:
    length = packet_length(await reader.readexactly(VICON_HEADER_SIZE))
    return await reader.readexactly(length)
