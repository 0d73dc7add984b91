"""The driver against the simulated room: physics, firmware, delays, noise on the same ports."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable

import pytest

pytest.importorskip("mujoco")

from virtual_time import loop_time

from housefly.config.site import Site
from housefly.drones.ardrone.driver import ArDrone
from housefly.messages import LEVEL, Action, Command, DroneStatus, Setpoint
from housefly.room.model import Place, Room
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.world import SimulatedWorld

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.slow]

HALL = Room(
    "hall",
    (0.0, 0.0, 12.0, 5.0),
    2.6,
    (),
    (Place("home", (2.0, 2.5), (3.0, 2.5, 1.0)),),
    (),
    (2.0, 2.5),
    0.0,
    None,
)


@pytest.fixture
async def world() -> AsyncIterator[SimulatedWorld]:
    """An empty hall that moves in real time."""
    simulated = SimulatedWorld(Site(), HALL)

    async def move() -> None:
        last = loop_time()
        while True:
            await asyncio.sleep(0.005)
            now = loop_time()
            simulated.advance(min(0.1, now - last))
            last = now

    task = asyncio.create_task(move())
    yield simulated
    task.cancel()


async def test_take_off_move_hover_cut_reset_and_land(world, loopback: str) -> None:
    server = ArDroneServer(world, loopback)
    await server.start()
    drone = ArDrone(Site().drone.model_copy(update={"address": loopback}), Site().limits)
    await drone.connect()

    async def until(
        holds: Callable[[], bool],
        action: Action,
        setpoint: Setpoint = LEVEL,
        patience: float = 10.0,
    ) -> None:
        end = loop_time() + patience
        while not holds():
            assert loop_time() < end, f"{action}: {drone.telemetry}"
            drone.send(Command(action, setpoint))
            await asyncio.sleep(0.01)

    def says(status: DroneStatus) -> Callable[[], bool]:
        return lambda: drone.telemetry is not None and drone.telemetry.status is status

    try:
        await until(says(DroneStatus.FLYING), Action.TAKE_OFF)
        start = world.truth().pose.position
        await until(
            lambda: world.truth().pose.position[0] > start[0] + 0.5, Action.FLY, Setpoint(theta=0.1)
        )
        await until(
            lambda: drone.telemetry is not None and abs(drone.telemetry.velocity[0]) < 0.15,
            Action.HOVER,
        )
        await until(says(DroneStatus.LANDED), Action.LAND)
        await until(says(DroneStatus.EMERGENCY), Action.CUT)
        await until(says(DroneStatus.LANDED), Action.RESET)
        assert server.counters.malformed == server.counters.refused_settings == 0
    finally:
        await drone.close()
        await server.stop()
