"""ArduCopter's own program in our room, flown by our driver over its own MAVLink.

ARDUCOPTER=PATH unshare -rn sh -c 'ip link set lo up; pytest -n 0 THIS_FILE'
"""

from __future__ import annotations

from collections.abc import AsyncIterator

import pytest
from named_firmware import named_firmware

from _firmware_flight import FirmwareFlight, flight_of
from housefly.messages import Action, Command, DroneStatus, VelocitySetpoint
from housefly.messages.steering import flying

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(300)]


@pytest.fixture
async def flight(loopback: str) -> AsyncIterator[FirmwareFlight]:
    async with flight_of(named_firmware("ARDUCOPTER"), loopback) as flying_program:
        yield flying_program


async def test_it_arms_takes_off_hovers_flies_and_lands(flight: FirmwareFlight) -> None:
    await flight.ready()
    assert not flight.drone.problem
    await flight.take_off()
    flight.command = Command(Action.HOVER)
    await flight.wait(4.0)
    assert 0.8 < flight.height < 1.2 and flight.speed < 0.1
    flight.command = flying(VelocitySetpoint(forward=0.4))
    await flight.wait(3.0)
    assert flight.speed == pytest.approx(0.4, abs=0.1)
    flight.command = Command(Action.HOVER)
    await flight.wait(3.0)
    assert flight.speed < 0.1
    flight.command = Command(Action.LAND)
    await flight.until(lambda: flight.status is DroneStatus.LANDED)
    assert flight.height < 0.15 and not flight.world.contact_log
    assert flight.server.steps.missed == 0 or flight.server.steps.steps > 100


async def test_left_by_its_ground_station_it_lands_by_itself(
    flight: FirmwareFlight,
) -> None:
    await flight.ready()
    await flight.take_off()
    flight.command = flying(VelocitySetpoint(forward=0.4))
    await flight.until(lambda: flight.speed > 0.3)
    await flight.drone.close()
    stopped = await flight.until(lambda: flight.speed < 0.05, 20.0)
    assert stopped < 15.0, "measured: 8.4 to 11.3 s; its poses are gone with its driver"
    await flight.until(lambda: flight.height < 0.15, 40.0)


async def test_without_poses_it_lands_by_itself(flight: FirmwareFlight) -> None:
    await flight.ready()
    await flight.take_off()
    flight.command = Command(Action.HOVER)
    await flight.wait(2.0)
    flight.sees = False
    await flight.until(lambda: flight.height < 0.15, 60.0)
