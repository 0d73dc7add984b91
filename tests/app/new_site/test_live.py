"""The wires of a site that is being described, tried on real sockets."""

from __future__ import annotations

import asyncio

import pytest
from kinematic_world import FlightState, KinematicWorld

from housefly.app.new_site.live import check_drone, hear_tracking
from housefly.errors import ConfigError
from housefly.room.draft.model import DraftDrone, DraftTracking
from housefly.twin.ardrone.server import ArDroneServer

pytestmark = pytest.mark.wire


async def test_a_drone_says_its_state_and_is_ordered_nothing(loopback: str) -> None:
    world = KinematicWorld()
    server = ArDroneServer(world, loopback)
    await server.start()
    words = await asyncio.to_thread(check_drone, DraftDrone(loopback))
    await server.stop()
    assert "landed, battery 100 %" in words[0]
    assert world.flight is FlightState.LANDED


async def test_a_drone_that_is_not_there_is_told_with_what_to_look_for(loopback: str) -> None:
    words = await asyncio.to_thread(check_drone, DraftDrone(loopback))
    assert words[0].template == "not reached: {why}"
    assert "is it switched on" in words[0]


def test_a_tracking_system_that_cannot_be_is_refused_before_anything_is_opened() -> None:
    with pytest.raises(ConfigError, match="body"):
        hear_tracking(DraftTracking("vicon", "10.0.0.5", 801, body=None))  # type: ignore[arg-type]


def test_an_address_that_is_none_is_told_and_no_crash() -> None:
    heard = hear_tracking(DraftTracking("vicon", "no address"), 0.2)
    assert heard.rate_hz == 0.0
    assert heard.problem
    words = check_drone(DraftDrone("no address"))
    assert words[0].template == "not reached: {why}"
