"""Scanners and depth cameras that are slow or late, on their wires and in lock step."""

from __future__ import annotations

import asyncio

import pytest

from housefly.bus.local import LocalBus
from housefly.bus.topics import DEPTH_TOPIC
from housefly.config.site import changed
from housefly.lab.lockstep.lockstep_perception import LockstepPerception
from housefly.messages import DepthImage, Scan
from housefly.sensors.laser import LaserClient
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.movable import Movable
from housefly.twin.sensors.depth_feed import DepthFeed
from housefly.twin.sensors.laser_feed import LaserFeed
from housefly.twin.world import SimulatedWorld

LASER = {"name": "laser-1", "x": 5.5, "y": 0.85, "z": 1.1, "yaw": 1.2}
CAMERA = {"name": "depth-1", "x": 5.5, "y": 3.0, "rate_hz": 10}
TURN = 0.025


def sensing(*faults: str, address: str = "127.0.0.1") -> LoadedSite:
    return open_site(
        changed(
            read_site("bsen"),
            lasers=[{**LASER, "address": address}],
            depth_cameras=[CAMERA],
            faults=[{"fault": fault} for fault in faults],
            twin__visitor_present=False,
        )
    )


async def heard_on_the_wire(address: str, *faults: str) -> list[float]:
    """Return when each scan of two seconds came, since the scanner was asked [s]."""
    loaded = sensing(*faults, address=address)
    world = SimulatedWorld(loaded.site, loaded.room)
    feed, heard = LaserFeed(loaded.site, world), list[float]()
    client = LaserClient(loaded.site.lasers[0])
    (server,) = feed._servers.values()
    began = float("inf")

    def hear(scan: Scan) -> None:
        heard.append(world.now - began)

    await feed.start()
    asking = asyncio.create_task(client.run(hear))
    try:
        async with asyncio.timeout(30.0):
            while not server.is_measuring:
                await asyncio.sleep(0.01)
            began = world.now
            while world.now < began + 2.0:
                world.advance(TURN)
                feed.publish()
                await asyncio.sleep(0.005)
    finally:
        asking.cancel()
        await asyncio.gather(asking, return_exceptions=True)
        await feed.stop()
    return heard


@pytest.mark.wire
async def test_a_real_client_hears_a_slow_scanner_seldom_and_a_late_one_late(
    loopback: str,
) -> None:
    true = await heard_on_the_wire(loopback)
    slow = await heard_on_the_wire(loopback, "laser:slow=2")
    late = await heard_on_the_wire(loopback, "laser:delayed=1")
    assert len(true) > 40 and true[0] < 0.9
    assert 3 <= len(slow) <= 5
    assert late[0] >= 1.0 - 1e-6 and len(true) * 0.4 < len(late) < len(true) * 0.6


@pytest.mark.parametrize(
    ("fault", "stamps", "age"),
    [("depth:ok", 20, 0.0), ("depth:slow=2", 4, 0.0), ("depth:delayed=1", 10, 1.0)],
)
def test_depth_images_on_the_bus_are_slow_or_late_with_true_stamps(
    fault: str, stamps: int, age: float
) -> None:
    loaded, bus = sensing(fault), LocalBus()
    world = SimulatedWorld(loaded.site, loaded.room)
    ages: list[float] = []

    class WorldClock:
        def now(self) -> float:
            return world.now

    def hear(image: DepthImage) -> None:
        ages.append(world.now - image.captured_at)

    bus.subscribe(DEPTH_TOPIC, hear)
    faults = FaultInjector(loaded.site, Injection.WIRES)
    feed = DepthFeed(loaded.site, world, bus, WorldClock(), faults)
    for _ in range(80):
        feed.publish()
        world.advance(TURN)
    assert len(ages) == pytest.approx(stamps, abs=1)
    assert ages == pytest.approx([age] * len(ages), abs=0.03)


@pytest.mark.parametrize("sensor", ["laser", "depth"])
def test_what_a_late_sensor_sees_in_lock_step_is_told_late(sensor: str) -> None:
    other = {"laser": "depth", "depth": "laser"}[sensor]

    def told_after(*faults: str) -> float:
        loaded = sensing(f"{other}:off", *faults)
        world = SimulatedWorld(loaded.site, loaded.room, None, (Movable("chair"),))
        perception = LockstepPerception(loaded, world, FaultInjector(loaded.site))
        for _ in range(160):
            if world.now > 1.0 and world.now < 1.0 + 1.5 * TURN:
                world.put("chair", (7.3, 3.0))
            if any(one.confidence > 0.0 for one in perception.update(world.now, ())):
                return world.now - 1.0
            world.advance(TURN)
        return float("inf")

    true = told_after()
    assert true < 0.6
    assert told_after(f"{sensor}:delayed=0.3") == pytest.approx(true + 0.3, abs=0.15)
    assert told_after(f"{sensor}:off") == float("inf")
