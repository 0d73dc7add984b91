from __future__ import annotations

import pytest

from housefly.errors import ConfigError
from housefly.web.access.passwords import LONGEST, SHORTEST, hashed, is_hash, matches

PASSWORD = "correct horse battery"


def test_only_the_password_itself_matches_its_hash() -> None:
    kept = hashed(PASSWORD)
    assert is_hash(kept) and PASSWORD not in kept
    assert matches(PASSWORD, kept)
    for wrong in ("", PASSWORD[:-1], PASSWORD + " ", PASSWORD.upper(), "x" * 5000, "é\udc80"):
        assert not matches(wrong, kept)


def test_a_guess_costs_what_owasp_recommends() -> None:
    assert hashed(PASSWORD).split("$")[2] == "ln=15,r=8,p=3"


def test_the_same_password_twice_has_two_hashes() -> None:
    assert hashed(PASSWORD) != hashed(PASSWORD)


@pytest.mark.parametrize("length", [0, SHORTEST - 1, LONGEST + 1])
def test_a_password_too_short_or_too_long_is_refused_in_words(length: int) -> None:
    with pytest.raises(ConfigError, match=f"{SHORTEST} to {LONGEST}"):
        hashed("x" * length)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "plain",
        "$scrypt$ln=30,r=8,p=1$" + "A" * 22 + "$" + "A" * 43,
        "$scrypt$ln=15,r=99,p=1$" + "A" * 22 + "$" + "A" * 43,
        "$scrypt$ln=15,r=8,p=1$" + "A" * 22 + "$" + "A" * 42,
        "$scrypt$ln=15,r=8,p=1$" + "A" * 22 + "$" + "A" * 43 + "\n",
    ],
)
def test_a_hash_that_is_none_or_costs_too_much_is_none(text: str) -> None:
    assert not is_hash(text)
