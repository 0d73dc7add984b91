from __future__ import annotations

from pathlib import Path

import pytest
from starlette.requests import HTTPConnection

from housefly.clock import SteppedClock
from housefly.web.access.roles import Role
from housefly.web.access.session import EndedSessions
from housefly.web.access.session_auth import (
    LONGEST_LOGIN,
    PROOF_HEADER,
    SessionAuth,
    cookie_name,
    same_origin,
)


def connection(cookie: str = "", **headers: str) -> HTTPConnection:
    pairs = {"host": "127.0.0.1:8080", **headers}
    if cookie:
        pairs["cookie"] = cookie
    raw = [(key.encode(), value.encode()) for key, value in pairs.items()]
    return HTTPConnection(
        {
            "type": "http",
            "scheme": "http",
            "server": ("127.0.0.1", 8080),
            "path": "/",
            "query_string": b"",
            "headers": raw,
        }
    )


def accepts(auth: SessionAuth, session: str) -> bool:
    cookie = f"{cookie_name(connection())}={session}"
    name = session.partition(".")[0]
    asked = connection(cookie, **{PROOF_HEADER: auth.proof(name)})
    assert not auth.has_session(connection(cookie)), "the cookie alone is not enough"
    assert not auth.has_session(connection(cookie, **{PROOF_HEADER: auth.proof(name + "x")}))
    found = auth.session_of(asked)
    return auth.has_session(asked) and found is not None and found.name == name


def test_a_link_is_good_once() -> None:
    auth = SessionAuth("first", "secret")
    session = auth.redeem("first")
    assert session is not None and accepts(auth, session)
    assert auth.redeem("first") is None


def test_a_wrong_token_and_a_forged_session_are_nothing() -> None:
    auth = SessionAuth("first", "secret")
    assert auth.redeem("second") is None
    assert auth.redeem("") is None
    assert not accepts(auth, "")
    assert not accepts(auth, "name.signature")
    session = auth.redeem("first")
    assert session is not None
    assert not accepts(auth, session[:-1] + ("0" if session[-1] != "0" else "1"))
    watching = SessionAuth("first", "secret")
    weak = watching.redeem(watching.invite(Role.WATCH).token)
    assert weak is not None and accepts(watching, weak)
    assert not accepts(watching, weak.replace(".+watch:", ".+admin:"))
    assert not accepts(watching, weak.replace(".+watch:", ".admin."))


@pytest.mark.parametrize("role", Role)
def test_a_guest_has_the_role_of_the_link_for_twelve_hours(role: Role) -> None:
    clock = SteppedClock(1000.0)
    auth = SessionAuth("first", "secret", clock=clock)
    guest = auth.redeem(auth.invite(role).token)
    assert guest is not None
    seen = connection(f"{cookie_name(connection())}={guest}")
    session = auth.cookie_session(seen)
    assert session is not None and (session.role, session.user) == (role, "")
    clock.advance(LONGEST_LOGIN + 2.0)
    assert auth.cookie_session(seen) is None


def test_a_used_link_stays_used_when_the_console_is_started_again(tmp_path: Path) -> None:
    def again() -> SessionAuth:
        return SessionAuth("first", "secret", ended=EndedSessions(tmp_path / "ended"))

    auth = again()
    link = auth.invite(Role.ASK).token
    unused = auth.invite(Role.ASK).token
    assert auth.redeem("first") is not None and auth.redeem(link) is not None
    assert again().redeem("first") is None and again().redeem(link) is None
    assert again().redeem(unused) is not None
    assert "first" not in (tmp_path / "ended").read_text()


def test_sessions_outlive_a_restart_with_the_same_secret_only() -> None:
    session = SessionAuth("first", "secret").redeem("first")
    assert session is not None
    assert accepts(SessionAuth("second", "secret"), session)
    assert not accepts(SessionAuth("second", "another secret"), session)


@pytest.mark.parametrize(
    ("origin", "same"),
    [
        ("http://127.0.0.1:8080", True),
        ("https://127.0.0.1:8080", False),
        ("http://127.0.0.1:9999", False),
        ("http://localhost:8080", False),
        ("http://evil.example", False),
        ("null", False),
        ("", False),
    ],
)
def test_only_our_own_page_is_the_same_origin(origin: str, same: bool) -> None:
    assert same_origin(connection(origin=origin)) is same


def test_a_request_without_origin_is_not_the_same_origin() -> None:
    assert not same_origin(connection())
