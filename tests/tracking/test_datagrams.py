"""The datagrams of a tracking system in a loop that has little time for them."""

from __future__ import annotations

import asyncio
import socket

import pytest

from housefly.tracking.datagrams import DatagramReceiver

pytestmark = pytest.mark.wire
TURNS = 20


async def test_what_waits_is_read_in_few_turns_of_the_loop(loopback: str) -> None:
    heard: list[bytes] = []
    loop = asyncio.get_running_loop()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as server:
        server.bind((loopback, 0))
        transport, _ = await loop.create_datagram_endpoint(
            lambda: DatagramReceiver(lambda data, sender: heard.append(data)),
            remote_addr=server.getsockname(),
        )
        ours = transport.get_extra_info("sockname")
        for number in range(60):  # the loop does not turn meanwhile
            server.sendto(str(number).encode(), ours)
        for _ in range(TURNS):
            await asyncio.sleep(0)
        transport.abort()
        await asyncio.sleep(0)
    assert [int(data) for data in heard] == list(range(60))


async def test_a_server_that_is_gone_is_noticed(loopback: str) -> None:
    loop = asyncio.get_running_loop()
    receiver = DatagramReceiver(lambda data, sender: None)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as server:
        server.bind((loopback, 0))
        transport, _ = await loop.create_datagram_endpoint(
            lambda: receiver, remote_addr=server.getsockname()
        )
        server.sendto(b"last", transport.get_extra_info("sockname"))
    transport.sendto(b"hello")
    async with asyncio.timeout(8.0):
        while not receiver.refused:
            transport.sendto(b"hello")
            await asyncio.sleep(0.01)
    transport.abort()
    await asyncio.sleep(0)
