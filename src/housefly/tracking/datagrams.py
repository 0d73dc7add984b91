"""Datagram sockets of the tracking clients."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

SocketAddress = tuple[str, int]
_RECEIVE_BUFFER = 256 * 1024
"""Receive buffer of the kernel [bytes]; a larger one would only hold older data."""
_AT_ONCE, _LONGEST = 64, 64 * 1024
"""Datagrams read in one turn of the loop, and bytes of the longest."""


class DatagramReceiver(asyncio.DatagramProtocol):
    """Hands datagrams to a function and remembers whether the network refused the last one sent.

    All that wait are read in one turn: asyncio reads one, and in a loop whose turns are long for
    want of processor time, poses of seconds ago would wait in the kernel and look new.

    Args:
        on_datagram: called with each datagram and its sender.

    Attributes:
        refused: whether the network reported that nobody listens there.
    """

    def __init__(self, on_datagram: Callable[[bytes, SocketAddress], None]) -> None:
        self.refused = False
        self._on_datagram = on_datagram
        self._waiting: socket.socket | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Keep a way of our own to the socket."""
        self._waiting = transport.get_extra_info("socket").dup()

    def connection_lost(self, exc: Exception | None) -> None:
        """Close it."""
        if self._waiting is not None:
            self._waiting.close()
            self._waiting = None

    def datagram_received(self, data: bytes, addr: SocketAddress) -> None:
        """Pass a datagram on, and those that wait behind it."""
        self.refused = False
        self._on_datagram(data, addr)
        for _ in range(_AT_ONCE - 1):
            if self._waiting is None:
                return
            try:
                waited, sender = self._waiting.recvfrom(_LONGEST)
            except BlockingIOError:
                return
            except OSError:  # asyncio will not hear of it any more
                self.refused = True
                return
            self._on_datagram(waited, sender)

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
