"""Two drones over real wires: a pilot and a driver each, one room, one STOP for both."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import changed
from housefly.messages import DroneStatus, Order, OrderKind, PilotStep, SafetyMode
from housefly.sites.loaded_site import read_site

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(300)]

NAMES = ("red", "blue")


@dataclass
class Room:
    """A run with two drones, and the newest step of each."""

    bus: ZenohBus
    runtime: Any
    launcher: Launcher
    steps: dict[str, PilotStep] = field(default_factory=dict)
    heard: threading.Event = field(default_factory=threading.Event)

    def hear(self, name: str, step: PilotStep) -> None:
        self.steps[name] = step

    def order(self, name: str, kind: OrderKind) -> None:
        order = Order(kind, issued_at=time.monotonic(), sender="test")
        self.bus.publish(DroneTopics(name).order, order)

    def status(self, name: str) -> DroneStatus | None:
        telemetry = self.steps[name].inputs.telemetry
        return None if telemetry is None else telemetry.status

    def height(self, name: str) -> float:
        estimate = self.steps[name].outputs.estimate
        return 0.0 if estimate is None else estimate.position[2]

    def until(self, condition: Any, patience: float) -> bool:
        end = time.monotonic() + patience
        while time.monotonic() < end:
            if all(name in self.steps and condition(name) for name in NAMES):
                return True
            time.sleep(0.02)
        return False


@pytest.fixture
def room(tmp_path: Path, write_site: Any) -> Iterator[Room]:
    site = read_site(str(write_site(rate=50.0)), hub__enabled=False, tasks__enabled=False)
    first, _, last = site.drone.address.rpartition(".")
    drones = [
        {"name": "red"},
        {"name": "blue", "address": f"{first}.{int(last) - 100}", "pad": (4.0, 4.0, 0.0)},
    ]
    runtime = new_runtime(changed(site, drones=drones), tmp_path)
    with ExitStack() as stack:
        launcher = stack.enter_context(Launcher(runtime, tmp_path, processes_of(runtime)))
        bus = stack.enter_context(ZenohBus(connect=runtime.bus))
        found = Room(bus, runtime, launcher)
        for name in NAMES:
            bus.subscribe(DroneTopics(name).step, lambda step, name=name: found.hear(name, step))
        missing = Readiness(runtime.site(), bus, web=False, video=False).wait(90.0)
        assert missing == "", missing
        yield found


def test_both_take_off_are_stopped_at_once_and_land_at_the_end(room: Room) -> None:
    assert room.until(lambda name: room.status(name) is DroneStatus.LANDED, 20.0)
    time.sleep(3.0)
    for name in NAMES:
        room.order(name, OrderKind.TAKE_OFF)
    assert room.until(lambda name: room.height(name) > 0.7, 30.0), room.steps
    places = [room.steps[name].outputs.estimate for name in NAMES]
    assert all(place is not None for place in places)
    for name in NAMES:
        port = room.runtime.stop_ports[name]
        with closing(StopSender("127.0.0.1", port, room.runtime.secret)) as sender:
            assert sender.send().result(2.0)
    assert room.until(lambda name: room.steps[name].outputs.safety is SafetyMode.STOPPED, 2.0)
    began = time.monotonic()
    assert room.launcher.stop() == (), "both land, and nobody is left to himself"
    assert time.monotonic() - began < 25.0
    assert all(room.status(name) is DroneStatus.LANDED for name in NAMES)
