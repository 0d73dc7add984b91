"""Our driver over the links of PyPI cflib: its UDP link stands in for the USB radio, unchanged.

Its packages are those of the strangers' environment, at the end of our path: ours come first.
"""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Iterator
from math import dist
from pathlib import Path

import pytest
from crazyflie_room import CrazyflieRoom, crazyflie_room

from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.crazyflie.driver import Crazyflie
from housefly.drones.crazyflie.radio_wire import RadioWire
from housefly.errors import LinkError
from housefly.messages import Action, DroneStatus, PositionSetpoint
from housefly.messages.steering import flying
from housefly.twin.crazyflie.supervisor import SupervisorState
from housefly.wires.crazyflie.crtp import UDP_PORT, Packet

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.interop]

VENV = Path(__file__).resolve().parents[2] / ".venv" / "cflib"


@pytest.fixture(autouse=True)
def cflib(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    found = list(VENV.glob("lib/python3*/site-packages"))
    if not (VENV / "ready").exists() or not found:
        pytest.skip("cflib is not installed: make interop")
    monkeypatch.setattr(sys, "path", [*sys.path, *map(str, found)])
    yield
    for name in [one for one in sys.modules if one.partition(".")[0] == "cflib"]:
        del sys.modules[name]


def over_cflib(room: CrazyflieRoom, loopback: str) -> Crazyflie:
    config = DroneConfig(kind="crazyflie", address=f"udp://{loopback}:{UDP_PORT}")
    room.driver = Crazyflie(config, LimitsConfig(), RealClock())
    return room.driver


async def test_it_is_set_up_flown_to_a_place_and_landed_over_a_link_of_cflib(
    loopback: str,
) -> None:
    async with crazyflie_room(loopback) as room:
        driver = over_cflib(room, loopback)
        await room.fly()
        assert driver.firmware == "2026.08" and room.server.values["stabilizer.estimator"] == 2.0
        x, y, _ = room.world.truth().pose.position
        await room.hold(flying(PositionSetpoint(x + 0.3, y, 1.2)), 3.0)
        assert dist(room.world.truth().pose.position, (x + 0.3, y, 1.2)) < 0.1
        await room.until(lambda: room.status is DroneStatus.LANDED, Action.LAND)
        assert room.height < 0.03 and room.world.contact_log == ()
        assert room.firmware.supervisor.state is not SupervisorState.LOCKED
        assert room.server.malformed == 0
        assert driver.telemetry_rate_hz > 50


async def test_a_drone_that_was_away_is_heard_again_over_a_link_that_was_opened_anew(
    loopback: str,
) -> None:
    async with crazyflie_room(loopback) as room:
        driver = over_cflib(room, loopback)
        await driver.connect()
        await room.until(lambda: driver.connected, Action.IDLE)
        await room.server.stop()
        await asyncio.sleep(3.0)
        assert not driver.connected
        room.server = type(room.server)(room.world, loopback)
        await room.server.start()
        await room.until(lambda: driver.connected and not driver.problem, Action.IDLE)
        assert room.server.values["stabilizer.estimator"] == 2.0


async def test_without_a_radio_on_this_machine_it_says_so_in_words() -> None:
    heard: list[Packet] = []
    wire = RadioWire("radio://7/80/2M/E7E7E7E7E7", heard.append)
    with pytest.raises(LinkError, match="cannot open radio://7/80/2M/E7E7E7E7E7"):
        await wire.open()
    assert not wire.is_open and "radio://7" in wire.problem
    await wire.close()
