"""The drone's reports: UDP port 5554 into the newest Telemetry.

Only the pinned peer is heard (the socket is connected to it). Full navdata comes 200 times a
second; each packet is checked, but turned into Telemetry only when someone reads it.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable

from housefly.clock import Clock
from housefly.errors import LinkError, WireError
from housefly.messages import Telemetry
from housefly.wires.ardrone.navdata import (
    NAVDATA_PORT,
    REQUEST_UNICAST,
    DroneState,
    NavdataPacket,
    decode_navdata,
)
from housefly.wires.ardrone.signs import telemetry_from_navdata

SILENCE = 0.25
"""Without a report for this long we ask again, and the next report may have any number [s]."""
CONNECTED = 0.5
"""Reports count as arriving when the last one is younger than this [s]."""

Condition = Callable[[NavdataPacket], bool]


class Reports:
    """Takes datagrams, refuses what is broken or old, keeps the newest. Pure.

    Attributes:
        packet: the newest good packet.
        received_at: when it came [s].
        broken: datagrams that made no sense.
        old: packets that came late or twice.
    """

    def __init__(self) -> None:
        self.packet: NavdataPacket | None = None
        self.received_at = float("-inf")
        self.broken = 0
        self.old = 0
        self._times: deque[float] = deque()
        self._telemetry: Telemetry | None = None
        self._is_read = True

    def take(self, datagram: bytes, now: float) -> bool:
        """Take a datagram that came now [s] and return whether it is news."""
        try:
            packet = decode_navdata(datagram)
        except WireError:
            self.broken += 1
            return False
        if not self._is_news(packet, now):
            self.old += 1
            return False
        self._read()
        self.packet, self.received_at, self._is_read = packet, now, False
        self._times.append(now)
        self._forget_before(now - 1.0)
        return True

    def _is_news(self, packet: NavdataPacket, now: float) -> bool:
        """Tell whether it is newer than the last; after a silence any number is, for the drone may
        have started again.
        """
        return (
            self.packet is None
            or packet.sequence > self.packet.sequence
            or now - self.received_at > SILENCE
        )

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report that has the demo option, in our units."""
        self._read()
        return self._telemetry

    def _read(self) -> None:
        if self._is_read or self.packet is None:
            return
        self._is_read = True
        # bootstrap packets carry no demo option: the last full report stands, and its age says so
        if self.packet.options:
            try:
                self._telemetry = telemetry_from_navdata(self.packet, self.received_at)
            except WireError:
                self.broken += 1

    def rate_hz(self, now: float) -> float:
        """Return the number of reports in the second before now."""
        self._forget_before(now - 1.0)
        return float(len(self._times))

    def _forget_before(self, time: float) -> None:
        while self._times and self._times[0] <= time:
            self._times.popleft()


class NavdataPort(asyncio.DatagramProtocol):
    """The socket to port 5554: asks for reports, asks again in silence, wakes those who wait for a
    report.
    """

    def __init__(self, address: str, clock: Clock) -> None:
        self.reports = Reports()
        self._address = address
        self._clock = clock
        self._transport: asyncio.DatagramTransport | None = None
        self._asking: asyncio.Task[None] | None = None
        self._waiting: dict[asyncio.Future[NavdataPacket], Condition] = {}

    async def open(self) -> None:
        """Open the socket and start asking; raises LinkError when the address cannot be used."""
        if self._transport is not None:
            return
        loop = asyncio.get_running_loop()
        try:
            self._transport, _ = await loop.create_datagram_endpoint(
                lambda: self, remote_addr=(self._address, NAVDATA_PORT)
            )
        except OSError as error:
            raise LinkError(
                f"cannot open a socket to {self._address}:{NAVDATA_PORT}: {error.strerror or error}"
            ) from error
        self._asking = asyncio.create_task(self._ask_in_silence(), name="navdata requests")

    async def close(self) -> None:
        """Close the socket."""
        if self._asking is not None:
            self._asking.cancel()
            await asyncio.gather(self._asking, return_exceptions=True)
        if self._transport is not None:
            self._transport.abort()
        self._asking = self._transport = None

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        return self._clock.now() - self.reports.received_at < CONNECTED

    @property
    def hears_us(self) -> bool:
        """Whether the drone receives commands, as far as a fresh report tells."""
        packet = self.reports.packet
        return not (
            self.connected
            and packet is not None
            and packet.state & (DroneState.COM_WATCHDOG | DroneState.COM_LOST)
        )

    async def wait_for(self, condition: Condition, timeout: float | None) -> NavdataPacket | None:
        """Return the first report from now on that meets the condition, or None after the timeout
        [s].
        """
        future: asyncio.Future[NavdataPacket] = asyncio.get_running_loop().create_future()
        self._waiting[future] = condition
        try:
            return await asyncio.wait_for(future, timeout)
        except TimeoutError:
            return None
        finally:
            self._waiting.pop(future, None)

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Take a datagram of the drone."""
        if not self.reports.take(data, self._clock.now()):
            return
        packet = self.reports.packet
        assert packet is not None
        for future, condition in tuple(self._waiting.items()):
            if not future.done() and condition(packet):
                future.set_result(packet)

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens there yet: we ask again."""

    async def _ask_in_silence(self) -> None:
        assert self._transport is not None
        while True:
            if self._clock.now() - self.reports.received_at > SILENCE:
                self._transport.sendto(REQUEST_UNICAST)
            await asyncio.sleep(SILENCE)
