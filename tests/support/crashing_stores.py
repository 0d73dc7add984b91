"""Every store of the product: how it is written to, one thing after the other, and what it kept.

What is kept is read with the product's own readers, and must be whole.
"""

from __future__ import annotations

import json
import random
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import count
from pathlib import Path

import av
from filming import SIZE, number_of, striped

from housefly.config.drone import DroneConfig
from housefly.config.edits import Edits, NoFlyZone
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.config.tasks import TasksConfig
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_values import ClipsQuestion, StartClip
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    Outputs,
    PilotStep,
    Severity,
    Telemetry,
    VideoFrame,
)
from housefly.record.recorder import FlightRecorder
from housefly.record.replay import read_steps
from housefly.room.edit_versions import EditVersions
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.tasks.api.values import ENDED, Priority, ReasonCode, TaskRequest, TaskStage
from housefly.tasks.engine.task_record import task_status
from housefly.tasks.rules.rule_memory import RuleMemory
from housefly.tasks.rules.rule_store import KeptRules, RuleStore
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.task_store import KeptTask, TaskStore
from housefly.tasks.scheduler.transitions import ACTIVE
from housefly.tasks.scheduler.values import (
    Decision,
    DroneAvailability,
    RunReport,
    SchedulerLimits,
    StartTask,
    TaskEnded,
    TaskTraits,
)
from housefly.twin.camera.encoder import Encoder
from housefly.web.access.audit_log import AuditLog
from housefly.web.api.edit_service import EditService
from housefly.web.flights.flight_book import FlightBook
from housefly.web.flights.flight_log import SAMPLE_PERIOD
from housefly.web.flights.flight_log_writer import FlightLogWriter
from housefly.web.messages.server_messages import EventView, PathMessage
from housefly.web.status.console_memory import ConsoleMemory, KeptControl

CLIP_GROUP, CLIP_LENGTH, CLIP_RATE_HZ = 6, 30, 30.0
"""Pictures from one key frame to the next; pictures of a clip; and pictures a second."""
_LIMITS = SchedulerLimits()
_ANYBODY = DroneAvailability(True)
_NOBODY_ASKED = ClipOrigin(7, "visitor")
_WORDS = "x" * 3000
"""So long an event that the console's file is written anew every two seconds."""
_HOME = (1.8, 1.0, 1.1)

Write = Callable[[int], None]
"""Writes the thing of a number; numbers rise by one from 1."""


@dataclass(frozen=True, slots=True)
class CrashingStore:
    """A store that is killed.

    Attributes:
        begin: opens it in a folder, and returns what writes.
        kept: opens it again, looks whether it is whole, and returns how many things it has.
        pause: between two things [s].
        is_acknowledged: whether a thing is on the disk when its writing returns.
        outlives_power: whether it counts after a power cut.
        is_synced_in_c: whether no witness hears it ask for the disk.
    """

    begin: Callable[[Path], Write]
    kept: Callable[[Path], int]
    pause: float = 0.005
    is_acknowledged: bool = False
    outlives_power: bool = True
    is_synced_in_c: bool = False


def _queue(folder: Path) -> Write:
    store, chance = TaskStore(folder / "tasks.db"), random.Random(1)
    scheduler = store.load(_LIMITS)

    def take(outcome: tuple[Scheduler, tuple[Decision, ...]]) -> None:
        nonlocal scheduler
        before = {id(task) for task in scheduler.tasks}
        scheduler, decisions = outcome
        changed = [task for task in scheduler.tasks if id(task) not in before]
        changed += [each.task for each in decisions if isinstance(each, TaskEnded)]
        store.keep([KeptTask(task, task_status(task, None)) for task in changed])
        assert not store.problem

    def write(number: int) -> None:
        now = time.time()
        priority = chance.choice(list(Priority))
        request = TaskRequest(str(number), asked_by=chance.choice("abc"), priority=priority)
        take(scheduler.requested(request, TaskTraits("Look", flies=chance.random() < 0.8), now))
        kinds = [TaskStage.RUNNING, TaskStage.DONE, TaskStage.FAILED]
        active = [task.id for task in scheduler.tasks if task.state in ACTIVE]
        runs = [RunReport(one, chance.choice(kinds), is_safe_point=True) for one in active]
        take(scheduler.ticked(now, runs, _ANYBODY))

    return write


def _queue_kept(folder: Path) -> int:
    store = TaskStore(folder / "tasks.db")
    try:
        assert store.notices == ()
        queue = store.load(_LIMITS)
        assert store.notices == ()
        numbers = range(1, queue.next_id)
        states = {number: store.status(number) for number in numbers}
        assert all(states.values()), "a task between others is gone"
        going_on = {number for number, one in states.items() if one and one.state not in ENDED}
        assert {task.id for task in queue.tasks} == going_on
        _nothing_flies_by_itself(queue)
        return queue.next_id - 1
    finally:
        store.close()


