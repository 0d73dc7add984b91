"""Tasks over real wires: pilot, twin, hub and tasks as processes; asked as people ask."""

from __future__ import annotations

import json
import os
import signal
import socket
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import discovery_entry, new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site, site_from_tree
from housefly.errors import LinkError, TaskError
from housefly.evidence.clip_values import ClipsQuestion
from housefly.geometry import Vec2
from housefly.hub.api.answers import EventAnswer
from housefly.hub.client.room_client import RoomClient
from housefly.messages import DroneStatus, Phase, PilotStep
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.record.truth import TrueFlight, read_truth
from housefly.room.files import load_room
from housefly.tasks.api.questions import Sentence
from housefly.tasks.api.values import ENDED, ReasonCode, TaskStage, TaskStatus
from housefly.tasks.client.tasks_client import TasksClient

TOPICS = DroneTopics()

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(600)]

LIGHT_LATE = 3.0
"""Between recorder and light lie two processes and a radio [s]; usually it is 0.1 s."""
HOLD_TIMEOUT = 15.0
"""The pilot brings home a drone that was ordered nothing for so long [s]."""
PATIENCE = 150.0
"""A machine three times slower than this one, with all its cores busy, gets ready by then [s]."""
PLACE = "tv"
"""The nearest place: half a minute there and back."""


@dataclass
class House:
    """One run with its tasks."""

    launcher: Launcher
    tasks: TasksClient
    room: RoomClient
    truth_file: Path
    log: Path
    home: Vec2
    step: PilotStep | None = None
    told: list[object] = field(default_factory=list)

    def heard(self, step: PilotStep) -> None:
        self.step = step
        self.told += step.outputs.events

    @property
    def status(self) -> DroneStatus | None:
        report = self.step.inputs.telemetry if self.step else None
        return report.status if report else None

    @property
    def phase(self) -> Phase:
        return self.step.outputs.phase if self.step else Phase.IDLE

    def task(self, number: int) -> TaskStatus:
        board = self.tasks.tasks()
        found = [task for task in (*board.tasks, *board.ended) if task.id == number]
        return found[0]

    def ended(self, number: int, limit: float = 120.0) -> TaskStatus:
        assert until(lambda: self.task(number).state in ENDED, limit), self.words(number)
        return self.task(number)

    def words(self, number: int) -> str:
        return f"{self.task(number)}\n{self.log.read_text()[-3000:]}"

    def history(self, since: float) -> tuple[EventAnswer, ...]:
        return self.room.events(since)

    def truth(self) -> TrueFlight:
        time.sleep(1.0)  # it is written in batches
        found = read_truth(self.truth_file)
        assert found is not None
        return found

    def fault(self) -> str:
        """Return "" when the drone truly stands on its pad and touched nothing, or what is so."""
        truth = self.truth()
        touched = [contact for contact in truth.contacts if contact.motors_turned]
        x, y, _ = truth.position[-1]
        away = abs(x - self.home[0]) + abs(y - self.home[1])
        if not truth.airborne[-1] and away < 0.4 and not touched:
            return ""
        happened = "\n".join(map(str, self.told[-20:]))
        return f"{away:.2f} m off the pad, airborne: {truth.airborne[-1]}, {touched}\n{happened}"


def until(holds: Callable[[], bool], timeout: float) -> bool:
    deadline = time.monotonic() + timeout
    while not holds():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.05)
    return True


def site_of(folder: Path) -> Site:
    number = os.getpid()
    address = f"127.{1 + number % 250}.{number // 250 % 250}.77"
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    return site_from_tree(
        {
            "name": "tasks",
            "room": {"model": "bsen"},
            "drone": {"address": address},
            "tracking": {"kind": "vicon", "address": address},
            "hub": {"store": str(folder / "room.db")},
            "limits": {"hold_timeout": HOLD_TIMEOUT},
            "web": {"port": port},
            "twin": {"seed": 1},
        }
    )


@contextmanager
def running(folder: Path) -> Iterator[House]:
    site = site_of(folder)
    runtime = new_runtime(site, folder)
    place = discovery_entry(runtime)
    truth = folder / "truth.jsonl"
    processes = tuple(
        replace(spec, arguments=(*spec.arguments, "--truth", str(truth)))
        if spec.name == "twin"
        else spec
        for spec in processes_of(runtime)
    )
    with (
        Launcher(runtime, folder, processes) as launcher,
        ZenohBus(connect=runtime.bus) as bus,
        TasksClient(place, by="kim") as tasks,
        RoomClient(place.address, place.key, socket=place.socket) as room,
    ):
        assert Readiness(site, bus, web=False, video=False).wait(PATIENCE) == ""
        house = House(
            launcher,
            tasks,
            room,
            truth,
            folder / "tasks.log",
            load_room(site.room.model).home,
        )
        bus.subscribe(TOPICS.step, house.heard)
        assert until(lambda: answers(house), PATIENCE), house.log.read_text()
        yield house


