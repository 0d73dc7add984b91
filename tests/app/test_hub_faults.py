"""Faults of the room's memory in mid-flight never reach the pilot, and lose nothing kept."""

from __future__ import annotations

import os
import resource
import signal
import threading
import time
from bisect import bisect_right
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import psutil
import pytest

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import HUB_QUERY, DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import changed, site_from_file
from housefly.errors import LinkError
from housefly.geometry import Vec3, distance
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import Question, SensorsQuestion, TrajectoryQuestion, WhereQuestion
from housefly.hub.store.run_length import STILL_DISTANCE
from housefly.lab.lockstep.service_monitor import ServiceMonitor
from housefly.messages import Order, OrderKind, Phase, PilotStep
from housefly.room.files import load_room

TOPICS = DroneTopics()

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(180)]

DRONE = "ardrone"
PLACE = "tv"
"""The nearest place: half a minute there and back."""


@dataclass
class Flight:
    """One run, its bus, and the drone's track: Unix time of capture [s] and place [m]."""

    runtime: Runtime
    launcher: Launcher
    bus: ZenohBus
    watch: ServiceMonitor
    seen: list[tuple[float, Vec3]] = field(default_factory=list)
    phase: Phase = Phase.IDLE
    done: threading.Event = field(default_factory=threading.Event)

    def heard(self, step: PilotStep) -> None:
        unix = time.time() - time.monotonic()
        ours = [sighting for sighting in step.inputs.sightings if sighting.body == DRONE]
        self.seen += [(unix + sighting.captured_at, sighting.pose.position) for sighting in ours]
        self.phase = step.outputs.phase
        self.watch = self.watch.updated(step)
        if self.watch.outcome:
            self.done.set()

    def order(self, kind: OrderKind, place: str = "") -> None:
        self.bus.publish(
            TOPICS.order,
            Order(kind, place, look_s=1.0, issued_at=time.monotonic(), sender="test"),
        )

    def send(self) -> None:
        """Order the service and wait until the drone is on its way."""
        self.order(OrderKind.SERVICE, PLACE)
        assert until(lambda: self.phase is Phase.OUTBOUND, 20.0), self.watch
        time.sleep(2.0)
        assert self.phase is Phase.OUTBOUND

    def outcome(self) -> str:
        self.done.wait(100.0)
        return self.watch.outcome

    def ask(self, question: Question, timeout: float = 2.0) -> Any:
        return answer_from_json(
            question, self.bus.ask(HUB_QUERY, question_to_json(question), timeout)
        )

    def age(self) -> float:
        """Return how long ago the hub's drone was seen [s]; much when nobody answers."""
        try:
            age = self.ask(WhereQuestion(DRONE)).age
        except LinkError:
            age = None
        return 1e9 if age is None else float(age)

    def memory(self) -> str:
        return str(self.ask(SensorsQuestion()).memory)


def until(holds: Callable[[], bool], timeout: float) -> bool:
    """Wait until it holds; tell whether it does."""
    deadline = time.monotonic() + timeout
    while not holds():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.05)
    return True


def is_kept(rows: tuple[tuple[float, float, float, float], ...], at: float, place: Vec3) -> bool:
    """Return whether the row at a time has the place; what stands still is kept only once."""
    last = bisect_right(rows, at + 1e-3, key=lambda row: row[0])
    return last > 0 and distance(rows[last - 1][1:], place) <= STILL_DISTANCE


def share_kept(flight: Flight, since: float, until: float) -> float:
    """Return the share of the drone's places between two times that the store has."""
    told = [seen for seen in flight.seen if since < seen[0] < until]
    rows = flight.ask(TrajectoryQuestion(DRONE, since - 5.0, until, source="vicon"), 10.0).rows
    return sum(is_kept(rows, at, place) for at, place in told) / len(told)


@contextmanager
def flying(site_file: Path, folder: Path) -> Iterator[Flight]:
    """Run a site without a console and send the drone off; the block begins in mid-flight."""
    site = changed(site_from_file(site_file), hub__store=str(folder / "room.db"))
    home = load_room(site.room.model).home
    runtime = new_runtime(site, folder)
    with (
        Launcher(runtime, folder, processes_of(runtime)) as launcher,
        ZenohBus(connect=runtime.bus) as bus,
    ):
        assert Readiness(site, bus, web=False, video=False).wait(60.0) == ""
        flight = Flight(
            runtime, launcher, bus, ServiceMonitor(time.monotonic(), home, 120.0, grace=90.0)
        )
        bus.subscribe(TOPICS.step, flight.heard)
        assert until(lambda: flight.age() < 1.0, 20.0), (folder / "hub.log").read_text()
        flight.send()
        yield flight


def test_a_killed_hub_comes_back_with_all_but_the_last_second_and_the_flight_completes(
    tmp_path: Path, write_site: Any
) -> None:
    with flying(write_site(), tmp_path) as flight:
        since, old, killed_at = flight.seen[0][0], flight.launcher.pid("hub"), time.time()
        os.kill(old, signal.SIGKILL)
        assert until(lambda: flight.launcher.pid("hub") != old, 10.0)
        assert until(lambda: flight.age() < 1.0, 20.0), (
            "the new hub does not say where the drone is"
        )
        assert flight.ask(WhereQuestion(DRONE)).position is not None
        assert killed_at - since > 4.0
        assert share_kept(flight, since + 1.0, killed_at - 1.0) >= 0.99
        assert flight.outcome() == "completed"
        assert flight.launcher.restarts("hub") == 1
        assert flight.launcher.restarts("pilot") == 0


@pytest.mark.interop
def test_a_memory_whose_disk_takes_no_more_says_so_and_the_flight_completes(
    tmp_path: Path, write_site: Any
) -> None:
    with flying(write_site(), tmp_path) as flight:
        hub, begin = flight.launcher.pid("hub"), time.time()
        hard = resource.prlimit(hub, resource.RLIMIT_FSIZE)[1]
        resource.prlimit(hub, resource.RLIMIT_FSIZE, (1, hard))
        assert until(lambda: "rows wait: disk" in flight.memory(), 10.0), flight.memory()
        assert flight.age() < 1.0, "what is where now needs no disk"
        assert flight.outcome() == "completed"
        assert "rows wait: disk" in flight.memory()
        end = time.time()
        resource.prlimit(hub, resource.RLIMIT_FSIZE, (hard, hard))
        assert until(lambda: "rows wait" not in flight.memory(), 20.0), flight.memory()
        assert share_kept(flight, begin, end) >= 0.99, "what waited is written"
        assert flight.launcher.restarts("hub") == 0


@pytest.mark.interop
def test_a_hub_that_stands_still_disturbs_neither_the_flight_nor_stop(
    tmp_path: Path, write_site: Any
) -> None:
    with flying(write_site(), tmp_path) as flight:
        hub = psutil.Process(flight.launcher.pid("hub"))
        hub.suspend()
        listener = ("127.0.0.1", flight.runtime.stop_ports["drone"])
        with closing(StopSender(*listener, flight.runtime.secret)) as sender:
            sender.send()
        assert until(lambda: flight.phase is Phase.HOLDING, 5.0), flight.phase
        flight.order(OrderKind.RESUME)
        time.sleep(1.0)
        flight.order(OrderKind.SERVICE, PLACE)
        assert flight.outcome() == "completed"
        hub.resume()
        assert until(lambda: flight.age() < 1.0, 30.0), "the hub does not go on"
