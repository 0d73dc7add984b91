"""A pseudo-terminal whose other end is a TCP stream: for what speaks to serial ports alone."""

from __future__ import annotations

import asyncio
import os
import socket
import tty
from collections.abc import Iterator
from contextlib import contextmanager, suppress


@contextmanager
def serial_bridge(address: str, port: int) -> Iterator[str]:
    """Yield the file of a serial port that leads to a stream; within an asyncio loop."""
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    os.set_blocking(ours, False)
    loop = asyncio.get_running_loop()
    stream = socket.create_connection((address, port))
    stream.setblocking(False)

    def up() -> None:
        with suppress(OSError):
            stream.send(os.read(ours, 4096))

    def down() -> None:
        with suppress(OSError):
            os.write(ours, stream.recv(4096))

    loop.add_reader(ours, up)
    loop.add_reader(stream, down)
    try:
        yield os.ttyname(theirs)
    finally:
        loop.remove_reader(ours)
        loop.remove_reader(stream)
        stream.close()
        os.close(ours)
        os.close(theirs)
