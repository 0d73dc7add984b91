"""Datagram sockets of the tracking clients."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

SocketAddress = tuple[str, int]
_RECEIVE_BUFFER = 256 * 1024
"""Receive buffer of the kernel [bytes]; a larger one would only hold older data."""


class DatagramReceiver(asyncio.DatagramProtocol):
    """Hands datagrams to a function and remembers whether the network refused the last one sent.

    Args:
        on_datagram: called with each datagram and its sender.

    Attributes:
        refused: whether the network reported that nobody listens there.
    """

    def __init__(self, on_datagram: Callable[[bytes, SocketAddress], None]) -> None:
        self.refused = False
        self._on_datagram = on_datagram

    def datagram_received(self, data: bytes, addr: SocketAddress) -> None:
        """Pass a datagram on."""
        self.refused = False
        self._on_datagram(data, addr)

    def error_received(self, exc: Exception) -> None:
        """Note that nobody listens."""
        self.refused = True


def multicast_receiver(group: str, port: int, interface: str) -> socket.socket:
    """Return a socket that has joined a group at one of our addresses; raises OSError."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        receiver.setblocking(False)
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _RECEIVE_BUFFER)
        receiver.bind((group, port))
        membership = socket.inet_aton(group) + socket.inet_aton(interface)
        receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    except OSError:
        receiver.close()
        raise
    return receiver
