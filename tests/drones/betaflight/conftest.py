"""A simulated Betaflight on its real port, tracked, with our driver at the other end."""

from __future__ import annotations

from collections.abc import AsyncIterator

import pytest
from betaflight_room import BetaflightRoom, betaflight_room


@pytest.fixture
async def room(loopback: str) -> AsyncIterator[BetaflightRoom]:
    async with betaflight_room(loopback) as opened:
        yield opened
