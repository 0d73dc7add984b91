"""Two Crazyflies of one site in one room, each at its own address."""

from __future__ import annotations

import asyncio
from math import dist

import pytest
from crazyflie_room import CrazyflieRoom, crazyflie_rooms

from housefly.config.site import Site
from housefly.messages import Action, DroneStatus

pytestmark = [pytest.mark.wire, pytest.mark.slow]


async def test_each_hears_its_own_driver_and_believes_its_own_place(loopback: str) -> None:
    other = loopback.rsplit(".", 1)[0] + ".254"
    site = Site(
        drones=[
            {"name": "anna", "model": "crazyflie", "address": loopback, "pad": (3.0, 2.0, 0.0)},
            {"name": "bert", "model": "crazyflie", "address": other, "pad": (6.0, 2.0, 1.0)},
        ]
    )
    async with crazyflie_rooms(site) as rooms:
        anna, bert = rooms
        await asyncio.gather(*(flown(room) for room in rooms))
        for room in rooms:
            assert dist(room.firmware.estimator.position, room.drone.truth().pose.position) < 0.05
        await asyncio.gather(
            anna.until(lambda: anna.status is DroneStatus.LANDED, Action.LAND),
            bert.until(lambda: anna.status is DroneStatus.LANDED, Action.HOVER),
        )
        assert anna.height < 0.03 and bert.height > 0.9
        await bert.until(lambda: bert.status is DroneStatus.LANDED, Action.LAND)
        assert all(room.drone.contact_log == () for room in rooms)


async def flown(room: CrazyflieRoom) -> None:
    await room.fly()
    await room.hold(Action.HOVER, 0.5)
