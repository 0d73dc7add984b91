"""The gate reads which page asks, and hands on what may pass, byte for byte."""

from __future__ import annotations

import asyncio
import socket
from ipaddress import ip_address

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import ConfigError
from housefly.foxglove.origin_gate import OriginGate, hidden_address, origin_of

PAGES = st.from_regex(r"[a-z]{1,8}://[a-z0-9.:-]{1,30}", fullmatch=True)


@given(PAGES, st.sampled_from(["Origin", "origin", "ORIGIN"]), st.sampled_from(["", " ", "  \t"]))
def test_the_page_of_a_request_is_read_whatever_the_letters_and_blanks(
    page: str, name: str, blank: str
) -> None:
    head = f"GET / HTTP/1.1\r\nHost: localhost\r\n{name}:{blank}{page}{blank}\r\nX: y\r\n\r\n"
    assert origin_of(head.encode()) == page


@given(PAGES, PAGES)
def test_who_names_two_pages_names_none_that_may_look(one: str, other: str) -> None:
    head = f"GET / HTTP/1.1\r\nOrigin: {one}\r\nOrigin: {other}\r\n\r\n"
    assert origin_of(head.encode()) == "several"


@given(st.binary(max_size=200))
def test_any_bytes_have_a_page_or_none(head: bytes) -> None:
    assert origin_of(head) is None or isinstance(origin_of(head), str)


def test_the_hidden_address_is_on_this_machine_and_another_each_time() -> None:
    found = {hidden_address() for _ in range(50)}
    assert all(ip_address(one).is_loopback for one in found)
    assert len(found) > 45


@pytest.mark.wire
async def test_what_passes_comes_through_both_ways_byte_for_byte() -> None:
    async def echo(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        while piece := await reader.read(1000):
            writer.write(piece)
        writer.close()

    inner = await asyncio.start_server(echo, "127.0.0.1", 0)
    gate = OriginGate("127.0.0.1", 0, inner.sockets[0].getsockname()[:2], ())
    told = b"GET / HTTP/1.1\r\n\r\n" + bytes(range(256)) * 1000
    reader, writer = await asyncio.open_connection("127.0.0.1", gate.port)
    writer.write(told)
    async with asyncio.timeout(20.0):
        assert await reader.readexactly(len(told)) == told
    writer.close()
    gate.close()
    inner.close()


@pytest.mark.wire
def test_a_port_that_is_taken_is_named() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(ConfigError, match=rf"foxglove\.port.*{port}"):
            OriginGate("127.0.0.1", port, ("127.0.0.1", 1), ())
