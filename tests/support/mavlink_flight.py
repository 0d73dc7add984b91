"""A simulated ArduCopter or PX4 on its real ports in real time, and its driver."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass, field
from math import hypot

from housefly.clock import RealClock
from housefly.drones.mavlink.driver import MavlinkDrone
from housefly.messages import Action, Command, Sighting
from housefly.twin.contracts import FlightState
from housefly.twin.mavlink.server import MavlinkServer
from housefly.twin.world import SimulatedWorld

PERIOD = 0.02


@dataclass
class Flown:
    """A drone, its driver, and somebody who says the same command fifty times a second.

    Attributes:
        command: what is said; None for silence.
        sees: whether the room tells it where it is.
    """

    drone: MavlinkDrone
    world: SimulatedWorld
    server: MavlinkServer
    command: Command | None = field(default_factory=lambda: Command(Action.IDLE))
    sees: bool = True

    @property
    def flight(self) -> FlightState:
        return self.world.onboard().flight

    @property
    def speed(self) -> float:
        return hypot(*self.world.truth().velocity[:2])

    async def until(self, holds: Callable[[], bool], patience: float = 15.0) -> float:
        """Wait; return how long it took by the world's clock."""
        begun = self.world.now
        async with asyncio.timeout(patience):
            while not holds():
                await asyncio.sleep(PERIOD)
        return self.world.now - begun

    async def say_for_ever(self) -> None:
        clock = RealClock()
        while True:
            if self.command is not None:
                self.drone.send(self.command)
            if self.sees:
                now = clock.now()
                pose = self.world.truth().pose
                self.drone.send_pose(Sighting("drone", pose, now - 0.01, now))
            await asyncio.sleep(PERIOD)

    async def take_off(self) -> None:
        await self.until(lambda: bool(self.drone.telemetry and self.drone.telemetry.configured))
        self.command = Command(Action.TAKE_OFF)
        await self.until(lambda: self.flight is FlightState.HOVERING)
