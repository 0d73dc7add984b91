"""Holds the port of the STOP path for this user, also while no pilot listens there."""

from __future__ import annotations

import socket
import weakref


class StopPort:
    """A UDP port of loopback that no other user can take while this object exists.

    Its socket shares the port (``SO_REUSEPORT``, which the kernel grants to one user only) and is
    connected to itself: what others send goes to whichever pilot listens, or to nobody.

    Attributes:
        number: of the port.
    """

    def __init__(self) -> None:
        held = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        weakref.finalize(self, held.close)
        held.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        held.bind(("127.0.0.1", 0))
        held.connect(held.getsockname())
        self.number = int(held.getsockname()[1])
