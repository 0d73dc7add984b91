"""A simulated scanning range finder on its real wire: a SCIP server, as Hokuyo's sensors are.

It measures only while its laser is on; MD turns it on, QT and RS turn it off. Facts and sources:
docs/wires.md.
"""

from __future__ import annotations

import asyncio
from collections.abc import Sequence

from housefly.errors import LinkError, WireError
from housefly.wires.scip import (
    MeasureRequest,
    PlainRequest,
    ScannerParameters,
    ScipReply,
    decode_request,
    encode_reply,
    measurement_reply,
)
from housefly.wires.scip.parameters import named_values_reply
from housefly.wires.scip.replies import STATUS_DONE, remaining
from housefly.wires.scip.requests import MAX_REQUEST

_LASER_IS_ON, _BEYOND_LAST_STEP, _WRONG_ORDER, _LASER_IS_OFF, _UNKNOWN_COMMAND = (
    "02",
    "04",
    "05",
    "10",
    "0E",
)
"""Status codes of the manual."""
_MAX_CLIENTS = 8
_BACKLOG = 64 * 1024
"""Bytes that may wait for a slow client; about twenty scans."""


class LaserServer:
    """Serves one scanner to any number of clients; a slow client never delays the others.

    Attributes:
        lost: scans not sent, summed over clients that were too slow.
        malformed: requests that could not be read.
    """

    def __init__(
        self,
        parameters: ScannerParameters,
        address: str = "127.0.0.1",
        port: int = 10940,
        serial: str = "H0000001",
    ) -> None:
        self.lost = 0
        self.malformed = 0
        self._parameters, self._serial = parameters, serial
        self._address, self._port = address, port
        self._clients: set[_Client] = set()
        self._is_on = False
        self._stamp = 0
        self._ranges: tuple[int, ...] = (0,) * parameters.beams
        self._server: asyncio.Server | None = None

    @property
    def clients(self) -> int:
        """How many clients are connected."""
        return len(self._clients)

    @property
    def is_measuring(self) -> bool:
        """Whether the laser is on, because somebody wants scans."""
        return self._is_on

    async def start(self) -> None:
        """Listen; raises LinkError when the address cannot be used."""
        try:
            self._server = await asyncio.start_server(
                self._serve, self._address, self._port, limit=MAX_REQUEST
            )
        except OSError as error:
            raise LinkError(
                f"cannot serve SCIP at {self._address}:{self._port}: {error.strerror or error}"
            ) from error

    async def stop(self) -> None:
        """Close the port and every connection."""
        if self._server is None:
            return
        self._server.close()
        for client in tuple(self._clients):
            client.close()
        while self._clients:
            # Each connection's task ends by itself; a loop that closes first would complain.
            await asyncio.sleep(0)
        await self._server.wait_closed()
        self._server = None

    def publish(self, ranges: Sequence[int], stamp: int) -> None:
        """Pass a scan to every client that waits for one; returns at once.

        Args:
            ranges: one per step [mm].
            stamp: the sensor's time [ms].
        """
        self._ranges, self._stamp = tuple(ranges), stamp
        for client in self._clients:
            request = client.next_scan()
            if request is not None:
                self.lost += not client.offer(self._scan(request))

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        client = _Client(writer)
        if len(self._clients) >= _MAX_CLIENTS:
            client.close()
            return
        self._clients.add(client)
        try:
            while True:
                line = (await reader.readuntil(b"\n")).rstrip(b"\r\n")
                if line:
                    client.offer(self._answer(client, line))
        except (asyncio.IncompleteReadError, asyncio.LimitOverrunError, OSError):
            pass
        finally:
            self._clients.discard(client)
            client.close()

    def _answer(self, client: _Client, line: bytes) -> ScipReply:
        echo = line.decode("ascii", errors="replace").replace("�", "?")
        try:
            request = decode_request(line)
        except WireError:
            self.malformed += 1
            return ScipReply(echo, _UNKNOWN_COMMAND)
        if isinstance(request, PlainRequest):
            return self._asked(client, request, echo)
        problem = self._problem(request)
        if problem:
            return ScipReply(echo, problem)
        if request.code == "GD":
            return self._scan(request)
        self._is_on = True
        client.measure(request)
        return ScipReply(echo, STATUS_DONE)

    def _asked(self, client: _Client, request: PlainRequest, echo: str) -> ScipReply:
        if request.code in ("QT", "RS"):
            client.wanted, self._is_on = (
                None,
                any(other.wanted for other in self._clients if other is not client),
            )
            return ScipReply(echo, STATUS_DONE)
        if request.code == "BM":
            was_on, self._is_on = self._is_on, True
            return ScipReply(echo, _LASER_IS_ON if was_on else STATUS_DONE)
        lines = {"PP": self._parameters.reply, "VV": self._version, "II": self._state}[
            request.code
        ]().lines
        return ScipReply(echo, STATUS_DONE, lines)

    def _problem(self, request: MeasureRequest) -> str:
        if request.last > self._parameters.last or request.first < self._parameters.first:
            return _BEYOND_LAST_STEP
        if request.last < request.first:
            return _WRONG_ORDER
        return _LASER_IS_OFF if request.code == "GD" and not self._is_on else ""

    def _scan(self, request: MeasureRequest) -> ScipReply:
        asked = self._ranges[
            request.first - self._parameters.first : request.last - self._parameters.first + 1
        ]
        width = max(request.cluster, 1)
        if width > 1:
            asked = tuple(min(asked[at : at + width]) for at in range(0, len(asked), width))
        return measurement_reply(request, self._stamp, asked)

    def _version(self) -> ScipReply:
        product = f"SOKUIKI Sensor {self._parameters.model.partition('(')[0]}"
        pairs = [
            ("VEND", "Hokuyo Automatic Co.,Ltd."),
            ("PROD", product),
            ("FIRM", "1.0.0(twin)"),
            ("PROT", "SCIP 2.2"),
        ]
        return named_values_reply("VV", [*pairs, ("SERI", self._serial)])

    def _state(self) -> ScipReply:
        laser, mode = ("ON", "001 Measuring") if self._is_on else ("OFF", "000 Idle")
        pairs = [
            ("MODL", self._parameters.model),
            ("LASR", laser),
            ("SCSP", f"{self._parameters.rpm}"),
            ("MESM", mode),
        ]
        pairs += [
            ("SBPS", "Ethernet 100 [Mbps]"),
            ("TIME", f"{self._stamp % (1 << 24):06X}"),
            ("STAT", "Sensor works well."),
        ]
        return named_values_reply("II", pairs)


class _Client:
    """One connection, its request and its send queue."""

    def __init__(self, writer: asyncio.StreamWriter) -> None:
        self.wanted: MeasureRequest | None = None
        self._skipping = 0
        self._writer = writer

    def measure(self, request: MeasureRequest) -> None:
        """Want scans from now on."""
        self.wanted, self._skipping = request, 0

    def next_scan(self) -> MeasureRequest | None:
        """Return the request that this scan answers, with the scans still to come, or None."""
        request = self.wanted
        if request is None:
            return None
        if self._skipping:
            self._skipping -= 1
            return None
        self._skipping = request.skip
        left = remaining(request, max(request.count - 1, 0))
        self.wanted = None if request.count == 1 else left
        return left

    def offer(self, reply: ScipReply) -> bool:
        """Send a reply unless too much waits already; returns whether it was taken."""
        if self._writer.is_closing() or self._writer.transport.get_write_buffer_size() > _BACKLOG:
            return False
        self._writer.write(encode_reply(reply))
        return True

    def close(self) -> None:
        """Drop the connection with whatever waits for it."""
        self._writer.transport.abort()
