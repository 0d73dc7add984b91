"""Two Crazyflies of one site in one room, each at its own address."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from math import dist

import pytest
from crazyflie_room import CrazyflieRoom, crazyflie_rooms

from housefly.config.site import Site
from housefly.messages import Action, Command, DroneStatus

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.slow]


async def test_each_hears_its_own_driver_and_believes_its_own_place(loopback: str) -> None:
    other = loopback.rsplit(".", 1)[0] + ".254"
    site = Site(
        drones=[
            {"name": "anna", "model": "crazyflie", "address": loopback, "pad": (10.55, 1.25, 3.0)},
            {"name": "bert", "model": "crazyflie", "address": other, "pad": (8.05, 1.25, 0.0)},
        ]
    )
    async with crazyflie_rooms(site) as rooms:
        anna, bert = rooms
        for room in rooms:
            await room.driver.connect()
        flying, landed = DroneStatus.FLYING, DroneStatus.LANDED
        await both(rooms, lambda: all(map(is_ready, rooms)), Action.IDLE, Action.IDLE)
        await both(
            rooms,
            lambda: all(room.status is flying for room in rooms),
            Action.TAKE_OFF,
            Action.TAKE_OFF,
        )
        for room in rooms:
            assert dist(room.firmware.estimator.position, room.drone.truth().pose.position) < 0.05
        await both(rooms, lambda: anna.status is landed, Action.LAND, Action.HOVER)
        assert anna.height < 0.03 and bert.height > 0.9
        await both(rooms, lambda: bert.status is landed, Action.IDLE, Action.LAND)
        assert all(room.drone.contact_log == () for room in rooms)


def is_ready(room: CrazyflieRoom) -> bool:
    return room.driver.connected and not room.driver.problem


async def both(
    rooms: tuple[CrazyflieRoom, ...], holds: Callable[[], bool], *actions: Action
) -> None:
    """Tell each its own, until something holds: a drone without a pilot would sink."""
    async with asyncio.timeout(20.0):
        while not holds():
            for room, action in zip(rooms, actions, strict=True):
                room.driver.send(Command(action))
            await asyncio.sleep(0.01)
