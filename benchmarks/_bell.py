"""One visitor run over real wires: when the bell rang, and when everything after it happened.

The picture is judged as in lock step: the simulated room's own camera is put where the drone truly
was, turned as the pilot believed it was.
"""

from __future__ import annotations

import json
import os
import socket
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import inf
from pathlib import Path

import numpy as np
from paho.mqtt import publish

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import discovery_entry, new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.topics import ROOM_EVENT_TOPIC, DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.state import clips_folder
from housefly.errors import LinkError
from housefly.hub.api.answers import News
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.messages import Order, PilotStep, RoomEvent
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.record.truth import read_truth
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.tasks.api.values import ENDED, TaskStatus
from housefly.tasks.client.tasks_client import TasksClient
from housefly.twin.world import SimulatedWorld
from scores.visitor_score import FEET_UP, PLACE, is_useful, picture_of

TOPICS = DroneTopics()

BELL = "housefly/bsen/doorbell/doorbell/event"
_RULES = """
rules:
  - name: bell
    when: {event: bell pressed}
    then: {service: visitor, parameters: {stay: 8}}
    confirm: auto
"""
_SCENE = """
name = "Somebody comes to the door"
seed = 1
loop = false

[[people]]
name = "visitor"
visitor = true
steps = [
    { do = "wait", seconds = 0.2 },
    { do = "appear", at = [0.85, 4.20] },
    { do = "wait", seconds = 3600.0 },
]
"""
_SETTLED = 15.0
"""The house is left alone for so long before the bell [s]."""


@dataclass
class BellRun:
    """What happened over the wires; times since the bell was pressed [s].

    Attributes:
        task: as it ended.
        planned: flight time to the door by the planner [s].
        told: of the room's news of the bell.
        asked, started: of what the tasks told.
        ordered: the order to the pilot.
        motors: the drone says that it takes off.
        airborne: the feet leave the floor, in truth.
        useful: of the first useful picture.
        clips: the files.
    """

    task: TaskStatus
    planned: float
    told: float = inf
    asked: float = inf
    started: float = inf
    ordered: float = inf
    motors: float = inf
    airborne: float = inf
    useful: float = inf
    clips: tuple[Path, ...] = ()


@dataclass
class _Ear:
    """What is heard on the bus, with the time at which it was heard [s, monotonic]."""

    news: list[tuple[float, News]] = field(default_factory=list)
    events: list[tuple[float, str]] = field(default_factory=list)
    orders: list[tuple[float, Order]] = field(default_factory=list)
    motors: float = inf
    step: PilotStep | None = None
    poses: list[tuple[float, float]] = field(default_factory=list)

    def heard_step(self, step: PilotStep) -> None:
        self.step = step
        told, estimate = step.inputs.telemetry, step.outputs.estimate
        if told is not None and told.status in AIRBORNE_STATUSES:
            self.motors = min(self.motors, step.now)
        if estimate is not None:
            self.poses.append((step.now, estimate.yaw))

    def heard_event(self, event: RoomEvent) -> None:
        self.events.append((time.monotonic(), event.kind))


