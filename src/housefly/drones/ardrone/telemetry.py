"""The drone's reports: UDP port 5554 to the newest ``Telemetry``.

The socket is connected, so only the drone is heard; who speaks in its name may neither jump ahead,
so that the drone itself would count as late, nor keep the loop busy. Full navdata comes 200 times a
second; each packet is checked at once, and converted to ``Telemetry`` when someone reads it or the
next one comes: wrong echoes are told from right ones by what is before and after them.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import replace
from math import isfinite, nan

from housefly.bus.rate import Frequency
from housefly.clock import Clock
from housefly.drones.ardrone.link import open_datagram_socket
from housefly.errors import WireError
from housefly.messages import Telemetry
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.wires.ardrone.conversions import hears_us, telemetry_from_navdata
from housefly.wires.ardrone.navdata import (
    NAVDATA_PORT,
    REQUEST_UNICAST,
    NavdataPacket,
    decode_navdata,
)

NAVDATA_TIMEOUT = 0.25
"""After this long without a report we ask again, and accept any sequence number next [s]."""
SEQUENCE_JUMP_MAX = 1000
"""A packet further ahead of the one before is refused, unless there was a silence: 5 s of them."""
PACKETS_MAX = 600
"""More datagrams in a second are thrown away unread; the drone sends 200."""
STEP_MIN = 0.15
"""A drone moves less than this between two echoes [m]: more is a step below it, or wrong."""
PING_PERIOD_MAX = 0.05
"""A height that is told for longer than this was measured again [s]: there are 22 or 25 a second,
and each is repeated in the reports that follow.
"""

PacketCondition = Callable[[NavdataPacket], bool]


class NavdataReports:
    """Keeps the newest report; refuses broken and old datagrams. Pure.

    Attributes:
        packet: the newest good packet.
        received_at: when it came [s].
        broken: number of malformed datagrams.
        old: number of packets that came late or twice, or from too far ahead.
        unread: number of datagrams thrown away because there were too many.
    """

    def __init__(self) -> None:
        self.packet: NavdataPacket | None = None
        self.received_at = float("-inf")
        self.broken = 0
        self.old = 0
        self.unread = 0
        self._heard_since, self._heard = float("-inf"), 0
        self._packets = Frequency()
        self._telemetry: Telemetry | None = None
        self._echoes = EchoFilter()
        self._is_read = True

    def accept(self, datagram: bytes, now: float) -> bool:
        """Decode a datagram that came now [s]; return whether it holds a newer report."""
        if self._is_flooded(now):
            self.unread += 1
            return False
        try:
            packet = decode_navdata(datagram)
        except WireError:
            self.broken += 1
            return False
        if not self._is_newer(packet, now):
            self.old += 1
            return False
        self._read()
        self.packet, self.received_at, self._is_read = packet, now, False
        self._packets.add(now)
        return True

    def _is_flooded(self, now: float) -> bool:
        if now - self._heard_since > 1.0:
            self._heard_since, self._heard = now, 0
        self._heard += 1
        return self._heard > PACKETS_MAX

    def _is_newer(self, packet: NavdataPacket, now: float) -> bool:
        """After a silence any number is newer: the drone may have rebooted."""
        return (
            self.packet is None
            or 0 < packet.sequence - self.packet.sequence <= SEQUENCE_JUMP_MAX
            or now - self.received_at > NAVDATA_TIMEOUT
        )

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report with the demo option, in our units."""
        self._read()
        return self._telemetry

    def _read(self) -> None:
        if self._is_read or self.packet is None:
            return
        self._is_read = True
        # bootstrap packets carry no demo option: the last full report stands, and its age says so
        if self.packet.options:
            try:
                told = telemetry_from_navdata(self.packet, self.received_at)
                height = self._echoes.filtered(told.height, told.received_at)
                self._telemetry = replace(told, height=height)
            except WireError:
                self.broken += 1

    def rate_hz(self, now: float) -> float:
        """Return the number of reports in the second before now."""
        return self._packets.rate_hz(now)


class NavdataLink(asyncio.DatagramProtocol):
    """The socket to port 5554: requests reports, again after silence, and wakes those who wait.

    Attributes:
        reports: what was heard.
        on_report: called after each new report.
    """

    def __init__(self, address: str, clock: Clock) -> None:
        self.reports = NavdataReports()
        self._address = address
        self._clock = clock
        self._transport: asyncio.DatagramTransport | None = None
        self._requesting: asyncio.Task[None] | None = None
        self.on_report: Callable[[], None] = lambda: None
        self._waiters: dict[asyncio.Future[NavdataPacket], PacketCondition] = {}

    async def open(self) -> None:
        """Open the socket and start asking; raises LinkError when the address cannot be used."""
        if self._transport is not None:
            return
        self._transport = await open_datagram_socket(self, self._address, NAVDATA_PORT)
        self._requesting = asyncio.create_task(self._request_when_silent(), name="navdata requests")

    async def close(self) -> None:
        """Close the socket."""
        if self._requesting is not None:
            self._requesting.cancel()
            await asyncio.gather(self._requesting, return_exceptions=True)
        if self._transport is not None:
            self._transport.abort()
        self._requesting = self._transport = None

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        return self._clock.now() - self.reports.received_at < REPORT_AGE_MAX

    @property
    def hears_us(self) -> bool:
        """Whether the drone receives our commands; assumed unless a recent report denies it."""
        packet = self.reports.packet
        return packet is None or not self.connected or hears_us(packet)

    async def wait_for(
        self, condition: PacketCondition, timeout: float | None
    ) -> NavdataPacket | None:
        """Return the next report that meets the condition, or None after the timeout [s]."""
        future: asyncio.Future[NavdataPacket] = asyncio.get_running_loop().create_future()
        self._waiters[future] = condition
        try:
            # asyncio.wait_for of Python 3.11 returns in place of ending when it is cancelled late
            async with asyncio.timeout(timeout):
                return await future
        except TimeoutError:
            return None
        finally:
            self._waiters.pop(future, None)

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Accept a datagram of the drone."""
        if not self.reports.accept(data, self._clock.now()):
            return
        packet = self.reports.packet
        assert packet is not None
        self.on_report()
        for future, condition in tuple(self._waiters.items()):
            if not future.done() and condition(packet):
                future.set_result(packet)

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens yet: we ask again."""

    async def _request_when_silent(self) -> None:
        assert self._transport is not None
        while True:
            if self._clock.now() - self.reports.received_at > NAVDATA_TIMEOUT:
                self._transport.sendto(REQUEST_UNICAST)
            await asyncio.sleep(NAVDATA_TIMEOUT)


class EchoFilter:
    """Raw ultrasound without single wrong echoes: a jump counts once the next echo says so, too.

    A jump is late by one echo, all else is not.
    """

    def __init__(self) -> None:
        self._believed, self._newest, self._newest_at = nan, nan, nan

    def filtered(self, height: float, at: float) -> float:
        """Return the height that is believed [m] after a report of a time [s]."""
        if height == self._newest and at - self._newest_at < PING_PERIOD_MAX:
            return self._believed
        before, self._newest, self._newest_at = self._newest, height, at
        is_first = not isfinite(self._believed)
        if is_first or min(abs(height - self._believed), abs(height - before)) <= STEP_MIN:
            self._believed = height
        return self._believed
