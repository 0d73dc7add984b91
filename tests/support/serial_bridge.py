"""A serial port that is a TCP stream: as a pseudo-terminal, and as Wi-Fi bridges make it."""

from __future__ import annotations

import asyncio
import os
import socket
import tty
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager, suppress


@contextmanager
def serial_bridge(address: str, port: int) -> Iterator[str]:
    """Yield the file of a serial port that leads to a stream; within an asyncio loop."""
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    os.set_blocking(ours, False)
    with ExitStack() as stack:
        for end in (ours, theirs):
            stack.callback(os.close, end)
        stream = stack.enter_context(closing(_stream(address, port)))

        def up() -> None:
            stream.send(os.read(ours, 4096))

        def down() -> None:
            os.write(ours, stream.recv(4096))

        with _carried(ours, up), _carried(stream, down):
            yield os.ttyname(theirs)


@contextmanager
def udp_bridge(address: str, port: int, udp_port: int) -> Iterator[None]:
    """Carry datagrams to a stream, and back to who sent the last one; within an asyncio loop."""
    client = (address, 0)
    datagrams = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    datagrams.setblocking(False)
    datagrams.bind((address, udp_port))
    with closing(_stream(address, port)) as stream, closing(datagrams):

        def up() -> None:
            nonlocal client
            data, client = datagrams.recvfrom(4096)
            stream.send(data)

        def down() -> None:
            datagrams.sendto(stream.recv(256), client)

        with _carried(datagrams, up), _carried(stream, down):
            yield


def _stream(address: str, port: int) -> socket.socket:
    stream = socket.create_connection((address, port))
    stream.setblocking(False)
    return stream


@contextmanager
def _carried(end: socket.socket | int, carry: Callable[[], object]) -> Iterator[None]:
    """Carry on what comes to an end."""

    def carry_or_not() -> None:
        with suppress(OSError):
            carry()

    loop = asyncio.get_running_loop()
    loop.add_reader(end, carry_or_not)
    try:
        yield
    finally:
        loop.remove_reader(end)
