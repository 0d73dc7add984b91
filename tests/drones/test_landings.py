"""Every landing ends on the floor, softly: bad links, and tracking that comes and goes."""

from __future__ import annotations

import random
from collections.abc import Iterator
from contextlib import nullcontext
from typing import Any

import pytest
from driven_room import DrivenRoom, driven_rooms, lossy
from empty_hall import empty_hall
from tello_ports import tello_ports

from housefly.config.site import Site
from housefly.drones import driver_of
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    PositionSetpoint,
    Setpoint,
    VelocitySetpoint,
)
from housefly.messages.steering import flying
from housefly.twin.contracts import TwinDrone
from housefly.twin.drone_servers import server_of
from housefly.twin.link_filters import LinkFilters

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.slow]

LEANS, FLIES = ("lean",), ("velocity",)
STEERED_BY = {
    "ardrone": LEANS,
    "arducopter": FLIES,
    "betaflight": LEANS,
    "crazyflie": ("lean", "velocity", "place"),
    "crazyflie_brushless": ("lean", "velocity", "place"),
    "px4": FLIES,
    "tello": FLIES,
}
LOST = {"betaflight": (0.0, 0.05)}
"""Shares of what passes that are lost; of the others none, a twentieth or a fifth."""
FALL_MAX = 1.6
"""What is fallen from 13 cm [m/s]: motors stop just above the floor, never higher."""
FEW, MORE = 1, 30


def cases() -> Iterator[Any]:
    for kind in STEERED_BY:
        for seed in range(MORE):
            yield pytest.param(kind, seed, marks=pytest.mark.interop if seed >= FEW else ())


def order(chance: random.Random, how: str, room: DrivenRoom[Any, Any]) -> Command:
    """Return something to fly near the pad."""
    x, y, z = room.drone.truth().pose.position
    match how:
        case "lean":
            return flying(Setpoint(theta=chance.uniform(-0.1, 0.1), vz=chance.uniform(-0.5, 0.5)))
        case "velocity":
            forward, left = chance.uniform(-0.5, 0.5), chance.uniform(-0.5, 0.5)
            return flying(VelocitySetpoint(forward, left, chance.uniform(-0.4, 0.4)))
        case "place":
            height = max(0.5, z + chance.uniform(-0.3, 0.3))
            return flying(PositionSetpoint(x + chance.uniform(-0.3, 0.3), y, height))
        case _:
            return Command(Action.HOVER)


async def fly_about(chance: random.Random, ways: tuple[str, ...], room: Any) -> None:
    for _ in range(chance.randint(0, 4)):
        how = chance.choice(["hover", *ways, *ways, "unseen", "seen"])
        if how in ("unseen", "seen"):
            room.tracked = how == "seen"
        await room.hold(order(chance, how, room), chance.uniform(0.05, 1.0))


@pytest.mark.parametrize(("kind", "seed"), tuple(cases()))
async def test_it_is_down_softly_and_stays_there(loopback: str, kind: str, seed: int) -> None:
    chance = random.Random(seed)
    share = chance.choice(LOST.get(kind, (0.0, 0.05, 0.2)))

    def served(drone: TwinDrone, address: str, *, filters: LinkFilters) -> Any:
        return server_of(kind, drone, address, beyond_loopback=False, filters=filters)

    site = Site(drone={"kind": kind, "address": loopback})
    link = lossy(random.Random(seed), share, twice=0.05 if share else 0.0)
    with tello_ports() if kind == "tello" else nullcontext():
        async with driven_rooms(site, DrivenRoom, served, driver_of, link, empty_hall()) as (room,):
            stands = room.height
            await room.driver.connect()
            await room.until(
                lambda: room.is_ready and room.driver.telemetry.configured, Action.IDLE, 30.0
            )
            await room.until(lambda: room.status is DroneStatus.FLYING, Action.TAKE_OFF, 20.0)
            await fly_about(chance, STEERED_BY[kind], room)
            since = len(room.trail)
            for _ in range(chance.randint(0, 2)):
                room.tracked = not room.tracked
                await room.hold(Action.LAND, chance.uniform(0.0, 1.5))
            await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND, 30.0)
            await room.hold(Action.IDLE, 1.0)
            assert room.height == pytest.approx(stands, abs=0.02)
            assert max(-truth.velocity[2] for truth in room.trail[since:]) < FALL_MAX
            assert room.world.contact_log == ()
