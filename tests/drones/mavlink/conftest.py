"""A simulated ArduCopter and PX4 on its real ports in real time, and its driver."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from typing import Any

import pytest
from mavlink_flight import Flown

from housefly.clock import RealClock
from housefly.drones import driver_of
from housefly.sites.loaded_site import load_site
from housefly.twin.drone_servers import server_of
from housefly.twin.link_filters import UNFILTERED
from housefly.twin.mavlink.server import MavlinkServer
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld


@pytest.fixture(params=["arducopter", "px4"])
async def flown(request: pytest.FixtureRequest, loopback: str) -> AsyncIterator[Flown]:
    loaded = load_site("bsen", drone__kind=request.param, drone__address=loopback)
    world = SimulatedWorld(loaded.site, loaded.room)
    server = server_of(request.param, world, loopback, beyond_loopback=False, filters=UNFILTERED)
    assert isinstance(server, MavlinkServer)
    await server.start()
    drone: Any = driver_of(loaded.site.drone, loaded.site.limits, RealClock())
    flight = Flown(drone, world, server)
    tasks = [
        asyncio.create_task(work)
        for work in (RealTimeRunner(world, RealClock()).run(), flight.say_for_ever())
    ]
    try:
        await drone.connect()
        yield flight
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await drone.close()
        await server.stop()
