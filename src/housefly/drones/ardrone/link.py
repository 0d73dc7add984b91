"""The command socket: AT commands to UDP port 5556, numbered."""

from __future__ import annotations

import asyncio

from housefly.clock import Clock
from housefly.errors import LinkError
from housefly.wires.ardrone import at

SESSION_TIMEOUT = 2.0
"""After this long without a command the drone has forgotten us, and numbers restart [s]."""
_UNHEARD_MAX = 0.3
"""How long the drone may report missing commands while we send them, before numbers restart [s].

Long enough that a few lost datagrams do not count: when the datagram of the restart itself is lost,
commands are refused until the next restart.
"""


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


class SequenceNumbers:
    """Numbers commands; one instance for the life of a link.

    A drone obeys a command only when its number is above the last one obeyed; 1 always counts
    (docs/wires.md, section 4).
    """

    def __init__(self) -> None:
        self._next = 1
        self._last_at: float | None = None
        self._received_at: float = 0.0

    def reserve(self, count: int, now: float) -> int:
        """Return the first of ``count`` numbers to use now [s]."""
        if self._last_at is None or now - self._last_at > SESSION_TIMEOUT:
            self._restart(now)
        first = self._next
        self._next += count
        self._last_at = now
        return first

    def report_reception(self, received: bool, now: float) -> None:
        """Note whether the drone's newest report shows that it receives our commands."""
        if received:
            self._received_at = now
        elif self._last_at is not None and now - self._received_at > _UNHEARD_MAX:
            self._restart(now)

    def _restart(self, now: float) -> None:
        self._next = 1
        self._received_at = now