def _nothing_flies_by_itself(kept: Scheduler) -> None:
    """Let a restarted queue stand beside a drone that is free: without a yes none takes off."""
    now = time.time()
    queue, decisions = kept.restarted(now)
    for each in decisions:
        assert isinstance(each, TaskEnded) and each.task.code is ReasonCode.RESTARTED
    flights = [task for task in queue.tasks if task.traits.flies]
    assert all(task.stage is TaskStage.WAITING and task.question for task in flights)
    for after in range(200):
        queue, decisions = queue.ticked(now + after, (), _ANYBODY)
        started = {each.id for each in decisions if isinstance(each, StartTask)}
        assert not started & {task.id for task in flights}


def _rules(folder: Path) -> Write:
    store = RuleStore(folder, HouseMode.AWAY)

    def write(number: int) -> None:
        mode = HouseMode.HOME if number % 2 else HouseMode.PRIVACY
        store.keep(KeptRules(mode, RuleMemory(seen=(str(number),))))

    return write


def _rules_kept(folder: Path) -> int:
    store = RuleStore(folder, HouseMode.AWAY)
    kept = store.load()
    assert store.problem == ""
    if not kept.memory.seen:
        assert kept.mode is HouseMode.AWAY
        return 0
    number = int(kept.memory.seen[0])
    assert kept.mode is (HouseMode.HOME if number % 2 else HouseMode.PRIVACY)
    return number


def _clips(folder: Path) -> Write:
    recorder = ClipRecorder(folder, TasksConfig(), DroneConfig())
    encoder = Encoder(*SIZE, CLIP_RATE_HZ, group=CLIP_GROUP)

    def write(number: int) -> None:
        now = time.monotonic()
        recorder.tick(now, time.time(), DroneStatus.FLYING, HouseMode.HOME)
        if number % CLIP_LENGTH == 1:
            recorder.start(StartClip(before=0.0), _NOBODY_ASKED)
        data, is_key = encoder.encode(striped(number % 1024))
        recorder.add(VideoFrame(data, is_key, *SIZE, number, now), None)

    return write


def _clips_kept(folder: Path) -> int:
    recorder = ClipRecorder(folder, TasksConfig(), DroneConfig())
    try:
        assert recorder.flush()
        clips = recorder.index.find(ClipsQuestion(limit=100)).clips
        assert not recorder.index.notices and not recorder.problem
        files = {path.name for path in folder.iterdir() if not path.name.startswith("index.db")}
        assert files == {recorder.index.file(clip.id).name for clip in clips}
        shown: list[int] = []
        for clip in reversed(clips):
            numbers = _numbers_shown(recorder.index.file(clip.id))
            assert numbers or (clip.cut_off and not clip.duration)
            first = numbers[0] if numbers else 0
            right = [number for place, number in enumerate(numbers, first) if number == place]
            # The file system may know of a group of pictures and have zeros there.
            assert numbers[: len(right)] == right and len(numbers) - len(right) <= CLIP_GROUP
            assert clip.cut_off or numbers == right
            # Its end may be lost while it is written; then it says so, as does one taken up again.
            assert clip.cut_off or len(numbers) >= CLIP_LENGTH - 2 * CLIP_GROUP
            shown += right
        return max(shown, default=0)
    finally:
        recorder.close()


def _numbers_shown(file: Path) -> list[int]:
    """Return the numbers of the pictures of a clip; none of one without a readable beginning."""
    try:
        with av.open(str(file)) as film:
            return [number_of(one.to_ndarray(format="rgb24")) for one in film.decode(video=0)]
    except (av.FFmpegError, IndexError):
        return []


@cache
def _house() -> LoadedSite:
    return load_site("bsen", hub__enabled=False)


def _edit_service(folder: Path) -> EditService:
    return EditService(lambda: _house().room, Site(), EditVersions(folder))


def _edits(folder: Path) -> Write:
    service = _edit_service(folder)

    def write(number: int) -> None:
        if number % 5 == 0:
            service.undo(number - 1, str(number))
            return
        zone = NoFlyZone(rectangle=(5.0, 3.0, 6.0, 4.0), reason=f"wet floor {number}")
        service.save(Edits(zones=(zone,)).model_dump(mode="json"), number - 1, str(number))

    return write


def _edits_kept(folder: Path) -> int:
    versions = EditVersions(folder)
    newest = versions.newest()
    assert versions.problem == "" and newest.by == (str(newest.number) if newest.number else "")
    names = sorted(path.name for path in folder.glob("*.json*"))
    assert names == [f"{number:04d}.json" for number in range(1, newest.number + 1)]
    assert _edit_service(folder).view().version == newest.number
    return newest.number


