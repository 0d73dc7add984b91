"""CRTP over UDP: a datagram is a packet."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.errors import LinkError, WireError
from housefly.wires.crazyflie.crtp import UDP_PORT, Packet, decode_crtp, encode_crtp


class UdpWire(asyncio.DatagramProtocol):
    """The socket to one drone; all calls belong to one asyncio loop.

    Args:
        address: IP address of the drone.
        hear: what takes every packet of the drone.

    Attributes:
        name: where the drone is.
        broken: datagrams that were no packets.
        problem: what is wrong with the wire itself: nothing that can be known.
    """

    problem = ""

    def __init__(self, address: str, hear: Callable[[Packet], None]) -> None:
        self.name, self.broken = f"{address}:{UDP_PORT}", 0
        self._address, self._hear = address, hear
        self._transport: asyncio.DatagramTransport | None = None

    @property
    def is_open(self) -> bool:
        """Whether ``send`` goes anywhere."""
        return self._transport is not None

    async def open(self) -> None:
        """Open the socket; raises LinkError when the address cannot be used."""
        if self._transport is not None:
            return
        there, loop = (self._address, UDP_PORT), asyncio.get_running_loop()
        try:
            self._transport, _ = await loop.create_datagram_endpoint(
                lambda: self, remote_addr=there
            )
        except OSError as error:
            raise LinkError(
                f"cannot open a socket to {self.name}: {error.strerror or error}"
            ) from error

    async def close(self) -> None:
        """Close the socket."""
        if self._transport is not None:
            self._transport.abort()
            self._transport = None

    def send(self, packet: Packet) -> None:
        """Send a packet at once; without a socket it is dropped."""
        if self._transport is not None:
            self._transport.sendto(encode_crtp(packet))

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Take in a packet of the drone; anything else is counted."""
        try:
            packet = decode_crtp(data)
        except WireError:
            self.broken += 1
            return
        self._hear(packet)

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens yet: we ask again."""
