"""The process: it is there, and a broker says so when it is gone without a word."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from home_screen import site_at, watching
from mqtt_broker import running_broker, until
from stand_in_tasks import StandInTasks

from housefly.app.launcher import processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.room_renewal import ROOM_READERS
from housefly.app.runtime import Runtime
from housefly.bus.stop import StopListener
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.homeassistant.topics import HomeTopics
from housefly.messages import Order, OrderKind

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]
TOPICS = HomeTopics("home")


def started(runtime: Runtime, log: Path) -> subprocess.Popen[bytes]:
    arguments = ("--site", str(runtime.site_file), "--bus", runtime.bus)
    return subprocess.Popen(
        [sys.executable, "-m", "housefly.homeassistant.process", *arguments],
        env=runtime.environment(),
        stdout=log.open("wb"),
        stderr=subprocess.STDOUT,
    )


@pytest.fixture
def state_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    yield tmp_path


@pytest.mark.parametrize("enabled", [True, False])
def test_it_is_started_where_the_site_wants_it(tmp_path: Path, enabled: bool) -> None:
    runtime = new_runtime(site_at(1883, enabled=enabled), tmp_path)
    names = [one.name for one in processes_of(runtime)]
    assert names.count("homeassistant") == enabled
    assert "homeassistant" in ROOM_READERS, "places that were edited become its buttons"


async def test_a_killed_process_is_offline_by_its_last_will_and_stop_has_its_own_path(
    state_home: Path,
) -> None:
    async with running_broker(state_home) as broker, watching(broker) as screen:
        runtime = new_runtime(site_at(broker.port), state_home)
        stops: list[str] = []
        listener = StopListener(
            "127.0.0.1",
            runtime.stop_ports["drone"],
            runtime.secret,
            lambda: stops.append("stop"),
            is_held=True,
        )
        await listener.start()
        orders: list[Order] = []
        with ZenohBus(listen=runtime.bus) as bus:
            tasks = StandInTasks(bus)
            bus.subscribe(DroneTopics("drone").order, orders.append)
            process = started(runtime, state_home / "home.log")
            try:
                await until(lambda: screen.held.get(TOPICS.availability) == b"online", 60.0)
                tasks.ring()
                words = b"Someone is at the entrance. Look?"
                await screen.holds(TOPICS.state("room-question"), words)
                await screen.client.publish(TOPICS.drone_command("drone"), b"stop", qos=1)
                await until(lambda: stops and orders)
                assert orders[0].kind is OrderKind.STOP
                os.kill(process.pid, signal.SIGKILL)
                await screen.holds(TOPICS.availability, b"offline")
            finally:
                process.kill()
                process.wait()
                listener.close()
