"""Client of VRPN 07.x servers: Motive, Vicon Tracker, ART, PhaseSpace, Qualisys and many others can
be one.
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
from housefly.tracking.flood import MOST, FloodGate
from housefly.tracking.vrpn_frames import VrpnFrames
from housefly.tracking.vrpn_link import CONNECT_TIMEOUT, Stream, be_connected, connect
from housefly.wires.vrpn import (
    COOKIE_SIZE,
    MAJOR,
    Message,
    MessageStream,
    decode_cookie,
    encode_cookie,
)

FRESH = 1.0
"""``connected`` means a pose within this time [s]."""
SILENCE = 5.0
"""A server silent for this long [s] is connected to anew: a pulled cable says nothing."""
_CHUNK = 64 * 1024
_WAYS = {"tcp": connect, "udp": be_connected}


class VrpnTracker:
    """Connects, hands poses to a sink as they arrive, and reconnects for ever.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        self.counts = FrameCounts()
        self._config = config
        self._clock = clock or RealClock()
        self._gate = FloodGate()
        self._frame_at = self._flooded_at = float("-inf")
        self._problem = f"not connected to {self._where} yet"

    @property
    def connected(self) -> bool:
        """Whether a pose arrived within the last second."""
        return self._clock.now() - self._frame_at <= FRESH

    @property
    def problem(self) -> str:
        """Why no poses arrive, in words, or ""."""
        if not self._problem and self._clock.now() - self._flooded_at <= FRESH:
            return f"{self._where} sends more than {MOST} messages a second; the others are dropped"
        if self._problem or self.connected:
            return self._problem
        return (
            f"connected to {self._where}, but no new poses arrive; is the body seen, the server not"
            " paused?"
        )

    async def run(self, sink: Sink) -> None:
        """Connect and read for ever; ends only when cancelled."""
        await reconnect_for_ever(
            lambda: self._session(sink), lambda: self.counts.frames, self._ended
        )

    def _ended(self, error: Trouble) -> None:
        if isinstance(error, WireError):
            self.counts.malformed += 1
            self._problem = f"what answers at {self._where} does not speak VRPN {MAJOR} ({error})"
        else:
            self._problem = str(error)

    @property
    def _where(self) -> str:
        return f"{self._config.address}:{self._config.vrpn_port}"

    async def _session(self, sink: Sink) -> None:
        """Read one connection to its end; raises WireError or LinkError."""
        reader, writer = await _WAYS[self._config.vrpn_transport](
            self._config.address, self._config.vrpn_port
        )
        try:
            await self._greet((reader, writer))
            stream, frames = (
                MessageStream(),
                VrpnFrames(self._config.latency, self._config.y_up, self.counts),
            )
            while True:
                messages = stream.feed(await self._piece(reader))
                now = self._clock.now()
                for sightings in frames.read(self._within_limit(messages, now), now):
                    self._frame_at = now
                    sink(sightings)
        except (asyncio.IncompleteReadError, OSError) as error:
            raise LinkError(f"the connection to {self._where} was lost") from error
        finally:
            writer.transport.abort()

    async def _greet(self, connection: Stream) -> None:
        """Exchange cookies; raises WireError for another major version."""
        reader, writer = connection
        writer.get_extra_info("socket").setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        writer.write(encode_cookie())
        try:
            async with asyncio.timeout(CONNECT_TIMEOUT):
                version = decode_cookie(await reader.readexactly(COOKIE_SIZE))
        except TimeoutError as error:
            raise LinkError(
                f"connected to {self._where}, but it sends no VRPN cookie; is it a VRPN server?"
            ) from error
        if not version.startswith(MAJOR):
            raise LinkError(
                f"the server at {self._where} speaks VRPN {version}; Housefly speaks {MAJOR}.x"
            )
        self._problem = ""

    async def _piece(self, reader: asyncio.StreamReader) -> bytes:
        try:
            async with asyncio.timeout(SILENCE):
                piece = await reader.read(_CHUNK)
        except TimeoutError as error:
            raise LinkError(
                f"connected to {self._where}, but it is silent; is the body seen, the server not"
                " paused?"
            ) from error
        if not piece:
            raise LinkError(f"the connection to {self._where} was lost")
        return piece

    def _within_limit(self, messages: tuple[Message, ...], now: float) -> list[Message]:
        kept = [
            message for message in messages if message.kind < 0 or self._gate.admits(now)
        ]  # names are always heard
        if len(kept) < len(messages):
            self.counts.flooded += len(messages) - len(kept)
            self._flooded_at = now
        return kept
