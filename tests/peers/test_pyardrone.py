"""PyPI pyardrone, the strictest reader of navdata, flies the twin and judges its packets."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable

import pytest
from pyardrone import ARDrone, at

from housefly.twin.contracts import FlightState

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]


def wait_until(
    holds: Callable[[], bool], meanwhile: Callable[[], None], patience: float = 15.0
) -> None:
    deadline = time.monotonic() + patience
    while not holds():
        assert time.monotonic() < deadline, "gave up waiting"
        meanwhile()
        time.sleep(0.03)


@pytest.fixture
async def drone(twin):
    client = await asyncio.to_thread(ARDrone, host=twin.address)
    yield client
    await asyncio.to_thread(client.close)


def listens(drone: ARDrone) -> bool:
    """Whether its listener still lives: a packet that it dislikes ends it."""
    return drone.navdata_client._thread.is_alive()


def choose_navdata(drone: ARDrone, demo: bool) -> None:
    drone.send(at.CTRL(at.CTRL.mode.ACK_CONTROL_MODE))
    wanted = "vision_detect" if demo else "kalman_pressure"
    configure = at.CONFIG("general:navdata_demo", "TRUE" if demo else "FALSE")
    wait_until(
        lambda: drone.navdata_ready.is_set() and hasattr(drone.navdata, wanted),
        lambda: drone.send(configure),
    )


async def test_bootstrap_demo_and_full_packets_pass_its_parser(twin, drone):
    assert await asyncio.to_thread(drone.navdata_ready.wait, 5.0)
    assert drone.state.navdata_bootstrap
    assert not hasattr(drone.navdata, "demo")

    await asyncio.to_thread(choose_navdata, drone, True)
    assert drone.state.navdata_demo_mask
    assert drone.state.command_mask, "the setting was acknowledged"
    assert drone.navdata.demo.vbat_flying_percentage == 100

    await asyncio.to_thread(choose_navdata, drone, False)
    assert not drone.state.navdata_demo_mask
    assert drone.navdata.phys_measures.phys_accs[2] == pytest.approx(-1000.0, abs=60.0)
    assert not hasattr(drone.navdata, "zimmu_3000")
    assert listens(drone)


async def test_it_takes_off_moves_and_lands(twin, drone):
    await asyncio.to_thread(
        fly, drone, lambda: min(twin.displacement[0], -twin.displacement[1]) > 0.15
    )

    assert listens(drone)
    assert twin.flight is FlightState.LANDED
    assert twin.highest > 0.7
    forward, left = twin.displacement
    assert forward > 0.15
    assert left < -0.15


def fly(drone: ARDrone, is_away: Callable[[], bool]) -> None:
    choose_navdata(drone, demo=True)
    drone.send(at.FTRIM())
    wait_until(lambda: drone.navdata.demo.ctrl_state >> 16 == 4, drone.takeoff)
    assert drone.state.fly_mask
    assert drone.navdata.demo.altitude > 700
    choose_navdata(drone, demo=False)
    wait_until(is_away, lambda: drone.move(forward=0.2, right=0.2))
    assert drone.navdata.demo.vx > 100.0
    assert drone.navdata.demo.vy > 100.0
    wait_until(lambda: not drone.state.fly_mask, drone.land)
