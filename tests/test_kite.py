"""The stranger's drone of the examples: its wire, its parts, and the way of a pose down to it."""

from __future__ import annotations

import asyncio
import re
import sys
from collections.abc import Iterator
from math import dist
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.clock import RealClock
from housefly.config import airframe
from housefly.drones import driver_of
from housefly.drones.driver_server import DriverServer
from housefly.drones.remote_drone import RemoteDrone
from housefly.errors import ConfigError, WireError
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Pose,
    PositionSetpoint,
    Sighting,
    Telemetry,
)
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.twin.drone_servers import server_of
from housefly.twin.link_filters import LinkFilters
from housefly.twin.setpoint_firmware import SetpointFirmware
from housefly.twin.world import SimulatedWorld

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "examples" / "13_kite"
numbers = st.floats(-100.0, 100.0)


@pytest.fixture(scope="module", autouse=True)
def installed() -> Iterator[None]:
    sys.path.append(str(FOLDER))
    airframe.installed_models.cache_clear()
    try:
        yield
    finally:
        sys.path.remove(str(FOLDER))
        airframe.installed_models.cache_clear()


@pytest.fixture
def loaded() -> LoadedSite:
    return load_site("bsen", drone__kind="kite")


def test_it_is_known_by_one_line_and_others_are_not(loaded: LoadedSite) -> None:
    assert airframe.installed_models() == {"kite": "kite"}
    assert loaded.site.drone.airframe.name == "Kite"
    with pytest.raises(ConfigError, match=r"drone\.kind: is 'kites'; allowed: ardrone, .*kite"):
        load_site("bsen", drone__kind="kites")


def test_each_part_that_the_steps_name_is_there() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    steps = text[text.index("## Add a drone") : text.index("## Add a sensor")]
    named = set(re.findall(r"`(examples/13_kite/[\w./-]+\.\w+)`", steps))
    lying = (path for path in FOLDER.rglob("*") if path.suffix in (".py", ".toml", ".txt"))
    unsaid = {path.relative_to(ROOT).as_posix() for path in lying} - named
    assert len(named) == 5 and unsaid == {"examples/13_kite/kite/__init__.py"}
    line = (FOLDER / "kite.dist-info" / "entry_points.txt").read_text(encoding="utf-8")
    assert line == "[housefly.drones]\nkite = kite\n"


@given(st.binary(max_size=80))
def test_any_bytes_are_a_value_or_a_wire_error(data: bytes) -> None:
    from kite import wire

    for read in (wire.command_of, wire.pose_of, lambda line: wire.report_of(line, 1.0)):
        try:
            read(data)
        except WireError:
            continue


@given(numbers, numbers, numbers, st.floats(-3.0, 3.0))
def test_what_is_told_is_read_as_it_was(x: float, y: float, z: float, rate: float) -> None:
    from kite import wire

    told = wire.command_of(
        wire.command_line(Command(Action.FLY, position=PositionSetpoint(x, y, z, rate)))
    )
    assert told.position is not None
    assert dist((told.position.x, told.position.y, told.position.z), (x, y, z)) < 1e-3
    for action in set(Action) - {Action.FLY}:
        assert wire.command_of(wire.command_line(Command(action))) == Command(action)
    seen = Sighting("drone", Pose((x, y, z)), 4.0, 4.02)
    assert wire.pose_of(wire.pose_line(seen, 4.1)) == pytest.approx(
        (x, y, z, 1.0, 0.0, 0.0, 0.0, 0.1), abs=1e-4
    )
    report = Telemetry(1.0, DroneStatus.FLYING, 0.5, height=z, velocity=(x, y, 0.0), drone_time=9.0)
    assert wire.report_of(wire.report_line(report), 1.0).velocity == pytest.approx(
        (x, y, 0.0), abs=1e-4
    )


@pytest.mark.wire
async def test_a_pose_reaches_the_drone_from_the_pilot_with_its_age(
    loaded: LoadedSite, tmp_path: Path
) -> None:
    clock, site = RealClock(), loaded.site
    world = SimulatedWorld(site, loaded.room)
    filters = LinkFilters()
    served = server_of("kite", world, "127.0.0.1", beyond_loopback=False, filters=filters)
    await served.start()
    tmp_path.chmod(0o700)
    path = tmp_path / "driver.sock"
    server = DriverServer(driver_of(site.drone, site.limits, clock), path, clock)
    serving = asyncio.create_task(server.run())
    pilot = RemoteDrone(path)
    try:
        async with asyncio.timeout(20.0):
            while not path.exists():
                await asyncio.sleep(0.02)
            await pilot.connect()
            firmware = world.first._firmware
            assert isinstance(firmware, SetpointFirmware)
            while firmware.reckoned is None:
                now = clock.now()
                pilot.send_pose(Sighting("drone", Pose((2.0, 1.5, 0.05)), now - 0.04, now))
                await asyncio.sleep(0.02)
                world.advance(0.02)
            assert firmware.reckoned == pytest.approx((2.0, 1.5, 0.05), abs=1e-3)
            assert pilot.capabilities == site.drone.airframe.capabilities
            for _ in range(20):  # what is under way arrives
                await asyncio.sleep(0.01)
                world.advance(0.02)
            firmware.reckoned = None
            for _ in range(20):  # what is too old counts for nothing
                now = clock.now()
                pilot.send_pose(Sighting("drone", Pose((2.0, 1.5, 0.05)), now - 3.0, now))
                await asyncio.sleep(0.01)
                world.advance(0.02)
            assert firmware.reckoned is None
    finally:
        await pilot.close()
        server.leave()
        await serving
        await served.stop()
