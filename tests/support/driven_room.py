"""A simulated drone on its real port in real time, tracked, and somebody at the sticks."""

from __future__ import annotations

import asyncio
import random
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from typing import Any, Generic, Protocol, TypeVar

from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.config.site import Site
from housefly.drones.contract import DroneDriver
from housefly.messages import Action, Command, DroneStatus, Sighting
from housefly.room.files import load_room
from housefly.room.model import Room
from housefly.twin.contracts import GroundTruth
from housefly.twin.drone_servers import DroneServer
from housefly.twin.link_filters import UNFILTERED, Deliver, LinkFilters
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.simulated_drone import SimulatedDrone
from housefly.twin.world import SimulatedWorld

PERIOD = 0.01
ServerT = TypeVar("ServerT", bound=DroneServer)
DriverT = TypeVar("DriverT", bound=DroneDriver)


@dataclass
class DrivenRoom(Generic[ServerT, DriverT]):
    """A world behind a server, and what really happened in it.

    Attributes:
        world: the whole room; by itself it speaks of its first drone.
        drone: the one that is flown here.
        tracked: whether tracking sees the drone.
        trail: the truth, a hundred times a second.
    """

    world: SimulatedWorld
    drone: SimulatedDrone
    server: ServerT
    driver: DriverT
    tracked: bool = True
    trail: list[GroundTruth] = field(default_factory=list)

    @property
    def status(self) -> DroneStatus:
        report = self.driver.telemetry
        return DroneStatus.UNKNOWN if report is None else report.status

    @property
    def height(self) -> float:
        return self.drone.truth().pose.position[2]

    @property
    def is_ready(self) -> bool:
        """Whether the driver would take off."""
        return self.driver.telemetry is not None and not self.driver.problem

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
        await self.until(lambda: self.is_ready, Action.IDLE)
        await self.until(lambda: self.status is DroneStatus.FLYING, Action.TAKE_OFF)

    async def watch(self) -> None:
        """Track it and note the truth, as long as the room is open."""
        clock = RealClock()
        while True:
            truth = self.drone.truth()
            self.trail.append(truth)
            if self.tracked and self.driver.telemetry is not None:
                now = clock.now()
                self.driver.send_pose(Sighting("drone", truth.pose, now - 0.01, now))
            await asyncio.sleep(PERIOD)


def lossy(chance: random.Random, share: float, twice: float = 0.0) -> LinkFilters:
    """Return a link that loses a share both ways, and hands another share over twice."""

    def of(deliver: Deliver) -> Deliver:
        def pass_on(data: bytes) -> None:
            drawn = chance.random()
            for _ in range(0 if drawn < share else 2 if drawn > 1.0 - twice else 1):
                deliver(data)

        return pass_on

    return LinkFilters(uplink=of, downlink=of)


class MakesServer(Protocol):
    """The class of a server of ours."""

    def __call__(self, drone: SimulatedDrone, address: str, *, filters: LinkFilters) -> Any: ...


class MakesDriver(Protocol):
    """The class of a driver."""

    def __call__(self, config: DroneConfig, limits: LimitsConfig, clock: RealClock) -> Any: ...


RoomT = TypeVar("RoomT", bound=DrivenRoom[Any, Any])


@asynccontextmanager
async def driven_rooms(
    site: Site,
    room_of: type[RoomT],
    server_of: MakesServer,
    driver_of: MakesDriver,
    filters: LinkFilters = UNFILTERED,
    model: Room | None = None,
) -> AsyncIterator[tuple[RoomT, ...]]:
    """Open one room with all drones of a site, each at its address and with its driver.

    The world runs in real time meanwhile.
    """
    world = SimulatedWorld(site, model or load_room(site.room.model))
    rooms = []
    for name, drone in world.drones.items():
        config = site.for_drone(name).drone if site.drones else site.drone
        server = server_of(drone, config.address, filters=filters)
        await server.start()
        driver = driver_of(config, site.limits, RealClock())
        rooms.append(room_of(world, drone, server, driver))
    works = (RealTimeRunner(world, RealClock()).run(), *(room.watch() for room in rooms))
    tasks = [asyncio.create_task(work) for work in works]
    try:
        yield tuple(rooms)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        for room in rooms:
            await room.driver.close()
            await room.server.stop()
