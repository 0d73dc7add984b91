"""STOP's own path."""

from __future__ import annotations

import asyncio
import contextlib
import resource
import socket
import subprocess
import sys
import threading
import time
from collections.abc import AsyncIterator
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus import stop as module
from housefly.bus.stop import StopListener
from housefly.bus.stop_sender import StopSender
from housefly.errors import ConfigError, LinkError, WireError

pytestmark = pytest.mark.wire
SECRET = "sixteen or more characters"


class Room:
    """A listener, and how often it was told to stop."""

    def __init__(self, address: str) -> None:
        self.stops = 0
        self.listener = StopListener(address, 0, SECRET, self._stop)

    def _stop(self) -> None:
        self.stops += 1


@pytest.fixture
async def room(loopback: str) -> AsyncIterator[Room]:
    room = Room(loopback)
    await room.listener.start()
    yield room
    room.listener.close()


def signed_stop(sent_ns: int, secret: str = SECRET, nonce: bytes = b"12345678") -> bytes:
    return module.StopToken(sent_ns, nonce).signed(module.STOP_MAGIC, secret.encode())


async def throw(room: Room, *datagrams: bytes) -> None:
    """Send raw datagrams and wait until the listener has surely read them."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as link:
        for datagram in datagrams:
            link.sendto(datagram, room.listener.address)
    await asyncio.wrap_future(StopSender(*room.listener.address, SECRET).send())
    room.stops -= 1


async def test_a_stop_arrives_once_and_is_acknowledged(room: Room) -> None:
    outcome = StopSender(*room.listener.address, SECRET).send()
    assert await asyncio.wrap_future(outcome)
    await asyncio.sleep(0.03)
    assert room.stops == 1


class FailingRoom(Room):
    """A listener whose handler fails so many times before it stops anything."""

    def __init__(self, address: str, failures: int) -> None:
        super().__init__(address)
        self.failures = failures

    def _stop(self) -> None:
        if self.failures:
            self.failures -= 1
            raise OSError("No space left on device")
        super()._stop()


async def test_a_stop_that_failed_is_tried_again_by_its_next_copy(loopback: str) -> None:
    room = FailingRoom(loopback, failures=2)
    await room.listener.start()
    assert await asyncio.wrap_future(StopSender(*room.listener.address, SECRET).send())
    await asyncio.sleep(0.03)
    room.listener.close()
    assert (room.stops, room.failures) == (1, 0)


async def test_a_stop_that_fails_is_not_acknowledged_and_the_next_one_is_heard(
    loopback: str, caplog: pytest.LogCaptureFixture
) -> None:
    room = FailingRoom(loopback, failures=1000)
    await room.listener.start()
    sender = StopSender(*room.listener.address, SECRET)
    assert not await asyncio.wrap_future(sender.send())
    assert "No space left on device" in caplog.text
    room.failures = 0
    assert await asyncio.wrap_future(sender.send())
    room.listener.close()
    assert room.stops == 1


async def test_each_stop_counts(room: Room) -> None:
    sender = StopSender(*room.listener.address, SECRET)
    outcomes = [sender.send() for _ in range(20)]
    assert all([await asyncio.wrap_future(outcome) for outcome in outcomes])
    assert room.stops == 20


async def test_stops_of_many_threads_all_arrive(room: Room) -> None:
    sender = StopSender(*room.listener.address, SECRET)
    outcomes: list[Any] = []
    threads = [threading.Thread(target=lambda: outcomes.append(sender.send())) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all([await asyncio.wrap_future(outcome) for outcome in outcomes])
    assert room.stops == 8


async def test_a_stop_arrives_although_its_first_copies_are_lost(loopback: str) -> None:
    room = Room(loopback)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind((loopback, 0))
        port = taken.getsockname()[1]
    outcome = StopSender(loopback, port, SECRET).send()
    await asyncio.sleep(0.1)
    room.listener = StopListener(loopback, port, SECRET, room._stop)
    await room.listener.start()
    assert await asyncio.wrap_future(outcome)
    room.listener.close()
    assert room.stops == 1


async def test_nobody_there_is_told_to_the_sender_and_not_raised(loopback: str) -> None:
    assert not await asyncio.wrap_future(StopSender(loopback, 9, SECRET).send())


async def test_a_wrong_secret_is_ignored(room: Room) -> None:
    await throw(room, signed_stop(time.monotonic_ns(), "x" * 32))
    assert (room.stops, room.listener.ignored) == (0, 1)


async def test_a_replayed_datagram_does_nothing(room: Room) -> None:
    datagram = signed_stop(time.monotonic_ns())
    await throw(room, datagram, datagram, datagram)
    assert room.stops == 1


@pytest.mark.parametrize("age_s", [2.5, -2.5])
async def test_a_datagram_from_another_time_is_ignored(room: Room, age_s: float) -> None:
    await throw(room, signed_stop(time.monotonic_ns() - int(age_s * 1e9)))
    assert (room.stops, room.listener.ignored) == (0, 1)


async def test_garbage_is_ignored(room: Room) -> None:
    good = signed_stop(time.monotonic_ns())
    damaged = [
        good[:index] + bytes([good[index] ^ 1]) + good[index + 1 :] for index in range(len(good))
    ]
    await throw(room, b"", b"STOP", good[:-1], good + b"x", bytes(60_000), *damaged)
    assert room.stops == 0
    assert room.listener.ignored == 5 + len(damaged)


@given(st.binary(max_size=100))
def test_a_datagram_without_the_secret_is_never_verified(data: bytes) -> None:
    with contextlib.suppress(WireError):
        module.verified(data, module.STOP_MAGIC, SECRET.encode())
        raise AssertionError("a signature was guessed")


async def test_an_acknowledgement_cannot_be_sent_back_as_a_stop(room: Room) -> None:
    await throw(
        room,
        module.StopToken(time.monotonic_ns(), b"12345678").signed(
            module.ACKNOWLEDGED, SECRET.encode()
        ),
    )
    assert room.stops == 0


async def test_another_process_stops_us(room: Room) -> None:
    code = "import sys; from contextlib import closing"
    code += "; from housefly.bus.stop_sender import StopSender"
    code += "\nhost, port, secret = sys.argv[1:]"
    code += "\nwith closing(StopSender(host, int(port), secret)) as sender: outcome = sender.send()"
    code += "\nprint(outcome.done() and outcome.result())"
    arguments = [*map(str, room.listener.address), SECRET]
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-c", code, *arguments, stdout=subprocess.PIPE
    )
    output, _ = await process.communicate()
    assert output.strip() == b"True"
    assert room.stops == 1


async def test_a_port_in_use_is_a_link_error(room: Room) -> None:
    with pytest.raises(LinkError, match="cannot listen for STOP"):
        await StopListener(*room.listener.address, SECRET, lambda: None).start()


def test_only_the_loopback_interface_is_listened_on() -> None:
    with pytest.raises(ConfigError, match="loopback"):
        StopListener("0.0.0.0", 0, SECRET, lambda: None)


def test_a_short_secret_is_refused() -> None:
    with pytest.raises(ConfigError, match="16 characters"):
        StopSender("127.0.0.1", 1, "short")


async def test_a_sender_that_may_open_no_further_file_still_stops(room: Room) -> None:
    sender = StopSender(*room.listener.address, SECRET)
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (0, before[1]))
    try:
        with pytest.raises(OSError, match="Too many open files"):
            socket.socket()
        assert await asyncio.wrap_future(sender.send())
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, before)
        sender.close()


def test_a_flood_of_stops_is_sent_with_a_bounded_number_of_waiting_ones(loopback: str) -> None:
    sender = StopSender(loopback, 9, SECRET)
    assert len({id(sender.send()) for _ in range(5000)}) <= 64
    sender.close()
