"""The hub's parts together, on a bus inside one process."""

from __future__ import annotations

import asyncio
import time
from pathlib import Path

import pytest

from housefly.bus.local import LocalBus
from housefly.bus.topics import FRAME_TOPIC
from housefly.config.furniture import FurnitureConfig
from housefly.hub.hub import Hub
from housefly.messages import Pose, Sighting, TrackedFrame
from housefly.sites.loaded_site import read_site

CHAIR = FurnitureConfig(name="chair", body="chair-3", length=0.5, width=0.5, top=0.9)


async def test_furniture_that_tracking_sees_is_shown_where_the_pilot_flies_around_it(
    tmp_path: Path,
) -> None:
    site = read_site("bsen", furniture=(CHAIR,), hub__store=str(tmp_path / "room.db"))
    bus = LocalBus()
    hub = Hub(site, tmp_path, bus.join())
    running = asyncio.create_task(hub.run())
    now = time.monotonic()
    for sighting in (
        Sighting("chair-3", Pose((6.0, 3.0, 0.4)), now - 0.01, now),
        Sighting("someone", Pose((1.0, 1.0, 0.4)), now, now + 0.01),
    ):
        bus.publish(FRAME_TOPIC, TrackedFrame((sighting,)))
    async with asyncio.timeout(10.0):
        while not hub.status.obstacles():
            await asyncio.sleep(0.02)
    (shown,) = hub.status.obstacles()
    running.cancel()
    await asyncio.gather(running, return_exceptions=True)
    hub.close()
    assert (shown.obstacle, shown.x, shown.y, shown.source) == (
        "tracking/chair",
        6.0,
        3.0,
        "tracking",
    )
    assert shown.radius == pytest.approx(0.354, abs=0.01)
    assert (shown.length, shown.width, shown.yaw) == (0.5, 0.5, 0.0)
