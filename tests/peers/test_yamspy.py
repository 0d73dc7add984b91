"""PyPI yamspy, an MSP library for companion computers, flies the simulated Betaflight."""

from __future__ import annotations

import asyncio
import json
from pathlib import Path

import pytest
from serial_bridge import serial_bridge

from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.drones.betaflight.height import height_model
from housefly.room.files import load_room
from housefly.twin.betaflight.firmware import BetaflightFirmware
from housefly.twin.betaflight.server import BetaflightServer
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld
from housefly.wires.betaflight.endpoint import TCP_PORT
from housefly.wires.betaflight.sticks import throttle_position

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.interop]

HERE = Path(__file__).resolve().parent
PYTHON = HERE.parents[1] / ".venv" / "yamspy" / "bin" / "python"


async def test_it_asks_arms_flies_and_disarms_over_a_serial_port(loopback: str) -> None:
    if not PYTHON.exists():
        pytest.skip("yamspy is not installed: make interop")
    site = Site(drone={"kind": "betaflight", "address": loopback})
    world = SimulatedWorld(site, load_room(site.room.model))
    firmware = world.firmware
    assert isinstance(firmware, BetaflightFirmware)
    model = height_model(site.drone.airframe, firmware.settings.motor_idle)
    hover = throttle_position(model.throttle(1.0), firmware.settings)
    server = BetaflightServer(world, loopback)
    await server.start()
    heights: list[float] = []

    async def watch() -> None:
        while True:
            heights.append(world.truth().pose.position[2])
            await asyncio.sleep(0.02)

    tasks = [
        asyncio.create_task(work) for work in (RealTimeRunner(world, RealClock()).run(), watch())
    ]
    try:
        with serial_bridge(loopback, TCP_PORT) as device:
            client = await asyncio.create_subprocess_exec(
                *(str(PYTHON), str(HERE / "fly_betaflight.py"), device, str(hover)),
                stdout=asyncio.subprocess.PIPE,
                stderr=asyncio.subprocess.PIPE,
            )
            output, complaints = await asyncio.wait_for(client.communicate(), 90.0)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await server.stop()
    assert client.returncode == 0, complaints.decode()
    seen = json.loads(output.splitlines()[-1])
    assert seen["variant"] == "BTFL"
    assert seen["cells"] == 4 and seen["voltage"] == pytest.approx(16.6, abs=0.4)
    assert seen["armed"] and seen["disarmed"] and not firmware.is_armed
    assert seen["pitch"] == pytest.approx(6.7, abs=1.5), "the curve of its rates at 0.3 of a stick"
    assert seen["channels"][4] == 1800
    assert max(heights) > 0.2 and heights[-1] < 0.06
