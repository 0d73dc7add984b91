"""One CRTP packet: a port, a channel and up to 31 bytes; over UDP a datagram is one packet.

Source: bitcraze/crazyflie-firmware, docs/functional-areas/crtp. All numbers are little-endian.
"""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

from housefly.errors import WireError

UDP_PORT = 19850
"""Where a Crazyflie on UDP answers; clients look for ten from here on."""
DATA_MAX = 31
"""Most bytes behind the header: the drone's own name is as long, all else stays at 30."""
NULL_PACKET = b"\xff"
"""Asks whether somebody is there, and answers it."""
_LINK_BITS = 0x0C
"""Of the header: whoever sends sets them, whoever reads leaves them out."""


class Port(IntEnum):
    """What a packet is about."""

    CONSOLE = 0
    PARAMETERS = 2
    COMMANDER = 3
    MEMORY = 4
    LOG = 5
    LOCALIZATION = 6
    GENERIC_SETPOINT = 7
    HIGH_LEVEL = 8
    SUPERVISOR = 9
    PLATFORM = 13
    LINK = 15


class Packet(NamedTuple):
    """One packet.

    Attributes:
        port: 0 to 15.
        channel: 0 to 3.
        data: what is behind the header.
    """

    port: int
    channel: int
    data: bytes = b""


def encode_crtp(packet: Packet) -> bytes:
    """Return the bytes of a packet; raises WireError for one that cannot be."""
    port, channel, data = packet
    if not (0 <= port <= 15 and 0 <= channel <= 3 and len(data) <= DATA_MAX):
        raise WireError(
            f"no packet: port {port}, channel {channel}, {len(data)} bytes; allowed: 0 to 15, 0 to"
            f" 3, {DATA_MAX} or less"
        )
    return bytes((port << 4 | _LINK_BITS | channel,)) + data


def decode_crtp(datagram: bytes) -> Packet:
    """Return the packet in a datagram.

    Raises:
        WireError: it is empty, or longer than a packet.
    """
    if not 1 <= len(datagram) <= DATA_MAX + 1:
        raise WireError(f"a datagram of {len(datagram)} bytes; allowed: 1 to {DATA_MAX + 1}")
    header = datagram[0]
    return Packet(header >> 4, header & 0x03, datagram[1:])


def is_null(packet: Packet) -> bool:
    """Return whether a packet says nothing."""
    return packet.port == Port.LINK and packet.channel == 3
