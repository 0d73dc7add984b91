"""Logging in under attack: guesses, foreign forms, forged addresses, sessions that are over."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from housefly.clock import SteppedClock
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.logins import TRIES_PER_MINUTE
from housefly.web.access.roles import Role
from housefly.web.access.session import EndedSessions
from housefly.web.access.session_auth import LONGEST_LOGIN, SessionAuth
from housefly.web.access.users import UserBook

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="function")]
PASSWORD = "correct horse battery"


@pytest.fixture
def book(tmp_path: Path, cheap_passwords: None) -> UserBook:
    book = UserBook(tmp_path / "users.json")
    book.put("anna", Role.FLY, PASSWORD)
    return book


@pytest_asyncio.fixture
async def console(
    serving: Callable[..., Any], loopback: str, book: UserBook, tmp_path: Path
) -> AsyncIterator[Any]:
    audit = AuditLog(tmp_path / "commands.jsonl")
    async with serving(loopback, users=book, audit=audit) as served:
        served.audit_file = tmp_path / "commands.jsonl"
        yield served


async def test_a_stranger_is_asked_who_he_is_and_a_user_gets_in_under_his_own_name(
    console: Any,
) -> None:
    status, headers, page = await console.request("GET", "/")
    assert status == 403 and '<form method="post" action="/login">' in page
    assert "form-action 'self'" in headers["content-security-policy"]
    assert "script-src" not in page and "<script" not in page
    assert headers["referrer-policy"] == "same-origin", "else browsers send no Origin with a form"
    status, cookie = await console.login("anna", PASSWORD)
    assert status == 303
    async with console.talk(cookie, name="Somebody else") as one:
        await one.hear("viewers", viewers=[{"id": 1, "name": "anna"}])


async def test_guesses_are_slowed_and_written_down_without_the_password(
    console: Any, until: Any
) -> None:
    for _ in range(int(TRIES_PER_MINUTE)):
        assert (await console.login("anna", "a-wrong-guess"))[0] == 403
    form = "name=anna&password=correct+horse+battery"
    status, headers, _ = await console.request("POST", "/login", form, Origin=console.origin)
    assert status == 429 and int(headers["retry-after"]) >= 1
    await until(
        lambda: console.audit_file.exists() and "too many" in console.audit_file.read_text()
    )
    text = console.audit_file.read_text()
    assert [json.loads(line)["who"] for line in text.splitlines()] == ["anna"] * 6
    assert "wrong name or password" in text and "guess" not in text and "horse" not in text


async def test_a_forged_address_in_a_header_does_not_help_guessing(console: Any) -> None:
    answers = [
        await console.login(f"name{n}", "wrong", **{"X-Forwarded-For": f"10.0.0.{n}"})
        for n in range(int(TRIES_PER_MINUTE) + 1)
    ]
    assert [status for status, _ in answers] == [403] * int(TRIES_PER_MINUTE) + [429]


async def test_a_form_of_another_site_logs_nobody_in_or_out(console: Any) -> None:
    for origin in ("http://evil.example", "null"):
        assert (await console.login("anna", PASSWORD, Origin=origin))[0] == 403
    _, cookie = await console.login("anna", PASSWORD)
    headers = {"Cookie": cookie, "Origin": "http://evil.example"}
    assert (await console.request("POST", "/logout", **headers))[0] == 403
    assert (await console.request("GET", "/", Cookie=cookie))[0] == 200


async def test_a_form_that_is_none_is_refused_in_words(console: Any) -> None:
    for form in ("", "name=anna", "x" * 5000, "a&b", "&" * 100, "name=%FF&password=x", "name=%00"):
        status, _, text = await console.request("POST", "/login", form, Origin=console.origin)
        assert status in (403, 413, 429) and text, form


async def test_a_session_is_dead_after_logging_out_and_its_sockets_are_closed(
    console: Any,
) -> None:
    _, cookie = await console.login("anna", PASSWORD)
    headers = console.proved({"Cookie": cookie})
    lines = [
        await connect(
            f"ws://{console.host}:{console.port}{path}",
            origin=console.origin,
            additional_headers=headers,
        )
        for path in ("/socket", "/video", "/api/v1/watch")
    ]
    status, answered, _ = await console.request(
        "POST", "/logout", Cookie=cookie, Origin=console.origin
    )
    assert status == 200 and "Max-Age=0" in answered["set-cookie"]
    for line in lines:
        async with asyncio.timeout(5.0):
            with pytest.raises(ConnectionClosed):
                while True:
                    await line.recv()
        assert line.close_code == 4003
    assert (await console.request("GET", "/", Cookie=cookie))[0] == 403
    assert (await console.request("GET", "/edits", Cookie=cookie))[0] == 401
    with pytest.raises(InvalidStatus):
        async with console.talk(cookie):
            pass


@pytest.mark.parametrize("end", ["removed", "new password", "book lost"])
async def test_a_session_ends_with_its_user(console: Any, book: UserBook, end: str) -> None:
    _, cookie = await console.login("anna", PASSWORD)
    assert (await console.request("GET", "/edits", Cookie=cookie))[0] == 404
    {
        "removed": lambda: book.remove("anna"),
        "new password": lambda: book.put("anna", Role.FLY, "another one of mine"),
        "book lost": lambda: book._file.write_text("?"),
    }[end]()
    assert (await console.request("GET", "/edits", Cookie=cookie))[0] == 401


async def test_the_printed_link_works_beside_the_users(console: Any) -> None:
    cookie = await console.session()
    async with console.talk(cookie) as one:
        await one.hear("viewers", pilot=1)
        await one.say(type="invite", id=1)
        await one.hear("invite", id=1)


async def test_without_users_nobody_logs_in_and_the_page_is_the_old_one(
    serving: Any, loopback: str, tmp_path: Path
) -> None:
    async with serving(loopback, users=UserBook(tmp_path / "none.json")) as served:
        assert (await served.login("anna", PASSWORD))[0] == 404
        status, _, page = await served.request("GET", "/")
        assert status == 403 and "address that Housefly printed" in page


def session_over(auth: SessionAuth, cookie: str) -> bool:
    name, grant, _ = cookie.split(".")
    return auth._session(name, grant) is None


async def test_a_login_is_over_after_twelve_hours_and_a_logout_outlives_a_restart(
    book: UserBook, tmp_path: Path
) -> None:
    clock, ended = SteppedClock(100.0), tmp_path / "ended"
    anna = book.find("anna")
    assert anna is not None
    auth = SessionAuth("token", "secret", book, EndedSessions(ended), clock)
    first, second = auth.log_in(anna), auth.log_in(anna)
    name, grant, _ = first.split(".")
    session = auth._session(name, grant)
    assert session is not None
    auth.log_out(session)
    again = SessionAuth("token", "secret", book, EndedSessions(ended), clock)
    assert session_over(again, first) and not session_over(again, second)
    clock.advance(LONGEST_LOGIN + 1.0)
    assert session_over(again, second)
