"""The driver on its real wire: a simulated ArduCopter and PX4 in real time."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from functools import partial

import pytest
from mavlink_flight import Flown

from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.mavlink.driver import MavlinkDrone
from housefly.errors import LinkError
from housefly.messages import Action, Command, DroneStatus, VelocitySetpoint
from housefly.messages.steering import flying
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import FlightState
from housefly.twin.mavlink.server import MavlinkServer
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.slow]
AHEAD = flying(VelocitySetpoint(forward=0.4))


async def test_it_takes_off_flies_is_left_by_its_pilot_and_is_brought_down(flown: Flown) -> None:
    drone = flown.drone
    assert drone.notes, "nothing is known of it yet"
    await flown.take_off()
    flown.command = AHEAD
    await flown.until(lambda: flown.speed > 0.3)
    report = drone.telemetry
    assert report is not None and report.status is DroneStatus.FLYING and not drone.problem
    assert drone.telemetry_rate_hz > 8.0 and report.battery > 0.9
    flown.command = None
    await flown.until(lambda: flown.speed < 0.1, 2.0)
    landing = await flown.until(lambda: flown.flight is FlightState.LANDING, 3.0)
    assert landing < 2.5
    await flown.until(lambda: flown.flight is FlightState.LANDED)
    assert not flown.world.contact_log


async def test_without_its_driver_it_stops_and_lands_by_its_own_rule(flown: Flown) -> None:
    await flown.take_off()
    flown.command = AHEAD
    await flown.until(lambda: flown.speed > 0.3)
    await flown.drone.close()
    vehicle = flown.server.vehicle
    landing = vehicle.autopilot.landing.number
    took = await flown.until(lambda: vehicle.mode == landing, 8.0)
    after = flown.drone.capabilities.silence.after
    assert after - 1.1 < took < after + 0.6
    await flown.until(lambda: not flown.server.vehicle.armed, 20.0)


async def test_cut_in_the_air_it_falls_and_takes_off_again_only_after_a_reset(flown: Flown) -> None:
    await flown.take_off()
    flown.command = Command(Action.CUT)
    await flown.until(partial(told_as, flown, DroneStatus.EMERGENCY), 3.0)
    assert not flown.server.vehicle.armed
    flown.command = Command(Action.TAKE_OFF)
    await asyncio.sleep(1.5)
    assert not flown.server.vehicle.armed
    flown.command = Command(Action.RESET)
    await flown.until(partial(told_as, flown, DroneStatus.LANDED))
    await flown.take_off()


async def test_what_it_refuses_is_told_in_its_own_words_and_what_is_wrong_keeps_it_down(
    flown: Flown,
) -> None:
    vehicle = flown.server.vehicle
    wrong = vehicle.autopilot.needs[0].name
    vehicle.parameters.set(wrong, 0.0)
    await flown.until(lambda: f"set {wrong} to" in flown.drone.problem)
    flown.command = Command(Action.TAKE_OFF)
    await asyncio.sleep(0.5)
    assert flown.flight is FlightState.LANDED and not vehicle.armed
    for action, status in (
        (Action.CUT, DroneStatus.EMERGENCY),
        (Action.RESET, DroneStatus.LANDED),
    ):
        flown.command = Command(action)
        await flown.until(partial(told_as, flown, status))


async def test_where_nobody_answers_it_says_where_and_what_to_look_for(loopback: str) -> None:
    drone = MavlinkDrone(
        DroneConfig(kind="arducopter", address=f"tcp:{loopback}:5999"), LimitsConfig(), RealClock()
    )
    try:
        with pytest.raises(LinkError, match=r"nobody answers at tcp:.*:5999; is ArduCopter"):
            await drone.connect()
        assert "is ArduCopter running" in drone.problem and not drone.connected
    finally:
        await drone.close()


def told_as(flown: Flown, status: DroneStatus) -> bool:
    report = flown.drone.telemetry
    return report is not None and report.status is status


@pytest.mark.parametrize("form", ["{}", "tcp:{}"])
async def test_a_link_that_is_gone_for_a_while_is_found_again(loopback: str, form: str) -> None:
    loaded = load_site("bsen", drone__kind="arducopter")
    world = SimulatedWorld(loaded.site, loaded.room)
    server = MavlinkServer(world, loopback)
    address = form.format(loopback)
    drone = MavlinkDrone(
        DroneConfig(kind="arducopter", address=address), LimitsConfig(), RealClock()
    )
    running = asyncio.create_task(RealTimeRunner(world, RealClock()).run())
    try:
        await server.start()
        await drone.connect()
        await _until(lambda: drone.connected and drone.telemetry_rate_hz > 8.0)
        await server.stop()
        await _until(lambda: not drone.connected)
        await server.start()
        await _until(lambda: drone.connected and drone.telemetry_rate_hz > 8.0)
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        await drone.close()
        await server.stop()


async def _until(holds: Callable[[], bool]) -> None:
    async with asyncio.timeout(12.0):
        while not holds():
            await asyncio.sleep(0.05)