def _step(number: int) -> PilotStep:
    now = 100.0 + 0.01 * number
    telemetry = Telemetry(now, DroneStatus.FLYING, 0.8, height=1.1)
    estimate = Estimate(now, _HOME, (0.0, 0.0, 0.0), 0.1, 0.02, 0.004)
    outputs = Outputs(Command(Action.HOVER), estimate=estimate)
    return PilotStep(number, now, Inputs(telemetry=telemetry), outputs)


def _recording(folder: Path) -> Write:
    house = _house()
    recorder = FlightRecorder(folder, house.site, house.room, house.grid)
    return lambda number: recorder.add_step(_step(number))


def _recording_kept(folder: Path) -> int:
    if not (folder / "flight.mcap").exists():
        return 0
    steps = list(read_steps(folder))
    assert [step.sequence for step in steps] == list(range(1, len(steps) + 1))
    assert all(step == _step(step.sequence) for step in steps)
    return len(steps)


def _console(folder: Path) -> Write:
    memory = ConsoleMemory(folder)
    memory.read(time.monotonic())

    def write(number: int) -> None:
        event = EventView(number, time.monotonic(), Severity.INFO, "test", _WORDS)
        memory.keep_event(event)
        memory.keep_control(KeptControl(number, stop_holds=number % 3 > 0, stop_by=str(number)))

    return write


def _console_kept(folder: Path) -> int:
    kept = ConsoleMemory(folder).read(time.monotonic())
    numbers = [event.number for event in kept.events]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers))) if numbers else True
    assert all(event.text == _WORDS for event in kept.events)
    control = kept.control
    if control.holder is None:
        assert not kept.events or numbers == [1]
        return 0
    assert control == KeptControl(
        control.holder, stop_holds=control.holder % 3 > 0, stop_by=str(control.holder)
    )
    assert numbers[-1] - control.holder in (0, 1)
    return control.holder


def _audit(folder: Path) -> Write:
    log = AuditLog(folder / "commands.jsonl")
    return lambda number: log.record("kim", "session", str(number))


def _audit_kept(folder: Path) -> int:
    """Return how many lines there are, after one more: what was torn must not tear that too."""
    log = AuditLog(file := folder / "commands.jsonl")
    log.record("kim", "session", "after")
    log.close()
    *before, last = file.read_bytes().split(b"\n")[:-1]
    assert json.loads(last)["what"] == "after"
    if before and not before[-1].endswith(b"}"):
        before.pop()  # torn
    numbers = [int(json.loads(line)["what"]) for line in before]
    assert numbers == list(range(1, len(numbers) + 1))
    return len(numbers)


def _flight_log(folder: Path) -> Write:
    writer = FlightLogWriter(folder, "bsen")
    path = PathMessage(1, (), 0.0)

    def write(number: int) -> None:
        step = _step(number)
        now = 100.0 + SAMPLE_PERIOD * number
        writer.hear(PilotStep(number, now, step.inputs, step.outputs), 1, lambda: path)

    return write


def _flight_log_kept(folder: Path) -> int:
    book = FlightBook(folder)
    names = [path.stem for path in folder.glob("*.jsonl") if path.stat().st_size]
    assert len(names) <= 1
    if not names or b"\n" not in (folder / f"{names[0]}.jsonl").read_bytes():
        return 0
    replay = book.replay(names[0])
    assert not replay.flight.complete
    assert [round(t / SAMPLE_PERIOD) for t in replay.t] == list(range(len(replay.t)))
    return len(replay.t)


STORES = {
    "the queue": CrashingStore(_queue, _queue_kept, is_acknowledged=True, is_synced_in_c=True),
    "mode and rules": CrashingStore(_rules, _rules_kept, is_acknowledged=True),
    "clips": CrashingStore(_clips, _clips_kept, 1.0 / CLIP_RATE_HZ, is_synced_in_c=True),
    "edits": CrashingStore(_edits, _edits_kept, is_acknowledged=True),
    "a recording": CrashingStore(_recording, _recording_kept, 0.01),
    # It is of the run, which ends with the power.
    "the console": CrashingStore(_console, _console_kept, outlives_power=False),
    "commands": CrashingStore(_audit, _audit_kept),
    "a flight's log": CrashingStore(_flight_log, _flight_log_kept, 0.02),
}


def write_for_ever(store: CrashingStore, disk: Path, said: Path) -> None:
    """Write until somebody kills this process, and say line by line what was written, and when."""
    disk.mkdir(parents=True, exist_ok=True)
    write = store.begin(disk)
    with said.open("a", buffering=1) as told:
        for number in count(1):
            at = time.monotonic()
            write(number)
            told.write(f"{number} {at}\n")
            time.sleep(store.pause)
