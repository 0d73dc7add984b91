from __future__ import annotations

import pytest
from starlette.requests import HTTPConnection

from housefly.errors import ConfigError
from housefly.web.security import Doorkeeper, check_bind, cookie_name, same_origin


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
            "headers": raw,
        }
    )


def knows(doorkeeper: Doorkeeper, session: str) -> bool:
    return doorkeeper.knows(connection(f"{cookie_name(connection())}={session}"))


@pytest.mark.parametrize("host", ["127.0.0.1", "127.9.9.9", "::1", "localhost"])
def test_loopback_is_always_allowed(host: str) -> None:
    check_bind(host, insecure=False)


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "192.168.1.2", "housefly.local"])
def test_an_address_that_others_reach_must_be_asked_for(host: str) -> None:
    with pytest.raises(ConfigError, match="--insecure"):
        check_bind(host, insecure=False)
    check_bind(host, insecure=True)


def test_a_link_is_good_once() -> None:
    doorkeeper = Doorkeeper("first", "secret")
    session = doorkeeper.redeem("first")
    assert session is not None and knows(doorkeeper, session)
    assert doorkeeper.redeem("first") is None


def test_a_wrong_token_and_a_forged_session_are_nothing() -> None:
    doorkeeper = Doorkeeper("first", "secret")
    assert doorkeeper.redeem("second") is None
    assert doorkeeper.redeem("") is None
    assert not knows(doorkeeper, "")
    assert not knows(doorkeeper, "name.signature")
    session = doorkeeper.redeem("first")
    assert session is not None
    assert not knows(doorkeeper, session[:-1] + ("0" if session[-1] != "0" else "1"))


def test_invitations_are_new_links_and_the_oldest_die_first() -> None:
    doorkeeper = Doorkeeper("first", "secret")
    invitations = [doorkeeper.invite() for _ in range(25)]
    assert len(set(invitations)) == 25
    assert doorkeeper.redeem("first") is None
    assert doorkeeper.redeem(invitations[0]) is None
    assert doorkeeper.redeem(invitations[-1]) is not None


def test_sessions_outlive_a_restart_with_the_same_secret_only() -> None:
    session = Doorkeeper("first", "secret").redeem("first")
    assert session is not None
    assert knows(Doorkeeper("second", "secret"), session)
    assert not knows(Doorkeeper("second", "another secret"), session)


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
