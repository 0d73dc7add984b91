"""Datagram sockets of the tracking clients."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

Address = tuple[str, int]
_BUFFER = 256 * 1024
"""Bytes that the kernel may keep for us; more would only be older."""


class Ear(asyncio.DatagramProtocol):
    """Hands datagrams to a function; remembers the network's last complaint.

    Args:
        heard: called with each datagram and its sender.

    Attributes:
        refused: whether the network said that nobody listens there.
    """

    def __init__(self, heard: Callable[[bytes, Address], None]) -> None:
        self.refused = False
        self._heard = heard

    def datagram_received(self, data: bytes, addr: Address) -> None:
        """Pass a datagram on."""
        self.refused = False
        self._heard(data, addr)

    def error_received(self, exc: Exception) -> None:
        """Note that nobody listens."""
        self.refused = True


def multicast_receiver(group: str, port: int, interface: str) -> socket.socket:
    """Return a socket that has joined a group at one of our addresses; raises OSError."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        receiver.setblocking(False)
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _BUFFER)
        receiver.bind((group, port))
        membership = socket.inet_aton(group) + socket.inet_aton(interface)
        receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    except OSError:
        receiver.close()
        raise
    return receiver