def answers(house: House) -> bool:
    try:
        return "ready" in house.tasks.tasks().drone
    except LinkError:
        return False


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    with running(tmp_path_factory.mktemp("tasks")) as house:
        yield house


@pytest.mark.interop
def test_a_sentence_is_rehearsed_flown_photographed_and_remembered(house: House) -> None:
    since = time.time() - 1.0
    answer = house.tasks.say(f"look at the {PLACE}")
    assert answer.task is not None, answer
    number = answer.task.id
    assert until(lambda: house.status in AIRBORNE_STATUSES, PATIENCE), house.words(number)
    done = house.ended(number)
    assert done.state is TaskStage.DONE, house.words(number)
    assert done.rehearsal is not None and done.rehearsal.may_fly
    assert done.clips, "a picture was taken"
    assert house.fault() == ""
    told = [event for event in house.history(since) if event.source == "tasks"]
    kinds = [event.kind for event in told]
    assert kinds[:2] == ["task asked", "task started"] and "task ended" in kinds
    assert "snapshot kept" in kinds
    flights = [event for event in house.history(since) if event.kind == "flight started"]
    assert flights[0].cause == f"task {number}: look", "who flew stands in the room's memory"


def test_what_there_is_not_is_refused_in_words_and_nothing_flies(house: House) -> None:
    with pytest.raises(TaskError, match="did you mean"):
        house.tasks.request("loook")
    assert house.tasks.ask_tasks(Sentence("colourless green ideas")).suggestions is not None
    task = house.tasks.request("look", subject="unicorn")
    ended = house.ended(task.id, PATIENCE)
    assert (ended.state, ended.code) == (TaskStage.REFUSED, ReasonCode.UNKNOWN_THING), ended
    assert house.status is DroneStatus.LANDED


def test_killed_in_a_flight_asked_for_by_a_sentence_the_drone_comes_home_and_nothing_starts_again(
    house: House,
) -> None:
    since = time.time() - 1.0
    answer = house.tasks.say(f"look at the {PLACE}")
    assert answer.task is not None, answer
    task = answer.task
    assert until(lambda: house.phase is Phase.OUTBOUND, PATIENCE), house.words(task.id)
    old = house.launcher.pid("tasks")
    os.kill(old, signal.SIGKILL)
    assert until(lambda: house.launcher.pid("tasks") != old, 30.0)
    assert until(lambda: answers_at_all(house), PATIENCE), house.log.read_text()
    ended = house.task(task.id)
    assert (ended.state, ended.code) == (TaskStage.FAILED, ReasonCode.RESTARTED), ended
    assert until(lambda: house.status is DroneStatus.LANDED, 90.0), house.phase
    time.sleep(5.0)
    assert house.status is DroneStatus.LANDED and house.phase is Phase.IDLE
    assert house.tasks.tasks().tasks == ()
    assert house.fault() == ""
    assert house.launcher.restarts("pilot") == 0
    flights = [event for event in house.history(since) if event.kind == "flight started"]
    causes = [event.cause for event in flights]
    assert causes == [f"task {task.id}: look"], "who flew stands in the room's memory"


def answers_at_all(house: House) -> bool:
    try:
        house.tasks.tasks()
    except LinkError:
        return False
    return True


@pytest.mark.interop
def test_the_drone_blinks_exactly_while_it_films(house: House) -> None:
    assert until(lambda: answers(house), PATIENCE)
    task = house.tasks.request("visitor", stay=5)
    house.ended(task.id)
    question = ClipsQuestion(task=task.id)
    assert until(lambda: len(house.tasks.ask_tasks(question).clips) == 2, 10.0)
    (clip,) = [one for one in house.tasks.ask_tasks(question).clips if one.kind == "clip"]
    to_unix = time.time() - time.monotonic()
    samples = [json.loads(line) for line in house.truth_file.read_text().splitlines()[:-1]]
    shown = [(one["at"] + to_unix, one["leds"] == 2) for one in samples if "leds" in one]
    lit = [at for at, blinks in shown if blinks and at > clip.began_at]
    end = clip.began_at + clip.duration
    assert clip.began_at < lit[0] < clip.began_at + 5.0 + LIGHT_LATE
    assert end - LIGHT_LATE < lit[-1] < end + LIGHT_LATE
    assert all(blinks for at, blinks in shown if lit[0] <= at <= lit[-1])
    assert house.fault() == ""


@pytest.mark.interop
def test_a_cancelled_task_comes_home_at_once(house: House) -> None:
    assert until(lambda: answers(house), PATIENCE)
    task = house.tasks.request("look", subject=PLACE, time=60)
    assert until(lambda: house.phase is Phase.OUTBOUND, PATIENCE), house.words(task.id)
    house.tasks.cancel(task.id)
    assert until(lambda: house.phase is Phase.RETURNING, 15.0), house.words(task.id)
    ended = house.ended(task.id)
    assert (ended.state, ended.code) == (TaskStage.CANCELLED, ReasonCode.CANCELLED)
    assert house.fault() == ""
