"""A client of one scanning range finder: connects, asks what it is, has it measure, and reconnects
for ever.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from math import inf

from housefly.bus.reconnect import Trouble, reconnect_for_ever
from housefly.clock import Clock, RealClock
from housefly.config.laser import LaserConfig
from housefly.errors import LinkError, WireError
from housefly.messages import Scan
from housefly.wires.scip import (
    Ask,
    Measure,
    Measurement,
    Parameters,
    Reply,
    Request,
    decode_reply,
    encode_request,
    measurement_of,
)
from housefly.wires.scip.replies import LONGEST

FRESH = 1.0
"""``connected`` means a scan within this time [s]."""
_CONNECT_TIMEOUT = 2.0
_SILENCE = 3.0
"""A scanner silent for this long [s] is connected to anew: a pulled cable says nothing."""
_BETWEEN = 20
"""Replies to earlier requests that may come before the one waited for."""

Sink = Callable[[Scan], None]


class LaserClient:
    """Reads one scanner and hands every scan to a sink.

    Attributes:
        scans: how many were handed on.
        stale: scans dropped because the scanner's clock stood still.
        malformed: connections given up because of bytes that are not the protocol.
        parameters: what the scanner says of itself, None before it did.
    """

    def __init__(self, config: LaserConfig, clock: Clock | None = None) -> None:
        self.scans = self.stale = self.malformed = 0
        self.parameters: Parameters | None = None
        self._config = config
        self._clock = clock or RealClock()
        self._scan_at = -inf
        self._stamp = -1
        self._problem = f"not connected to {self._where} yet"

    @property
    def connected(self) -> bool:
        """Whether a scan arrived within the last second."""
        return self._clock.now() - self._scan_at <= FRESH

    @property
    def problem(self) -> str:
        """Why no scans arrive, in words, or ""."""
        if self._problem or self.connected:
            return self._problem
        return f"connected to {self._where}, but no scans arrive"

    async def run(self, sink: Sink) -> None:
        """Connect and read for ever; ends only when cancelled."""
        await reconnect_for_ever(lambda: self._session(sink), lambda: self.scans, self._ended)

    def _ended(self, error: Trouble) -> None:
        if isinstance(error, WireError):
            self.malformed += 1
            self._problem = f"what answers at {self._where} does not speak SCIP ({error})"
        else:
            self._problem = str(error)

    @property
    def _where(self) -> str:
        return f"{self._config.address}:{self._config.port}"

    async def _session(self, sink: Sink) -> None:
        """Read one connection to its end; raises WireError or LinkError."""
        reader, writer = await self._connect()
        try:
            await self._ask(reader, writer, Ask("QT"))
            parameters = Parameters.of(await self._ask(reader, writer, Ask("PP")))
            request = Measure("MD", parameters.first, parameters.last, 1)
            answer = await self._ask(reader, writer, request)
            if not answer.is_good:
                raise LinkError(
                    f"the scanner at {self._where} does not measure (status {answer.status})"
                )
            self.parameters, self._stamp, self._problem = parameters, -1, ""
            while True:
                found = measurement_of(await self._reply(reader))
                if found is not None:
                    self._hand_on(found, parameters, sink)
        except (asyncio.IncompleteReadError, OSError) as error:
            raise LinkError(f"the connection to {self._where} was lost") from error
        finally:
            writer.transport.abort()

    def _hand_on(self, found: Measurement, parameters: Parameters, sink: Sink) -> None:
        if len(found.ranges) != parameters.beams:
            raise WireError(
                f"a scan of {len(found.ranges)} beams where {parameters.beams} were asked for"
            )
        if found.stamp == self._stamp:
            self.stale += 1
            return
        now = self._clock.now()
        self._stamp, self._scan_at = found.stamp, now
        self.scans += 1
        sink(scan_of(found.ranges, parameters, self._config, now))

    async def _connect(self) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
        try:
            async with asyncio.timeout(_CONNECT_TIMEOUT):
                reader, writer = await asyncio.open_connection(
                    self._config.address, self._config.port, limit=LONGEST
                )
        except (OSError, UnicodeError) as error:
            raise LinkError(
                f"nobody answers at {self._where}; is the scanner on, and in this network?"
            ) from error
        writer.get_extra_info("socket").setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return reader, writer

    async def _ask(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, request: Request
    ) -> Reply:
        """Send a request and return its reply; replies to anything else before it are dropped."""
        line = encode_request(request)
        writer.write(line)
        for _ in range(_BETWEEN):
            reply = await self._reply(reader)
            if f"{reply.echo}\n".encode() == line and reply.status != "99":
                return reply
        raise WireError(f"no reply to {line[:2].decode()}")

    async def _reply(self, reader: asyncio.StreamReader) -> Reply:
        try:
            async with asyncio.timeout(_SILENCE):
                return decode_reply(await reader.readuntil(b"\n\n"))
        except TimeoutError as error:
            raise LinkError(f"connected to {self._where}, but it is silent") from error
        except asyncio.LimitOverrunError as error:
            raise WireError("a reply without an end") from error


def scan_of(
    ranges: tuple[int, ...], parameters: Parameters, config: LaserConfig, received_at: float
) -> Scan:
    """Return a scan in metres; distances that the scanner cannot measure, its error codes among
    them, become infinite.

    Args:
        ranges: one number a beam [mm].
        parameters: what the scanner says of itself.
        config: its name and latency.
        received_at: [s].
    """
    metres = tuple(
        mm / 1000.0 if parameters.shortest <= mm <= parameters.longest else inf for mm in ranges
    )
    captured_at = received_at - config.latency
    return Scan(
        config.name, captured_at, received_at, parameters.first_angle, parameters.step, metres
    )
