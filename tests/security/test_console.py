"""The console under attack: idle and slow connections, greedy sessions, stolen cookies."""

from __future__ import annotations

import asyncio
import collections
import contextlib
import http.client
import socket
import threading
import time
from collections.abc import AsyncIterator, Callable
from typing import Any

import pytest
import pytest_asyncio
from held_lines import is_open
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from housefly.messages import OrderKind
from housefly.web.access.session_auth import api_key
from housefly.web.http import connections
from housefly.web.http.connections import MAX_CONNECTIONS
from housefly.web.http.seats import SEATS_OF_ONE

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]


@pytest_asyncio.fixture(loop_scope="session")
async def console(serving: Callable[..., Any], loopback: str) -> AsyncIterator[Any]:
    async with serving(loopback) as served:
        yield served


def idle_connection(console: Any, said: bytes = b"") -> socket.socket:
    line = socket.create_connection((console.host, console.port), 5.0)
    line.setblocking(False)
    if said:
        line.send(said)
    return line


async def a_second_browser(console: Any, first: str) -> str:
    async with console.talk(first) as one:
        await one.say(type="invite", id=1)
        path = (await one.hear("invite", id=1))["path"]
    _, headers, _ = await console.request("GET", path)
    cookie: str = headers["set-cookie"].partition(";")[0]
    console.proofs[cookie] = headers["location"].partition("?proof=")[2]
    return cookie


@pytest.mark.parametrize("said", [b"", b"GET / HTTP/1.1\r\nHost: x"], ids=["silent", "half a head"])
async def test_idle_connections_keep_nobody_out_and_stop_passes(console: Any, said: bytes) -> None:
    cookie = await console.session()
    async with console.talk(cookie) as one:
        await one.hear("welcome")
        flood: list[socket.socket] = []
        for _ in range(3 * MAX_CONNECTIONS):
            flood.append(await asyncio.to_thread(idle_connection, console, said))
        await one.say(type="stop", id=7)
        await one.hear("accepted", id=7)
        assert len(console.stops) == 1
        assert (await console.request("GET", "/", Cookie=cookie))[0] == 200
        status, _, _ = await console.request("POST", "/stop", Cookie=cookie, Origin=console.origin)
        assert status == 200 and len(console.stops) == 2
        await asyncio.sleep(0.1)
        assert sum(is_open(line) for line in flood) <= MAX_CONNECTIONS
        for line in flood:
            line.close()


async def test_a_head_that_does_not_end_is_cut_and_so_is_who_says_nothing(
    console: Any, monkeypatch: pytest.MonkeyPatch, until: Any
) -> None:
    monkeypatch.setattr(connections, "HEADER_TIMEOUT", 0.2)
    slow = [idle_connection(console), idle_connection(console, b"GET / HTTP/1.1\r\nX-A: ")]
    await until(lambda: not any(is_open(line) for line in slow), 10.0)
    for line in slow:
        line.close()


async def test_a_request_in_progress_is_not_cut_for_an_idle_one(console: Any) -> None:
    cookie = await console.session()
    reader, writer = await asyncio.open_connection(console.host, console.port)
    head = f"POST /edits HTTP/1.1\r\nHost: {console.host}:{console.port}\r\nCookie: {cookie}\r\n"
    head += f"X-Housefly-Proof: {console.proofs[cookie]}\r\nOrigin: {console.origin}\r\n"
    writer.write((head + "Content-Length: 2\r\n\r\n").encode())
    await asyncio.sleep(0.1)
    flood = [await asyncio.to_thread(idle_connection, console) for _ in range(MAX_CONNECTIONS + 20)]
    writer.write(b"{}")
    assert (await asyncio.wait_for(reader.readline(), 5.0)).startswith(b"HTTP/1.1 422")
    writer.close()
    for line in flood:
        line.close()


async def opened(console: Any, path: str, **headers: str) -> ClientConnection:
    return await connect(
        f"ws://{console.host}:{console.port}{path}",
        origin=console.origin,
        additional_headers=console.proved(headers),
        close_timeout=0.1,
    )


