"""Who comes in, over real sockets: links, sessions, Host and Origin."""

from __future__ import annotations

import re
from typing import Any

import pytest
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]


async def test_the_printed_link_opens_the_console_and_vanishes_from_the_address(
    console: Any,
) -> None:
    status, headers, _ = await console.request("GET", "/?token=a-token-for-tests-only")
    assert status == 303 and re.fullmatch(r"/\?proof=[0-9a-f]{64}", headers["location"])
    cookie = headers["set-cookie"]
    assert "HttpOnly" in cookie and "SameSite=strict" in cookie
    status, _, page = await console.request("GET", "/", Cookie=cookie.partition(";")[0])
    assert status == 200 and "/static/app.js" in page


async def test_a_link_that_was_used_says_how_to_get_another(console: Any) -> None:
    await console.session()
    status, _, page = await console.request("GET", "/?token=a-token-for-tests-only")
    assert status == 403 and "Invite" in page


async def test_a_browser_that_is_in_may_open_its_link_again(console: Any) -> None:
    cookie = await console.session()
    status, headers, _ = await console.request("GET", "/?token=whatever", Cookie=cookie)
    assert (status, headers["location"]) == (303, "/")


async def test_without_a_session_there_is_only_a_friendly_page(console: Any) -> None:
    status, _, page = await console.request("GET", "/")
    assert status == 403 and "address that Housefly printed" in page
    assert (await console.request("POST", "/stop", Origin=console.origin))[0] == 403
    assert console.stops == []


async def test_every_answer_carries_the_protective_headers(console: Any) -> None:
    for path in ("/", "/static/app.js", "/nothing"):
        _, headers, _ = await console.request("GET", path)
        assert "default-src 'self'" in headers["content-security-policy"]
        assert "frame-ancestors 'none'" in headers["content-security-policy"]
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["referrer-policy"] == "no-referrer"


@pytest.mark.parametrize(
    ("read", "sent"),
    [
        (None, None),
        ("gzip", "gzip"),
        ("gzip, deflate, br, zstd", "br"),
        ("br;q=0.8", "br"),
        ("gzip, br; q=0", "gzip"),
        ("identity", None),
    ],
)
async def test_files_travel_compressed_to_whoever_can_read_them_so(
    console: Any, read: str | None, sent: str | None
) -> None:
    asked = {} if read is None else {"Accept-Encoding": read}
    status, headers, body = await console.request("GET", "/static/app.css", **asked)
    assert (status, headers.get("content-encoding")) == (200, sent)
    assert headers["content-type"].startswith("text/css") and body
    assert "accept-encoding" in headers["vary"].lower()
    again, _, body = await console.request(
        "GET", "/static/app.css", **asked, **{"If-None-Match": headers["etag"]}
    )
    assert (again, body) == (304, "")


@pytest.mark.parametrize("name", ["..%2f..%2fserver.py", "%00", "nothing.js", "x" * 300])
async def test_what_is_not_there_is_not_found_packed_either(console: Any, name: str) -> None:
    status, _, _ = await console.request("GET", f"/static/{name}", **{"Accept-Encoding": "br"})
    assert status == 404


async def test_a_foreign_host_name_is_turned_away(console: Any) -> None:
    cookie = await console.session()
    status, _, _ = await console.request("GET", "/", Host="evil.example:80", Cookie=cookie)
    assert status == 421


@pytest.mark.parametrize("path", ["/socket", "/video"])
@pytest.mark.parametrize("origin", ["http://evil.example", "null", None])
async def test_a_page_of_another_site_cannot_open_a_socket(
    console: Any, path: str, origin: Any
) -> None:
    cookie = await console.session()
    with pytest.raises(InvalidStatus):
        await connect(
            f"ws://{console.host}:{console.port}{path}",
            origin=origin,
            additional_headers={"Cookie": cookie},
        )


@pytest.mark.parametrize("path", ["/socket", "/video"])
async def test_a_socket_needs_a_session(console: Any, path: str) -> None:
    with pytest.raises(InvalidStatus):
        await connect(f"ws://{console.host}:{console.port}{path}", origin=console.origin)
    forged = {"Cookie": f"housefly_{console.port}=name.0000"}
    with pytest.raises(InvalidStatus):
        await connect(
            f"ws://{console.host}:{console.port}{path}",
            origin=console.origin,
            additional_headers=forged,
        )


async def test_stop_without_a_socket_works_for_our_own_page_only(console: Any, until: Any) -> None:
    cookie = await console.session()
    assert (await console.request("POST", "/stop", Cookie=cookie, Origin="http://evil.example"))[
        0
    ] == 403
    assert (await console.request("POST", "/stop", Cookie=cookie))[0] == 403
    assert console.stops == []
    assert (await console.request("POST", "/stop", Cookie=cookie, Origin=console.origin))[0] == 200
    assert len(console.stops) == 1
    await until(lambda: console.pilot.stopped)


async def test_an_invitation_opens_one_more_browser(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        await one.say(type="invite", id=5)
        path = (await one.hear("invite", id=5))["path"]
        status, headers, _ = await console.request("GET", path)
        assert status == 303 and "set-cookie" in headers
        await one.hear("invitation_used")
    assert (await console.request("GET", path))[0] == 403


@pytest.mark.parametrize(
    ("method", "headers"),
    [
        ("HEAD", {}),
        ("GET", {"Sec-Purpose": "prefetch;prerender"}),
        ("GET", {"Purpose": "prefetch"}),
        ("GET", {"Sec-Fetch-Dest": "empty"}),
        ("GET", {"Sec-Fetch-Dest": "image"}),
    ],
    ids=lambda one: str(one),
)
async def test_what_only_looks_at_a_link_does_not_use_it_up(
    console: Any, method: str, headers: dict[str, str]
) -> None:
    link = "/?token=a-token-for-tests-only"
    status, answer, _ = await console.request(method, link, **headers)
    assert status == 204 and "set-cookie" not in answer
    assert (await console.request("GET", link))[0] == 303


async def test_what_a_stranger_may_have_tells_nothing(console: Any) -> None:
    """The service worker and the authority, which a phone needs before it is in."""
    status, headers, script = await console.request("GET", "/service-worker.js")
    assert status == 200 and headers["content-type"].startswith("text/javascript")
    assert "/api" not in script and "token" not in script
    assert (await console.request("GET", "/authority.crt"))[0] == 404


async def test_a_message_that_is_too_large_ends_the_socket(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        await one.socket.send("x" * 20_000)
        with pytest.raises((ConnectionClosed, TimeoutError)):
            await one.hear("never")


async def test_a_restart_with_the_same_secret_knows_its_browsers(
    serving: Any, loopback: str
) -> None:
    async with serving(loopback) as first:
        cookie, port = await first.session(), first.port
    async with serving(loopback, port) as second:
        second.proofs.update(first.proofs)
        async with second.talk(cookie) as one:
            assert (await one.hear("welcome"))["you"] == 1
