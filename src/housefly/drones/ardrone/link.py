"""The command socket: AT commands to UDP port 5556, numbered."""

from __future__ import annotations

import asyncio

from housefly.clock import Clock
from housefly.drones.ardrone.sequence_numbers import SequenceNumbers
from housefly.errors import LinkError
from housefly.wires.ardrone import at


class CommandLink(asyncio.DatagramProtocol):
    """Sends datagrams of commands; never receives any.

    Attributes:
        numbers: sequence numbers of all commands on this link.
        datagrams: number sent.
    """

    def __init__(self, address: str, clock: Clock) -> None:
        self.numbers = SequenceNumbers()
        self.datagrams = 0
        self._address = address
        self._clock = clock
        self._transport: asyncio.DatagramTransport | None = None

    async def open(self) -> None:
        """Open the socket; raises LinkError when the address cannot be used."""
        if self._transport is not None:
            return
        self._transport = await open_datagram_socket(self, self._address, at.COMMAND_PORT)

    @property
    def is_open(self) -> bool:
        """Whether ``send`` goes anywhere."""
        return self._transport is not None

    def send(self, *commands: at.AtCommand) -> None:
        """Send commands as one datagram at once; without a socket they are dropped."""
        if self._transport is None:
            return
        first = self.numbers.reserve(len(commands), self._clock.now())
        self._transport.sendto(at.encode_datagram(first, commands))
        self.datagrams += 1

    def close(self) -> None:
        """Close the socket."""
        if self._transport is not None:
            self._transport.abort()
            self._transport = None

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens yet: commands are repeated anyway."""


async def open_datagram_socket(
    protocol: asyncio.DatagramProtocol, address: str, port: int
) -> asyncio.DatagramTransport:
    """Connect a protocol to a port of the drone; raises LinkError if the address is unusable."""
    loop = asyncio.get_running_loop()
    try:
        transport, _ = await loop.create_datagram_endpoint(
            lambda: protocol, remote_addr=(address, port)
        )
    except OSError as error:
        raise LinkError(
            f"cannot open a socket to {address}:{port}: {error.strerror or error}"
        ) from error
    return transport


def led_value(animation: int, frequency_hz: float, seconds: int) -> str:
    """Return the value of ``leds:leds_anim``: animation, frequency as float bits, duration [s]."""
    return f"{animation},{at.float_to_bits(frequency_hz)},{seconds}"
