"""The room of the tests of lock step."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from empty_hall import empty_hall

from housefly.room.model import Room


@pytest.fixture
def make_room() -> Callable[..., Room]:
    """Return a maker of rooms 12 m by 5 m with nothing in them unless asked."""
    return empty_hall