async def opened_of(number: int, console: Any, path: str, **headers: str) -> list[ClientConnection]:
    """Return those of so many sockets that the console takes."""
    lines = []
    for _ in range(number):
        with contextlib.suppress(InvalidStatus):
            lines.append(await opened(console, path, **headers))
    return lines


async def seated(lines: list[ClientConnection]) -> int:
    await asyncio.sleep(0.3)
    open_ = 0
    for line in lines:
        with contextlib.suppress(ConnectionClosed, TimeoutError):
            await asyncio.wait_for(line.ping(), 1.0)
            open_ += line.close_code is None
    return open_


@pytest.mark.parametrize("path", ["/socket", "/video", "/api/v1/watch"])
async def test_one_session_cannot_hold_all_seats(console: Any, path: str) -> None:
    greedy = await console.session()
    other = await a_second_browser(console, greedy)
    lines = await opened_of(SEATS_OF_ONE + 5, console, path, Cookie=greedy)
    assert await seated(lines) == SEATS_OF_ONE
    mine = await opened(console, path, Cookie=other)
    assert await seated([mine]) == 1
    for line in (*lines, mine):
        await line.close()
    again = await opened(console, path, Cookie=greedy)
    assert await seated([again]) == 1, "a seat that was left is free again"
    await again.close()


async def test_programs_that_watch_with_the_key_are_bounded_too(console: Any) -> None:
    key = {"Authorization": f"Bearer {api_key('a-secret-for-tests-only')}"}
    lines = await opened_of(SEATS_OF_ONE + 5, console, "/api/v1/watch", **key)
    assert await seated(lines) == SEATS_OF_ONE
    for line in lines:
        await line.close()


STOLEN = [
    ("POST", "/stop"),
    ("GET", "/edits"),
    ("POST", "/edits"),
    ("GET", "/coverage"),
    ("GET", "/flights"),
    ("GET", "/flights/20270115T080000250Z"),
    ("GET", "/video.mjpeg"),
    ("GET", "/api/v1/picture"),
    ("GET", "/api/v1/where/cup"),
]


@pytest.mark.parametrize(("method", "path"), STOLEN)
@pytest.mark.parametrize("proof", ["", "0" * 64, "é"])
async def test_a_stolen_cookie_alone_gets_nothing(
    console: Any, method: str, path: str, proof: str
) -> None:
    """Browsers send cookies to every port of a host, so that another server comes by them."""
    cookie = await console.session()
    console.proofs.clear()
    headers = {"Cookie": cookie, "Origin": console.origin, "X-Housefly-Proof": proof}
    status, _, _ = await console.request(method, path, **headers)
    assert status in (401, 403)
    assert console.stops == []


@pytest.mark.parametrize("path", ["/socket", "/video", "/api/v1/watch"])
async def test_a_stolen_cookie_alone_opens_no_socket(console: Any, path: str) -> None:
    cookie = await console.session()
    console.proofs.clear()
    with pytest.raises(InvalidStatus):
        await opened(console, path, Cookie=cookie)


async def test_a_browser_proves_itself_by_a_subprotocol_because_it_can_set_no_header(
    console: Any,
) -> None:
    cookie = await console.session()
    async with connect(
        f"ws://{console.host}:{console.port}/socket",
        origin=console.origin,
        additional_headers={"Cookie": cookie},
        subprotocols=["housefly", f"proof.{console.proofs[cookie]}"],  # type: ignore[list-item]
    ) as line:
        assert line.subprotocol == "housefly"
        await line.send('{"type":"hello","tab":"tab-number-one"}')
        assert '"welcome"' in str(await asyncio.wait_for(line.recv(), 5.0))


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
@pytest.mark.parametrize("path", ["/video.mjpeg", "/api/v1/picture", "/static/app.js", "/stop"])
async def test_pages_of_other_origins_and_ports_are_refused(
    console: Any, site: str, path: str
) -> None:
    cookie = await console.session()
    headers = {"Cookie": cookie, "Sec-Fetch-Site": site, "Sec-Fetch-Mode": "no-cors"}
    assert (await console.request("GET", path, **headers))[0] == 403
    headers["Sec-Fetch-Mode"] = "navigate"
    assert (await console.request("GET", "/", **headers))[0] == 200


