"""A simulated Crazyflie on its real port, tracked, with our driver at the other end."""

from __future__ import annotations

from collections.abc import AsyncIterator

import pytest
from crazyflie_room import CrazyflieRoom, crazyflie_room


@pytest.fixture
async def room(loopback: str) -> AsyncIterator[CrazyflieRoom]:
    async with crazyflie_room(loopback) as opened:
        yield opened
