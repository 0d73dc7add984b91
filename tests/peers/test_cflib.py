"""PyPI cflib, Bitcraze's own library, scans the twin, reads its tables, arms it and flies it."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from math import dist
from pathlib import Path
from typing import Any

import pytest
from crazyflie_room import CrazyflieRoom, crazyflie_room

from housefly.twin.crazyflie.variables import LOG_ENTRIES, PARAMETER_ENTRIES

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.interop]

HERE = Path(__file__).resolve().parent
PYTHON = HERE.parents[1] / ".venv" / "cflib" / "bin" / "python"


@pytest.fixture
async def room(loopback: str) -> AsyncIterator[CrazyflieRoom]:
    if not PYTHON.exists():
        pytest.skip("cflib is not installed: make interop")
    async with crazyflie_room(loopback) as opened:
        yield opened


async def flown_by_cflib(room: CrazyflieRoom, address: str) -> list[dict[str, Any]]:
    process = await asyncio.create_subprocess_exec(
        str(PYTHON),
        str(HERE / "cflib_square.py"),
        address,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
    )
    assert process.stdin is not None and process.stdout is not None
    tracking = asyncio.create_task(track(room, process.stdin))
    try:
        async with asyncio.timeout(90.0):
            output, complaints = await asyncio.gather(
                process.stdout.read(),
                process.stderr.read(),  # type: ignore[union-attr]
            )
            await process.wait()
    finally:
        tracking.cancel()
        if process.returncode is None:
            process.kill()
    assert process.returncode == 0, complaints.decode()[-3000:]
    return [json.loads(line) for line in output.decode().splitlines() if line.startswith("{")]


async def track(room: CrazyflieRoom, ears: asyncio.StreamWriter) -> None:
    while True:
        pose = room.world.truth().pose
        w, x, y, z = pose.orientation
        ears.write((" ".join(map(str, (*pose.position, x, y, z, w))) + "\n").encode())
        await asyncio.sleep(0.01)


async def test_it_is_scanned_read_armed_told_its_place_and_flown_round_a_square(
    room: CrazyflieRoom, loopback: str
) -> None:
    scanned, read, told, armed, risen, *corners, landed = await flown_by_cflib(room, loopback)
    assert scanned["scanned"] == [f"udp://{loopback}:19850"]
    assert read["protocol"] == 12
    assert read["logged"] == sorted(entry.name for entry in LOG_ENTRIES)
    assert set(read["parameters"]) == {entry.name for entry in PARAMETER_ENTRIES}
    assert read["parameters"]["locSrv.extPosStdDev"] == pytest.approx(0.01)
    assert dist(told["believes"], told["stands"]) < 0.02 and told["poses"] > 50
    assert {"Is armed", "Can fly"} <= set(armed["states"])
    assert {"Is flying", "HL control is active"} <= set(risen["states"])
    assert risen["height"] == pytest.approx(0.8, abs=0.1)
    assert len(corners) == 4
    for corner in corners:
        assert dist(corner["corner"], corner["reached"]) < 0.1
    assert "Is flying" not in landed["states"] and landed["height"] < 0.05
    assert room.server.malformed == 0 and room.world.contact_log == ()
