"""Client of VRPN 07.x servers.

Motive, Vicon Tracker, ART, PhaseSpace, Qualisys and many others can be one.
"""

from __future__ import annotations

import asyncio

from housefly.bus.reconnect import (
    DATA_AGE_MAX,
    ReconnectingClient,
    TcpStream,
    connection_lost,
    within,
)
from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig
from housefly.errors import LinkError, WireError
from housefly.messages import Sighting
from housefly.messages.words import UNSAID, Words, figure
from housefly.tracking.contracts import SightingSink
from housefly.tracking.counts import FrameCounts
from housefly.tracking.rate_limit import FRAMES_PER_SECOND_MAX, FrameLimiter
from housefly.tracking.vrpn_frames import VrpnFrames
from housefly.tracking.vrpn_link import VRPN_TIMEOUT, open_by_datagram, open_directly
from housefly.wires.vrpn import (
    COOKIE_SIZE,
    MAJOR_VERSION,
    VrpnMessage,
    VrpnStream,
    decode_cookie,
    encode_cookie,
)

_CHUNK = 64 * 1024
_TRANSPORTS = {"tcp": open_directly, "udp": open_by_datagram}


class VrpnTracker(ReconnectingClient[tuple[Sighting, ...]]):
    """Connects either way and hands poses to a sink as they arrive.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        super().__init__(f"{config.address}:{config.vrpn_port}", clock)
        self.counts = FrameCounts()
        self._config = config
        self._limiter = FrameLimiter()
        self._flooded_at = float("-inf")

    @property
    def problem(self) -> Words:
        """Why no poses arrive, or why some are dropped; UNSAID where all is well."""
        if not self._problem and self._clock.now() - self._flooded_at <= DATA_AGE_MAX:
            return Words(
                "{name} sends more than {n} frames a second; the rest is dropped",
                name=self._where,
                n=figure(FRAMES_PER_SECOND_MAX),
            )
        return self._problem or self.counts.unit_problem(self._clock.now()) or super().problem

    def _no_data_problem(self) -> Words:
        return Words(
            "connected to {name}, but nothing new arrives; is {what} live, not paused?",
            name=self._where,
            what="VRPN",
        )

    def _protocol_problem(self, error: WireError) -> Words:
        return Words(
            "what answers at {name} does not speak {protocol} ({error})",
            name=self._where,
            protocol=f"VRPN {MAJOR_VERSION}",
            error=str(error),
        )

    async def _read_connection(self, sink: SightingSink) -> None:
        open_stream = _TRANSPORTS[self._config.vrpn_transport]
        stream = await open_stream(self._config.address, self._config.vrpn_port)
        async with self._open(stream) as (reader, _):
            await self._exchange_cookies(stream)
            messages = VrpnStream()
            frames = VrpnFrames(self._config.latency, self._config.y_up, self.counts)
            while True:
                arrived = messages.feed(await self._chunk(reader))
                now = self._clock.now()
                for sightings in frames.read(self._within_limit(arrived, now), now):
                    self._data_arrived(now)
                    sink(sightings)

    async def _exchange_cookies(self, stream: TcpStream) -> None:
        """Exchange versions; raises LinkError for another major version."""
        reader, writer = stream
        writer.write(encode_cookie())
        cookie = await within(
            VRPN_TIMEOUT,
            reader.readexactly(COOKIE_SIZE),
            f"connected to {self._where}, but it sends no VRPN cookie; is it a VRPN server?",
        )
        version = decode_cookie(cookie)
        if not version.startswith(MAJOR_VERSION):
            raise LinkError(
                f"the server at {self._where} speaks VRPN {version}; Housefly speaks"
                f" {MAJOR_VERSION}.x"
            )
        self._problem = UNSAID

    async def _chunk(self, reader: asyncio.StreamReader) -> bytes:
        chunk = await self._before_timeout(
            reader.read(_CHUNK),
            super()._no_data_problem(),
        )
        if not chunk:
            raise LinkError(connection_lost(self._where))
        return chunk

    def _within_limit(self, messages: tuple[VrpnMessage, ...], now: float) -> list[VrpnMessage]:
        # system messages (negative kinds) carry the names: always keep them
        kept = [message for message in messages if message.kind < 0 or self._limiter.admits(now)]
        if len(kept) < len(messages):
            self.counts.flooded += len(messages) - len(kept)
            self._flooded_at = now
        return kept
