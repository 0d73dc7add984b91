"""A client of one scanning range finder."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress
from math import inf

import numpy as np

from housefly.bus.reconnect import ReconnectingClient, open_tcp, within
from housefly.clock import Clock
from housefly.config.laser import LaserConfig
from housefly.errors import LinkError, WireError
from housefly.messages import Scan
from housefly.messages.words import UNSAID, Words
from housefly.numeric import FloatArray
from housefly.sensors.scan_clock import ScanClock
from housefly.wires.scip import (
    MeasureRequest,
    PlainRequest,
    ScannerParameters,
    ScipReply,
    ScipRequest,
    ScipScan,
    decode_measurement,
    decode_reply,
    encode_request,
    older_scip,
)
from housefly.wires.scip.replies import MAX_REPLY

_CONNECT_TIMEOUT = 2.0
_BETWEEN = 20
"""Replies to earlier requests that may come before the one waited for."""
_READ = 256 * 1024
"""Bytes read at once; what waits on a busy machine is passed over in few steps."""
_END = b"\n\n"
"""Ends a reply."""
_OLD_VERSION_REQUEST, _OLD_TIMEOUT = b"V\n", 1.0
"""What scanners from before SCIP 2.0 answer with their version, and how soon [s]."""


class LaserClient(ReconnectingClient[Scan]):
    """Asks one scanner what it is, has it measure, and hands every scan to a sink.

    Attributes:
        scans: how many were handed on.
        stale: scans dropped because the scanner's clock stood still.
        overtaken: scans dropped because a newer one had arrived before they were read.
        parameters: what the scanner says of itself, None before it did.
    """

    SILENCE_TIMEOUT = 3.0

    def __init__(self, config: LaserConfig, clock: Clock | None = None) -> None:
        super().__init__(f"{config.address}:{config.port}", clock)
        self.scans = self.stale = self.overtaken = 0
        self.parameters: ScannerParameters | None = None
        self._config = config
        self._stamp, self._scan_clock, self._unread = -1, ScanClock(), b""

    def _no_data_problem(self) -> Words:
        return Words("connected to {name}, but no scans arrive", name=self._where)

    def _protocol_problem(self, error: WireError) -> Words:
        return Words(
            "what answers at {name} does not speak {protocol} ({error})",
            name=self._where,
            protocol="SCIP",
            error=str(error),
        )

    async def _read_connection(self, sink: Callable[[Scan], None]) -> None:
        stream = await open_tcp(
            self._config.address,
            self._config.port,
            _CONNECT_TIMEOUT,
            Words(
                "nobody answers at {name}; is it switched on, and in this network?",
                name=self._where,
            ),
            limit=MAX_REPLY,
        )
        async with self._open(stream) as (reader, writer):
            await self._greet(reader, writer)
            parameters = ScannerParameters.of(await self._ask(reader, writer, PlainRequest("PP")))
            request = MeasureRequest("MD", parameters.first, parameters.last, 1)
            answer = await self._ask(reader, writer, request)
            if not answer.is_good:
                raise LinkError(
                    f"the scanner at {self._where} does not measure (status {answer.status})"
                )
            self.parameters, self._stamp, self._problem = parameters, -1, UNSAID
            self._scan_clock, self._unread = ScanClock(), b""
            while True:
                found = decode_measurement(await self._newest_reply(reader))
                if found is not None:
                    self._hand_on(found, parameters, sink)

    async def _greet(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """End what an earlier client began; raises LinkError, that of an older protocol too."""
        try:
            await self._ask(reader, writer, PlainRequest("QT"))
        except LinkError as error:
            writer.write(_OLD_VERSION_REQUEST)
            block = b""
            with suppress(LinkError, asyncio.LimitOverrunError, asyncio.IncompleteReadError):
                block = await within(_OLD_TIMEOUT, reader.readuntil(_END), "")
            if version := older_scip(block):
                raise LinkError(self._older(version)) from error
            raise

    def _older(self, version: str) -> str:
        return (
            f"the scanner at {self._where} speaks {version}; Housefly speaks SCIP 2.0 and newer:"
            " switch it over with its command SCIP2.0, or update its firmware"
        )

    def _hand_on(
        self, found: ScipScan, parameters: ScannerParameters, sink: Callable[[Scan], None]
    ) -> None:
        if len(found.ranges) != parameters.beams:
            raise WireError(
                f"a scan of {len(found.ranges)} beams where {parameters.beams} were asked for"
            )
        if found.stamp == self._stamp:
            self.stale += 1
            return
        now = self._clock.now()
        self._stamp = found.stamp
        self._data_arrived(now)
        self.scans += 1
        taken_at = self._scan_clock.taken_at(found.stamp, now)
        sink(scan_of(found.ranges, parameters, self._config, taken_at, now))

    async def _ask(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, request: ScipRequest
    ) -> ScipReply:
        """Send a request and return its reply; replies to anything else before it are dropped."""
        line = encode_request(request)
        writer.write(line)
        for _ in range(_BETWEEN):
            reply = await self._reply(reader)
            if f"{reply.echo}\n".encode() == line and reply.status != "99":
                return reply
        raise WireError(f"no reply to {line[:2].decode()}")

    async def _reply(self, reader: asyncio.StreamReader) -> ScipReply:
        try:
            block = await self._before_silence(reader.readuntil(_END))
        except asyncio.LimitOverrunError as error:
            raise WireError("a reply without an end") from error
        try:
            return decode_reply(block)
        except WireError as error:
            if version := older_scip(block):
                raise LinkError(self._older(version)) from error
            raise

    async def _newest_reply(self, reader: asyncio.StreamReader) -> ScipReply:
        """Return the newest whole reply that arrived: those before it show what was."""
        while True:
            whole, end, rest = self._unread.rpartition(_END)
            if end:
                self._unread = rest
                self.overtaken += whole.count(_END)
                return decode_reply(whole.rpartition(_END)[2] + _END)
            if len(rest) > MAX_REPLY:
                raise WireError("a reply without an end")
            arrived = await self._before_silence(reader.read(_READ))
            if not arrived:
                raise asyncio.IncompleteReadError(rest, None)
            self._unread += arrived

    async def _before_silence(self, reading: Awaitable[bytes]) -> bytes:
        return await self._before_timeout(reading, f"connected to {self._where}, but it is silent")


def scan_of(
    ranges: tuple[int, ...],
    parameters: ScannerParameters,
    config: LaserConfig,
    taken_at: float,
    received_at: float,
) -> Scan:
    """Return a scan in metres; out-of-range distances and error codes become infinite.

    Args:
        ranges: one number per beam [mm].
        parameters: as reported by the scanner.
        config: its name and latency.
        taken_at: when it left the scanner [s].
        received_at: [s].
    """
    captured_at = taken_at - config.latency
    metres = tuple(metres_of(ranges, parameters).tolist())
    return Scan(
        config.name, captured_at, received_at, parameters.first_angle, parameters.step, metres
    )


def metres_of(ranges: tuple[int, ...], parameters: ScannerParameters) -> FloatArray:
    """Return the distances of a scan [m], one per beam; infinite where there is none.

    Args:
        ranges: one number per beam [mm].
        parameters: as reported by the scanner.
    """
    mm = np.fromiter(ranges, np.int64, len(ranges))
    is_distance = (mm >= parameters.shortest) & (mm <= parameters.longest)
    return np.where(is_distance, mm / 1000.0, inf)
