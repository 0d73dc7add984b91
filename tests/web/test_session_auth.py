from __future__ import annotations

import pytest
from starlette.requests import HTTPConnection

from housefly.web.roles import Role
from housefly.web.session_auth import PROOF_HEADER, SessionAuth, cookie_name, same_origin


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
    weak = watching.redeem(watching.invite(Role.WATCH))
    assert weak is not None and accepts(watching, weak)
    assert not accepts(watching, weak.replace(".watch.", ".admin."))


def test_invitations_are_new_links_and_the_oldest_die_first() -> None:
    auth = SessionAuth("first", "secret")
    invitations = [auth.invite() for _ in range(25)]
    assert len(set(invitations)) == 25
    assert auth.redeem("first") is None
    assert auth.redeem(invitations[0]) is None
    assert auth.redeem(invitations[-1]) is not None


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
