"""UDP 5554 of the simulated drone: sends navdata to its client.

Navdata goes to the last requester, as on the real drone, from port 5554. Multicast requests are
answered like unicast ones. Two seconds without commands or requests end the stream; a new client
then finds the drone in bootstrap mode again.
"""

from __future__ import annotations

import asyncio

from housefly.bus.rate import Rate
from housefly.twin.address import PeerAddress
from housefly.twin.ardrone.link import LINK_LOST_AFTER, Link
from housefly.twin.ardrone.navdata_writer import NavdataWriter
from housefly.twin.contracts import TwinDrone
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.wires.ardrone.navdata import NAVDATA_PORT, REQUEST_MULTICAST, REQUEST_UNICAST

_FULL_RATE_HZ = 200.0
_DEMO_DIVIDER = 13
"""One packet of 13 in demo and bootstrap mode: 15 a second."""
_LONG_REQUEST_SIZE = 14
_REQUESTS = frozenset(
    {
        *(REQUEST_UNICAST[:size] for size in (1, 2, 4)),
        REQUEST_UNICAST.ljust(_LONG_REQUEST_SIZE, b"\0"),
        *(REQUEST_MULTICAST, b"Init"),
    }
)
"""What clients are known to ask with."""


class NavdataServer(asyncio.DatagramProtocol):
    """Sends reports at the real drone's rates from ``start`` to ``stop``."""

    def __init__(
        self,
        drone: TwinDrone,
        link: Link,
        writer: NavdataWriter,
        filters: LinkFilters = UNFILTERED,
    ) -> None:
        self._drone = drone
        self._reported, self._send = filters.reported, filters.downlink(self._transmit)
        self._link = link
        self._writer = writer
        self._lost_client: PeerAddress | None = None
        self._requested_at = 0.0
        self._congested = False
        self._transport: asyncio.DatagramTransport | None = None
        self._sending: asyncio.Task[None] | None = None

    async def start(self, address: str) -> None:
        """Open the port and begin to send; raises OSError when the address is taken."""
        loop = asyncio.get_running_loop()
        self._transport, _ = await loop.create_datagram_endpoint(
            lambda: self, local_addr=(address, NAVDATA_PORT)
        )
        self._sending = asyncio.create_task(self._send_forever(), name="navdata")
        self._sending.add_done_callback(_raise_unless_cancelled)

    async def stop(self) -> None:
        """End the stream and close the port."""
        if self._sending is not None:
            self._sending.cancel()
            await asyncio.gather(self._sending, return_exceptions=True)
        if self._transport is not None:
            self._transport.abort()

    def datagram_received(self, data: bytes, addr: PeerAddress) -> None:
        """Accept a client's request; count anything else."""
        if data not in _REQUESTS:
            self._link.counters.refused_requests += 1
            return
        if self._lost_client not in (None, addr) and self._is_silent():
            self._link.bootstrap = True
        self._lost_client = None
        self._link.client = addr
        self._requested_at = self._drone.now

    def error_received(self, exc: Exception) -> None:
        """Ignore a client that is gone; it may come back to the same port."""

    def pause_writing(self) -> None:
        """Stop sending: the kernel takes no more."""
        self._congested = True

    def resume_writing(self) -> None:
        """Send again."""
        self._congested = False

    async def _send_forever(self) -> None:
        rate = Rate(_FULL_RATE_HZ)
        tick = 0
        while True:
            await rate.sleep()
            tick += 1
            if self._writer.full or tick % _DEMO_DIVIDER == 0:
                self.send_report()

    def send_report(self) -> None:
        """Send one packet to the client, unless there is none or the kernel is full."""
        link = self._link
        if link.client is None or self._transport is None:
            return
        if self._is_silent():
            self._lost_client, link.client = link.client, None
            return
        if self._congested:
            link.counters.navdata_unsent += 1
            return
        self._send(self._writer.packet(self._reported(self._drone.onboard())))

    def _transmit(self, packet: bytes) -> None:
        if self._link.client is not None and self._transport is not None:
            self._transport.sendto(packet, self._link.client)
            self._link.counters.navdata_sent += 1

    def _is_silent(self) -> bool:
        now = self._drone.now
        return (
            self._link.silent_since(now, LINK_LOST_AFTER)
            and now - self._requested_at > LINK_LOST_AFTER
        )


def _raise_unless_cancelled(task: asyncio.Task[None]) -> None:
    """Pass the exception of a dead sender to the loop's exception handler."""
    if not task.cancelled():
        task.result()
