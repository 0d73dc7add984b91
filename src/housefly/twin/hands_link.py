"""How a program of this user has the simulated drone carried: a Unix socket, one order a datagram.

It lies in a folder that nobody else can enter.
"""

from __future__ import annotations

import asyncio
import socket
from contextlib import suppress
from pathlib import Path

from housefly.config.process_log import log_line
from housefly.errors import LinkError, WireError
from housefly.twin.hands import CarryOrder, decode_carry, encode_carry
from housefly.twin.world import SimulatedWorld

_DATAGRAM_MAX = 4096


class HandsLink:
    """Listens for orders to carry the drone; all calls belong to one asyncio loop.

    Args:
        world: whose drone is carried.
        path: of the socket; its folder must be private.
    """

    def __init__(self, world: SimulatedWorld, path: Path) -> None:
        self._world, self._path = world, path
        self._socket: socket.socket | None = None

    def start(self) -> None:
        """Listen; raises LinkError when that cannot be."""
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        try:
            self._socket.bind(str(self._path))
        except OSError as error:
            self._socket.close()
            raise LinkError(f"cannot listen at {self._path}: {error.strerror or error}") from error
        self._socket.setblocking(False)
        asyncio.get_running_loop().add_reader(self._socket.fileno(), self._read)

    def stop(self) -> None:
        """Listen no more."""
        if self._socket is not None:
            asyncio.get_running_loop().remove_reader(self._socket.fileno())
            self._socket.close()
            self._socket = None
            self._path.unlink(missing_ok=True)

    def _read(self) -> None:
        assert self._socket is not None
        with suppress(BlockingIOError):
            datagram = self._socket.recv(_DATAGRAM_MAX)
            try:
                self._world.carry_drone(decode_carry(datagram))
            except WireError as error:
                log_line(f"twin: {error}")


def send_carry(path: Path, order: CarryOrder) -> None:
    """Have the drone of a simulated room carried; raises LinkError when nobody listens."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as link:
        try:
            link.connect(str(path))
            link.send(encode_carry(order))
        except OSError as error:
            raise LinkError(
                f"the simulated room does not answer at {path}: {error.strerror or error}"
            ) from error
