from __future__ import annotations

from pathlib import Path

import pytest

from housefly.clock import SteppedClock
from housefly.web.access.logins import TRIES_PER_MINUTE, WRONG, LoginRefusal, Logins, network_of
from housefly.web.access.passwords import matches
from housefly.web.access.roles import Role
from housefly.web.access.users import User, UserBook

PASSWORD = "correct horse battery"


@pytest.fixture
def clock() -> SteppedClock:
    return SteppedClock(1000.0)


@pytest.fixture
def logins(tmp_path: Path, clock: SteppedClock, cheap_passwords: None) -> Logins:
    book = UserBook(tmp_path / "users.json")
    book.put("anna", Role.FLY, PASSWORD)
    return Logins(book, clock)


async def test_the_right_password_lets_in_and_no_other(logins: Logins) -> None:
    assert isinstance(await logins.log_in("anna", PASSWORD, "10.0.0.1"), User)
    for name, password in [("anna", "wrong"), ("anna", ""), ("ben", PASSWORD), ("", "")]:
        assert await logins.log_in(name, password, "10.0.0.2") == WRONG


async def test_five_tries_a_minute_of_one_address_whatever_the_names(
    logins: Logins, clock: SteppedClock
) -> None:
    for number in range(int(TRIES_PER_MINUTE)):
        assert await logins.log_in(f"name{number}", "wrong", "10.0.0.1") == WRONG
    refused = await logins.log_in("anna", PASSWORD, "10.0.0.1")
    assert isinstance(refused, LoginRefusal) and 0.0 < refused.wait <= 60.0
    assert isinstance(await logins.log_in("anna", PASSWORD, "10.0.0.2"), User)
    clock.advance(60.0 / TRIES_PER_MINUTE)
    assert isinstance(await logins.log_in("anna", PASSWORD, "10.0.0.1"), User)


async def test_five_tries_a_minute_for_one_name_from_however_many_addresses(
    logins: Logins,
) -> None:
    for number in range(int(TRIES_PER_MINUTE)):
        assert await logins.log_in("anna", "wrong", f"10.0.0.{number}") == WRONG
    refused = await logins.log_in("anna", PASSWORD, "10.0.0.99")
    assert isinstance(refused, LoginRefusal) and refused.wait > 0.0


async def test_a_name_that_nobody_has_costs_as_much_as_a_wrong_password(
    logins: Logins, monkeypatch: pytest.MonkeyPatch
) -> None:
    hashes = []

    def noted(password: str, kept: str) -> bool:
        hashes.append(kept)
        return matches(password, kept)

    monkeypatch.setattr("housefly.web.access.logins.matches", noted)
    for name in ("anna", "nobody"):
        assert await logins.log_in(name, "wrong", "10.0.0.1") == WRONG
    known, unknown = (kept.split("$")[2] for kept in hashes)
    assert known == unknown, "the costs of the two hashes differ"


@pytest.mark.parametrize(
    ("address", "network"),
    [
        ("10.0.0.1", "10.0.0.1"),
        ("::ffff:10.0.0.1", "10.0.0.1"),
        ("2001:db8:1:2:3:4:5:6", "2001:db8:1:2::/64"),
        ("2001:db8:1:2::9%eth0", "2001:db8:1:2::/64"),
        ("", ""),
    ],
)
def test_what_a_machine_may_change_at_will_is_not_counted(address: str, network: str) -> None:
    assert network_of(address) == network