@pytest.mark.parametrize("origin", ["null", "http://elsewhere.example", "http://127.0.0.1:1"])
async def test_no_other_origin_is_let_read_an_answer(console: Any, origin: str) -> None:
    cookie = await console.session()
    for method, path in [("GET", "/api/v1/things"), ("OPTIONS", "/api/v1/things"), ("GET", "/")]:
        _, headers, _ = await console.request(method, path, Cookie=cookie, Origin=origin)
        assert not [name for name in headers if name.startswith("access-control-")]


async def test_a_key_held_down_and_a_flood_of_stops_leave_one_on_its_way(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        for number in range(500):
            await one.say(type="stop", id=number)
        await one.hear("accepted", id=499)
        began = time.monotonic()
        await one.say(type="ping", sent=1.0)
        await one.hear("pong", sent=1.0)
        assert time.monotonic() - began < 2.0
    assert len(console.stops) == 500


async def test_a_session_that_opens_sockets_without_end_is_slowed_and_another_is_not(
    console: Any,
) -> None:
    greedy = await console.session()
    other = await a_second_browser(console, greedy)
    taken = 0
    for _ in range(80):
        for line in await opened_of(1, console, "/video", Cookie=greedy):
            taken += 1
            await line.close()
    assert taken < 60
    assert await seated(await opened_of(1, console, "/video", Cookie=other)) == 1


async def test_stop_passes_a_flood_of_commands_also_on_the_same_socket(console: Any) -> None:
    cookie = await console.session()
    async with console.talk(cookie) as one:
        await one.hear("welcome")
        for number in range(150):
            await one.say(type="order", id=number, order="hover")
        await one.say(type="stop", id=1000)
        await one.hear("accepted", id=1000)
        assert len(console.stops) == 1
        assert sum(order.kind is OrderKind.HOVER for order in console.pilot.orders) < 100


ASKED_WITHOUT_END = ["/api/v1/things", "/coverage", "/edits", "/flights", "/api/v1/where/cup"]


async def test_who_asks_without_end_is_slowed_and_does_not_delay_the_stop_of_another(
    console: Any,
) -> None:
    greedy = await console.session()
    other = await a_second_browser(console, greedy)
    headers = console.proved({"Cookie": greedy})
    told: collections.Counter[int] = collections.Counter()
    is_over = threading.Event()

    def ask_for_ever(path: str) -> None:
        line = http.client.HTTPConnection(console.host, console.port, timeout=5)
        while not is_over.is_set():
            line.request("GET", path, headers=headers)
            answer = line.getresponse()
            answer.read()
            told[answer.status] += 1
        line.close()

    flood = [asyncio.create_task(asyncio.to_thread(ask_for_ever, p)) for p in ASKED_WITHOUT_END]
    try:
        async with console.talk(other) as one:
            await one.hear("welcome")
            async with asyncio.timeout(20.0):
                while not told[429]:
                    await asyncio.sleep(0.05)
            waits = []
            for number in range(20):
                began = time.monotonic()
                await one.say(type="stop", id=number)
                await one.hear("accepted", id=number)
                waits.append(time.monotonic() - began)
                await asyncio.sleep(0.02)
            assert (await console.request("GET", "/api/v1/things", Cookie=other))[0] != 429
    finally:
        is_over.set()
        await asyncio.gather(*flood)
    assert len(console.stops) == 20
    assert max(waits) < 0.3, "the page would post it as well"
    headers = console.proved({"Cookie": greedy, "Origin": console.origin})
    assert (await console.request("POST", "/stop", **headers))[0] == 200
