"""What is wrong with a value from outside, in words."""

from __future__ import annotations

import pytest

from housefly.config.validation import refusal_words
from housefly.errors import ConfigError, HouseflyError, LinkError, MissingPartError, RoomError
from housefly.messages.words import Words

REFUSALS = (
    ConfigError("limits.speed", Words("is missing")),
    ConfigError("limits.speed", "is too much"),
    MissingPartError("the reader of DXF (ezdxf)", "pip install 'housefly[import]'"),
    RoomError(Words("{name} is no file; check its name", name="room.ply")),
    LinkError("nobody answers"),
)


@pytest.mark.parametrize("error", REFUSALS, ids=lambda error: type(error).__name__)
def test_a_refusal_says_what_its_error_says(error: HouseflyError) -> None:
    assert refusal_words(error) == str(error)


def test_the_file_is_left_out_of_a_refusal_for_a_page() -> None:
    words = refusal_words(ConfigError("walls.0.top", Words("is missing"), "plan.svg"))
    assert words == "walls.0.top: is missing"
