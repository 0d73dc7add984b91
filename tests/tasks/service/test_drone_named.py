"""Which drone a sentence names."""

from __future__ import annotations

import pytest

from housefly.tasks.service.drone_named import drone_named

NAMES = ("red", "red-2", "blue")


@pytest.mark.parametrize(
    ("text", "rest", "name"),
    [
        ("look at the sofa", "look at the sofa", ""),
        ("look at the sofa with red", "look at the sofa", "red"),
        ("Blue: come home", "come home", "blue"),
        ("red-2, land", "land", "red-2"),
        ("schau mit blue zur T\u00fcr", "schau zur T\u00fcr", "blue"),
        (
            "blue\u3067\u30bd\u30d5\u30a1\u3092\u898b\u3066",
            "\u30bd\u30d5\u30a1\u3092\u898b\u3066",
            "blue",
        ),
        ("look at the bored redhead", "look at the bored redhead", ""),
    ],
)
def test_a_name_is_found_as_a_word_and_taken_out(text: str, rest: str, name: str) -> None:
    assert drone_named(text, NAMES) == (rest, name)


def test_of_a_single_drone_none_is_ever_named() -> None:
    assert drone_named("look at the drone", ("drone",)) == ("look at the drone", "")