def ring(folder: Path, **changes: object) -> BellRun:
    """Run the house, ring, and follow the task to its end; files go into the folder."""
    (folder / "rules.yaml").write_text(_RULES)
    (folder / "scene.toml").write_text(_SCENE)
    site = read_site(
        "bsen",
        **{
            "drone__address": f"127.{1 + os.getpid() % 250}.{os.getpid() // 250 % 250}.79",
            "tracking__address": f"127.{1 + os.getpid() % 250}.{os.getpid() // 250 % 250}.79",
            "web__port": 0,
            "hub__store": str(folder / "room.db"),
            "mqtt__broker": "127.0.0.1",
            "mqtt__start": True,
            "mqtt__port": _free_port(),
            "tasks__rules": str(folder / "rules.yaml"),
            "twin__scene": str(folder / "scene.toml"),
            **changes,
        },
    )
    runtime, truth = new_runtime(site, folder), folder / "truth.jsonl"
    processes = tuple(
        replace(spec, arguments=(*spec.arguments, "--truth", str(truth)))
        if spec.name == "twin"
        else spec
        for spec in processes_of(runtime)
    )
    ear = _Ear()
    with (
        Launcher(runtime, folder, processes),
        ZenohBus(connect=runtime.bus) as bus,
        TasksClient(discovery_entry(runtime), by="the benchmark") as tasks,
    ):
        missing = Readiness(site, bus, web=False, video=True).wait(120.0)
        if missing:
            sys.exit(f"not ready: {missing}")
        bus.subscribe(TOPICS.step, ear.heard_step)
        bus.subscribe(TOPICS.order, lambda order: ear.orders.append((time.monotonic(), order)))
        bus.subscribe(ROOM_NEWS_TOPIC, lambda news: ear.news.append((time.monotonic(), news)))
        bus.subscribe(ROOM_EVENT_TOPIC, ear.heard_event)
        _until(lambda: _is_ready(tasks), 120.0, "the tasks are not ready")
        time.sleep(_SETTLED)
        rung = time.monotonic()
        publish.single(
            BELL, json.dumps({"event": "pressed"}), hostname="127.0.0.1", port=site.mqtt.port
        )
        _until(lambda: bool(tasks.tasks().tasks), 30.0, "nobody asks for anything")
        number = tasks.tasks().tasks[0].id
        _until(lambda: _status(tasks, number).state in ENDED, 300.0, "the task does not end")
        task = _status(tasks, number)
        time.sleep(1.0)  # clips and truth are written in batches
    loaded = open_site(site)
    run = BellRun(task, loaded.plan(PLACE).duration or inf)
    run.told = (
        next(
            (
                at
                for at, news in ear.news
                if at >= rung and any(event.kind == "bell pressed" for event in news.events)
            ),
            inf,
        )
        - rung
    )
    run.asked = _first(ear, "task asked") - rung
    run.started = _first(ear, "task started") - rung
    run.ordered = next((at for at, order in ear.orders if at >= rung), inf) - rung
    run.motors = ear.motors - rung
    _see(run, loaded, truth, ear, rung)
    run.clips = tuple(sorted(clips_folder(site).rglob("*.*")))
    return run


def _see(run: BellRun, loaded: LoadedSite, truth: Path, ear: _Ear, rung: float) -> None:
    """Find when the drone was in the air and what its camera showed, by the truth."""
    flown = read_truth(truth)
    if flown is None:
        return
    world = SimulatedWorld(loaded.site, loaded.room)
    world.set_visitor(True)
    times, yaws = np.array(ear.poses).T
    due = 0.0
    for at, position in zip(flown.time.tolist(), flown.position.tolist(), strict=True):
        if at < rung or position[2] <= FEET_UP:
            continue
        run.airborne = min(run.airborne, at - rung)
        if at < due:
            continue
        due = at + 0.1
        world.put_drone(tuple(position), float(np.interp(at, times, np.unwrap(yaws))))
        if is_useful(picture_of(world, at)):
            run.useful = at - rung
            return


def _first(ear: _Ear, kind: str) -> float:
    return next((at for at, each in ear.events if each == kind), inf)


def _status(tasks: TasksClient, number: int) -> TaskStatus:
    board = tasks.tasks()
    return next(task for task in (*board.tasks, *board.ended) if task.id == number)


def _is_ready(tasks: TasksClient) -> bool:
    try:
        return "ready" in tasks.tasks().drone
    except LinkError:
        return False


def _until(holds: Callable[[], bool], timeout: float, words: str) -> None:
    deadline = time.monotonic() + timeout
    while not holds():
        if time.monotonic() > deadline:
            sys.exit(words)
        time.sleep(0.2)


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])
