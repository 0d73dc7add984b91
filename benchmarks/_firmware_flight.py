"""A stranger's program flies a drone of our room in real time, and our driver flies the program."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from math import hypot
from pathlib import Path
from typing import Any

from housefly.clock import RealClock
from housefly.drones import driver_of
from housefly.messages import Action, Command, DroneStatus, Sighting
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import GroundTruth
from housefly.twin.firmware.arducopter import ArduCopterProgram
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld

PERIOD = 0.02


@dataclass
class FirmwareFlight:
    """The room, the program in it, our driver, and somebody who says the same all the time.

    Attributes:
        command: what is said fifty times a second; None for silence.
        sees: whether the room tells the drone where it is.
        noise: of each pose, one sigma [m].
    """

    drone: Any
    world: SimulatedWorld
    server: Any
    command: Command | None = field(default_factory=lambda: Command(Action.IDLE))
    sees: bool = True
    track: list[GroundTruth] = field(default_factory=list)

    @property
    def status(self) -> DroneStatus:
        """What the driver says that it does."""
        told = self.drone.telemetry
        return told.status if told else DroneStatus.UNKNOWN

    @property
    def height(self) -> float:
        """Of the drone, in truth [m]."""
        return self.world.truth().pose.position[2]

    @property
    def speed(self) -> float:
        """Over the floor, in truth [m/s]."""
        return hypot(*self.world.truth().velocity[:2])

    async def until(self, holds: Callable[[], bool], patience: float = 30.0) -> float:
        """Wait; return how long it took by the world's clock [s]."""
        begun = self.world.now
        async with asyncio.timeout(patience):
            while not holds():
                await asyncio.sleep(PERIOD)
        return self.world.now - begun

    async def wait(self, seconds: float) -> None:
        """Wait, by the world's clock."""
        until = self.world.now + seconds
        await self.until(lambda: self.world.now >= until, 3.0 * seconds + 10.0)

    async def say_for_ever(self) -> None:
        """Say the command and tell the pose, fifty times a second."""
        clock = RealClock()
        while True:
            if self.command is not None:
                self.drone.send(self.command)
            truth = self.world.truth()
            self.track.append(truth)
            if self.sees:
                now = clock.now()
                self.drone.send_pose(Sighting("drone", truth.pose, now - 0.01, now))
            await asyncio.sleep(PERIOD)

    async def ready(self, patience: float = 90.0) -> float:
        """Wait until the driver would take off; return how long it took [s]."""
        return await self.until(
            lambda: bool(self.drone.telemetry and self.drone.telemetry.configured), patience
        )

    async def arm(self) -> float:
        """Order a take-off; return how long it took until the motors turned [s]."""
        self.command = Command(Action.TAKE_OFF)
        return await self.until(lambda: self.world.onboard().motors[0] > 0.0, 90.0)

    async def take_off(self) -> float:
        """Bring it into the air; return how long it took [s]."""
        self.command = Command(Action.TAKE_OFF)
        return await self.until(lambda: self.status is DroneStatus.FLYING, 60.0)


@asynccontextmanager
async def flight_of(program: Path | None, address: str) -> AsyncIterator[FirmwareFlight]:
    """Yield a flight by ArduCopter's program, or without one by our simulated vehicle."""
    changes = {"drone__address": address, "twin__visitor_present": False}
    loaded = load_site("bsen", drone__kind="arducopter", **changes)
    world = SimulatedWorld(loaded.site, loaded.room)
    if program is None:
        from housefly.twin.mavlink.server import MavlinkServer

        server: Any = MavlinkServer(world, address)
    else:
        server = ArduCopterProgram(world, address, program=program)
    await server.start()
    drone: Any = driver_of(loaded.site.drone, loaded.site.limits, RealClock())
    flight = FirmwareFlight(drone, world, server)
    tasks = [
        asyncio.create_task(work)
        for work in (RealTimeRunner(world, RealClock()).run(), flight.say_for_ever())
    ]
    try:
        await _connected(drone)
        yield flight
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await drone.close()
        await server.stop()


async def _connected(drone: Any) -> None:
    from housefly.errors import LinkError

    for _ in range(12):
        try:
            await drone.connect()
        except LinkError:
            continue
        return
    raise AssertionError(str(drone.problem))
