"""A simulated Crazyflie on its real port in real time, tracked, and somebody at the sticks."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field

from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.drones.crazyflie.driver import Crazyflie
from housefly.messages import Action, Command, DroneStatus, Sighting
from housefly.room.files import load_room
from housefly.twin.contracts import GroundTruth
from housefly.twin.crazyflie.firmware import CrazyflieFirmware
from housefly.twin.crazyflie.server import CrazyflieServer
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld

PERIOD = 0.01


@dataclass
class CrazyflieRoom:
    """A world behind a server, and what really happened in it.

    Attributes:
        tracked: whether tracking sees the drone.
        trail: the truth, a hundred times a second.
    """

    world: SimulatedWorld
    server: CrazyflieServer
    driver: Crazyflie
    tracked: bool = True
    trail: list[GroundTruth] = field(default_factory=list)

    @property
    def firmware(self) -> CrazyflieFirmware:
        firmware = self.world.first.firmware
        assert isinstance(firmware, CrazyflieFirmware)
        return firmware

    @property
    def status(self) -> DroneStatus:
        report = self.driver.telemetry
        return DroneStatus.UNKNOWN if report is None else report.status

    @property
    def height(self) -> float:
        return self.world.truth().pose.position[2]

    async def until(
        self, holds: Callable[[], bool], command: Command | Action, patience: float = 15.0
    ) -> None:
        command = Command(command) if isinstance(command, Action) else command
        async with asyncio.timeout(patience):
            while not holds():
                self.driver.send(command)
                await asyncio.sleep(PERIOD)

    async def hold(self, command: Command | Action, seconds: float) -> None:
        start = self.world.now
        await self.until(lambda: self.world.now - start > seconds, command)

    async def fly(self) -> None:
        await self.driver.connect()
        report = self.driver
        await self.until(lambda: report.telemetry is not None and not report.problem, Action.IDLE)
        await self.until(lambda: self.status is DroneStatus.FLYING, Action.TAKE_OFF)

    async def watch(self) -> None:
        """Track it and note the truth, as long as the room is open."""
        clock = RealClock()
        while True:
            truth = self.world.truth()
            self.trail.append(truth)
            if self.tracked and self.driver.telemetry is not None:
                now = clock.now()
                self.driver.send_pose(Sighting("drone", truth.pose, now - 0.01, now))
            await asyncio.sleep(PERIOD)


@asynccontextmanager
async def crazyflie_room(address: str, kind: str = "crazyflie") -> AsyncIterator[CrazyflieRoom]:
    """Open the room, its drone at an address; runs the world in real time meanwhile."""
    site = Site(drone={"kind": kind, "address": address})
    world = SimulatedWorld(site, load_room(site.room.model))
    server = CrazyflieServer(world, address)
    await server.start()
    driver = Crazyflie(site.drone, site.limits, RealClock())
    room = CrazyflieRoom(world, server, driver)
    tasks = [
        asyncio.create_task(work)
        for work in (RealTimeRunner(world, RealClock()).run(), room.watch())
    ]
    try:
        yield room
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await driver.close()
        await server.stop()
