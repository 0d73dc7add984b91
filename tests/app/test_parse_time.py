"""Times as people type them."""

from __future__ import annotations

from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.app.parse_time import parse_time
from housefly.errors import ConfigError

NOW = datetime(2026, 11, 20, 12, 30, 0).timestamp()  # a Friday


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        ("10:02", datetime(2026, 11, 20, 10, 2)),
        ("23:00", datetime(2026, 11, 19, 23, 0)),
        ("7:05:30", datetime(2026, 11, 20, 7, 5, 30)),
        ("90s", datetime(2026, 11, 20, 12, 28, 30)),
        ("15m", datetime(2026, 11, 20, 12, 15)),
        ("2h ago", datetime(2026, 11, 20, 10, 30)),
        ("3d", datetime(2026, 11, 17, 12, 30)),
        ("today", datetime(2026, 11, 20)),
        ("yesterday", datetime(2026, 11, 19)),
        ("Tuesday", datetime(2026, 11, 17)),
        ("friday", datetime(2026, 11, 20)),
        ("2026-11-01 08:00", datetime(2026, 11, 1, 8, 0)),
        ("2026-11-01", datetime(2026, 11, 1)),
    ],
)
def test_what_people_type_is_a_time(words: str, meant: datetime) -> None:
    assert parse_time(words, NOW, "--since") == pytest.approx(meant.timestamp(), abs=1e-6)


@given(st.text(max_size=20))
def test_any_words_are_a_time_or_refused_with_what_is_allowed(words: str) -> None:
    try:
        assert isinstance(parse_time(words, NOW, "--since"), float)
    except ConfigError as error:
        assert "allowed" in str(error)


def test_a_time_of_day_is_never_in_the_future() -> None:
    assert all(
        parse_time(f"{hour}:{minute:02}", NOW, "--at") <= NOW
        for hour in range(24)
        for minute in (0, 29, 30, 31, 59)
    )
