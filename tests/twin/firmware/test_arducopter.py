"""ArduCopter's program as the computer of a served drone; a tiny one stands in for it here."""

from __future__ import annotations

import asyncio
import os
import socket
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import fake_arducopter
import pytest

from housefly.clock import RealClock
from housefly.errors import ConfigError, LinkError
from housefly.sites.loaded_site import load_site
from housefly.twin.drone_servers import server_of
from housefly.twin.firmware.arducopter import PARAMETERS, ArduCopterProgram
from housefly.twin.firmware.program import Program, check_alone
from housefly.twin.link_filters import UNFILTERED
from housefly.twin.mavlink.server import MavlinkServer
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.tello.server import TelloServer
from housefly.twin.world import SimulatedWorld
from housefly.wires.mavlink.autopilots import AUTOPILOTS


@pytest.fixture
def stand_in(tmp_path: Path) -> Path:
    """Return a program that takes ArduCopter's arguments."""
    program = tmp_path / "arducopter"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{fake_arducopter.__file__}" "$@"\n')
    program.chmod(0o755)
    return program


@asynccontextmanager
async def served(program: Path, address: str) -> AsyncIterator[tuple[SimulatedWorld, Program]]:
    """Yield a room in real time whose drone the program flies."""
    loaded = load_site("bsen", drone__kind="arducopter", twin__visitor_present=False)
    world = SimulatedWorld(loaded.site, loaded.room)
    server = ArduCopterProgram(world, address, program=program, beyond_loopback=True)
    await server.start()
    running = asyncio.create_task(RealTimeRunner(world, RealClock()).run())
    try:
        yield world, server._program
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        await server.stop()


@pytest.mark.wire
@pytest.mark.realtime
async def test_a_program_flies_and_its_wire_is_where_drivers_look_for_it(
    stand_in: Path, loopback: str
) -> None:
    async with served(stand_in, loopback) as (world, program):
        async with asyncio.timeout(20.0):
            while world.truth().pose.position[2] < 0.8:
                await asyncio.sleep(0.05)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ground:
            ground.setblocking(False)
            ground.connect((loopback, AUTOPILOTS["arducopter"].udp_port))
            ground.send(b"hello")
            heard = await asyncio.wait_for(
                asyncio.get_running_loop().sock_recv(ground, 100), timeout=5.0
            )
        assert heard == b"olleh"
        settings = (program.folder / "settings.parm").read_text()
        assert "FS_GCS_ENABLE 5\n" in settings
        process = program._process
        assert process is not None
        os.kill(process.pid, 9)
        async with asyncio.timeout(20.0):
            while world.truth().pose.position[2] > 0.1 or not program.has_ended:
                await asyncio.sleep(0.05)
    assert not program.folder.exists()


def test_what_is_set_on_it_is_what_the_driver_asks_for() -> None:
    for need in AUTOPILOTS["arducopter"].needs:
        assert need.meets(PARAMETERS[need.name]), need.name


def test_only_a_model_whose_program_is_named_is_flown_by_one(stand_in: Path) -> None:
    loaded = load_site("bsen", drone__kind="arducopter", twin__visitor_present=False)
    world = SimulatedWorld(loaded.site, loaded.room)

    def server(kind: str, environment: dict[str, str], address: str = "127.0.0.1") -> object:
        return server_of(
            kind, world, address,
            beyond_loopback=False, filters=UNFILTERED, environment=environment,
        )  # fmt: skip

    named = {"ARDUCOPTER": str(stand_in)}
    assert isinstance(server("arducopter", {}), MavlinkServer)
    assert isinstance(server("tello", named), TelloServer)
    with pytest.raises(ConfigError, match="other machines only"):
        server("arducopter", named, "192.0.2.1")


def test_a_program_that_listens_everywhere_is_started_only_where_nobody_else_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(socket, "if_nameindex", lambda: [(1, "lo")])
    check_alone("ArduCopter", beyond_loopback=False)
    monkeypatch.setattr(socket, "if_nameindex", lambda: [(1, "lo"), (2, "eth0")])
    check_alone("ArduCopter", beyond_loopback=True)
    with pytest.raises(ConfigError, match=r"every interface \(eth0 too\).*unshare -rn"):
        check_alone("ArduCopter", beyond_loopback=False)


def test_what_is_no_program_is_said(tmp_path: Path) -> None:
    program = Program(tmp_path / "nothing")
    with pytest.raises(LinkError, match="nothing is no program that can be started"):
        program.start(())
    program.stop()
