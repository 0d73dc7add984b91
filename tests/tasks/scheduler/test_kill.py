"""Killed at any moment, the program forgets nothing that it acknowledged, and starts nothing."""

from __future__ import annotations

import random
import signal
import subprocess
import sys
import time
from pathlib import Path

from housefly.tasks.api.values import ENDED, ReasonCode, TaskStage
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.task_store import TaskStore
from housefly.tasks.scheduler.values import (
    DroneAvailability,
    SchedulerLimits,
    StartTask,
    TaskEnded,
)

LIMITS = SchedulerLimits()
KILLS = 12
_PROGRAM = """
import random, sys, time
from pathlib import Path
from housefly.tasks.api.values import ENDED, Priority, TaskRequest, TaskStage, TaskStatus
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.task_store import KeptTask, TaskStore
from housefly.tasks.scheduler.transitions import ACTIVE
from housefly.tasks.scheduler.values import *

store, dice = TaskStore(Path(sys.argv[1])), random.Random(int(sys.argv[3]))
scheduler = store.load(SchedulerLimits())


def status_of(task):
    one = task.request
    return TaskStatus(task.id, one.service, task.traits.title, one.parameters, task.stage,
        task.code, task.words, one.asked_by, one.surface, one.cause, one.priority, task.asked_at,
        task.started_at, task.ended_at, one.deadline, (), task.question, task.rehearsal)


def take(outcome, said):
    global scheduler
    before = {id(task) for task in scheduler.tasks}
    scheduler, decisions = outcome
    changed = [task for task in scheduler.tasks if id(task) not in before]
    changed += [each.task for each in decisions if isinstance(each, TaskEnded)]
    store.save(KeptTask(task, status_of(task)) for task in changed)
    for task in changed:
        said.write(f"{task.id} {task.stage.name}\\n")


with open(sys.argv[2], "a", buffering=1) as said:
    take(scheduler.restarted(time.time()), said)
    said.write("0 begun\\n")
    while True:
        now = time.time()
        request = TaskRequest(str(dice.random()), asked_by=dice.choice("abc"),
            priority=dice.choice(list(Priority)))
        traits = TaskTraits("Look", flies=dice.random() < 0.8)
        take(scheduler.requested(request, traits, now), said)
        kinds = [TaskStage.RUNNING, TaskStage.RUNNING, TaskStage.DONE, TaskStage.FAILED]
        runs = [RunReport(task.id, dice.choice(kinds), is_safe_point=True)
            for task in scheduler.tasks if task.state in ACTIVE]
        take(scheduler.ticked(now, runs, DroneAvailability(True)), said)
"""


def said_by(path: Path) -> dict[int, str]:
    """Return the last acknowledged stage of each task; a line cut in two was not said."""
    lines = path.read_text().split("\n")[:-1] if path.exists() else []
    return {int(number): stage for number, stage in (line.split() for line in lines)}


def begun(path: Path) -> int:
    return path.read_text().count("0 begun") if path.exists() else 0


def test_a_dozen_kills_take_back_nothing_that_was_said(tmp_path: Path) -> None:
    database, said, dice = tmp_path / "tasks" / "tasks.db", tmp_path / "said", random.Random(5)
    for kill in range(KILLS):
        command = [sys.executable, "-c", _PROGRAM, str(database), str(said), str(kill)]
        process = subprocess.Popen(command)
        try:
            deadline = time.monotonic() + 60.0
            while begun(said) <= kill and time.monotonic() < deadline:
                time.sleep(0.005)
            time.sleep(dice.uniform(0.0, 0.1))
        finally:
            process.send_signal(signal.SIGKILL)
            process.wait(10.0)
        assert begun(said) == kill + 1 and process.returncode == -signal.SIGKILL
        check(database, said_by(said))
    assert len(said_by(said)) > KILLS


def check(database: Path, said: dict[int, str]) -> None:
    store = TaskStore(database)
    kept = store.load(LIMITS)
    assert store.notices == ()
    stages = {number: status.state for number in said if (status := store.status(number))}
    said.pop(0)
    # What was saved last may not have been said yet: then it has gone on, never back.
    assert set(said) <= set(stages)
    for number, stage in said.items():
        if TaskStage[stage] in ENDED:
            assert stages[number] is TaskStage[stage]
    assert kept.next_id > max(said, default=0)
    assert {task.id for task in kept.tasks} >= {
        number for number, stage in stages.items() if stage not in ENDED
    }
    after, decisions = kept.restarted(time.time())
    for each in decisions:
        assert isinstance(each, TaskEnded) and each.task.code is ReasonCode.RESTARTED
    assert all(task.stage is TaskStage.WAITING for task in after.tasks if task.traits.flies)
    _, decisions = after.ticked(time.time(), (), DroneAvailability(True))
    assert not any(isinstance(each, StartTask) and _flies(after, each.id) for each in decisions)
    store.close()


def _flies(scheduler: Scheduler, number: int) -> bool:
    return scheduler.task(number).traits.flies
