"""Every input to a task in every state, cell by cell, through the scheduler itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import pytest

from housefly.errors import TaskError
from housefly.tasks.api.values import (
    ENDED,
    Confirm,
    OnPreempt,
    Priority,
    ReasonCode,
    RehearsalReport,
    TaskRequest,
    TaskStage,
)
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.transitions import STAGES, TRANSITIONS, QueueState, TaskSignal
from housefly.tasks.scheduler.values import (
    Decision,
    DroneAvailability,
    RunReport,
    TaskEnded,
    TaskTraits,
)

READY, BUSY = DroneAvailability(True), DroneAvailability(False, "the drone charges")
END, LATE = 1000.0, 10_000.0
Move = tuple[Scheduler, tuple[Decision, ...]]


def asked_for(
    scheduler: Scheduler, priority: Priority, then: OnPreempt, confirm: Confirm = Confirm.AUTO
) -> Scheduler:
    request = TaskRequest(priority.value, priority=priority, confirm=confirm, deadline=END)
    return scheduler.requested(request, TaskTraits(priority.value, on_preempt=then), 0.0)[0]


def ticked(scheduler: Scheduler, *runs: RunReport, now: float = 1.0) -> Scheduler:
    return scheduler.ticked(now, runs, READY)[0]


def waiting(then: OnPreempt) -> Scheduler:
    return asked_for(Scheduler(), Priority.RULE, then, Confirm.ASK)


def queued(then: OnPreempt) -> Scheduler:
    return asked_for(Scheduler(), Priority.RULE, then)


def held(then: OnPreempt) -> Scheduler:
    return queued(then).paused(1, "", 1.0)[0]


def running(then: OnPreempt) -> Scheduler:
    return ticked(queued(then))


def paused(then: OnPreempt) -> Scheduler:
    return running(then).paused(1, "", 1.0)[0]


def ending(then: OnPreempt) -> Scheduler:
    return running(then).cancelled(1, "", 1.0)[0]


def suspended(then: OnPreempt) -> Scheduler:
    """The alarm that took the drone ended; the drone is not ready since."""
    return without_alarm(running(OnPreempt.RESUME))


def held_suspended(then: OnPreempt) -> Scheduler:
    return without_alarm(paused(OnPreempt.RESUME))


def asked_again(then: OnPreempt) -> Scheduler:
    return ticked(suspended(then), now=900.0)


def without_alarm(scheduler: Scheduler) -> Scheduler:
    alarmed = asked_for(scheduler, Priority.ALARM, OnPreempt.END)
    flown = ticked(alarmed, RunReport(1, is_safe_point=True))
    return flown.ticked(2.0, (RunReport(2, TaskStage.DONE),), BUSY)[0]


REACHED: dict[QueueState, Callable[[OnPreempt], Scheduler]] = {
    QueueState.WAITING: waiting,
    QueueState.ASKED_AGAIN: asked_again,
    QueueState.QUEUED: queued,
    QueueState.HELD: held,
    QueueState.RUNNING: running,
    QueueState.PAUSED: paused,
    QueueState.ENDING: ending,
    QueueState.SUSPENDED: suspended,
    QueueState.HELD_SUSPENDED: held_suspended,
}


def reported(stage: TaskStage) -> Callable[[Scheduler], Move]:
    return lambda scheduler: scheduler.ticked(910.0, (RunReport(1, stage),), BUSY)


def alarm(scheduler: Scheduler) -> Move:
    alarmed = asked_for(scheduler, Priority.ALARM, OnPreempt.END)
    return alarmed.ticked(2.0, (RunReport(1, is_safe_point=True),), READY)


INPUTS: dict[str, Callable[[Scheduler], Move]] = {
    "yes": lambda scheduler: scheduler.replied(1, "yes", "", 910.0),
    "no": lambda scheduler: scheduler.replied(1, "no", "", 910.0),
    "yes, late": lambda scheduler: scheduler.replied(1, "yes", "", LATE),
    "perhaps": lambda scheduler: scheduler.replied(1, "perhaps", "", 910.0),
    "cancel": lambda scheduler: scheduler.cancelled(1, "", 910.0),
    "cancel all": lambda scheduler: scheduler.cancelled(0, "", 910.0),
    "pause": lambda scheduler: scheduler.paused(1, "", 910.0),
    "continue": lambda scheduler: scheduler.continued(1, "", 910.0),
    "nothing": lambda scheduler: scheduler.ticked(2.0, (), BUSY),
    "drone ready": lambda scheduler: scheduler.ticked(3.0, (), READY),
    "drone ready, late": lambda scheduler: scheduler.ticked(990.0, (), READY),
    "deadline": lambda scheduler: scheduler.ticked(END, (), BUSY),
    "run done": reported(TaskStage.DONE),
    "run failed": reported(TaskStage.FAILED),
    "run cancelled": reported(TaskStage.CANCELLED),
    "run refused": reported(TaskStage.REFUSED),
    "run expired": reported(TaskStage.EXPIRED),
    "run goes on": reported(TaskStage.RUNNING),
    "alarm, resume": alarm,
    "alarm, restart": alarm,
    "alarm, end": alarm,
    "can be flown": lambda scheduler: scheduler.rehearsed(
        1, RehearsalReport(True, ReasonCode.OK, ""), 910.0
    ),
    "no way": lambda scheduler: scheduler.rehearsed(
        1, RehearsalReport(False, ReasonCode.NO_WAY, "no way there"), 910.0
    ),
    "restart": lambda scheduler: scheduler.restarted(910.0),
}


def replied_early(scheduler: Scheduler, choice: str) -> Move:
    return scheduler.replied(1, choice, "", 60.0)


_WORDS = "wait asks queue held run pause ends susp heldS DONE FAIL CANC REFU EXPI"
WORDS = dict(zip(_WORDS.split(), QueueState, strict=True))
# A dash is refused, a dot changes nothing, the rest is the new state.
TABLE = """
                  wait  asks  queue held  run   pause ends  susp  heldS
yes               queue susp  -     -     -     -     -     -     -
no                REFU  CANC  -     -     -     -     -     -     -
yes, late         EXPI  EXPI  -     -     -     -     -     -     -
perhaps           -     -     -     -     -     -     -     -     -
cancel            CANC  CANC  CANC  CANC  ends  ends  .     CANC  CANC
cancel all        CANC  CANC  CANC  CANC  ends  ends  .     CANC  CANC
pause             -     -     held  .     pause .     -     heldS .
continue          -     -     .     queue .     run   -     .     susp
nothing           .     .     .     .     .     .     .     .     .
drone ready       .     .     run   .     .     .     .     run   .
drone ready, late EXPI  .     wait  .     .     .     .     asks  .
deadline          EXPI  .     EXPI  EXPI  .     .     .     .     .
run done          EXPI  .     .     .     DONE  DONE  DONE  .     .
run failed        EXPI  .     .     .     FAIL  FAIL  FAIL  .     .
run cancelled     EXPI  .     .     .     CANC  CANC  CANC  .     .
run refused       EXPI  .     .     .     REFU  REFU  REFU  .     .
run expired       EXPI  .     .     .     EXPI  EXPI  EXPI  .     .
run goes on       EXPI  .     .     .     .     .     .     .     .
alarm, resume     .     .     .     .     susp  heldS CANC  .     .
alarm, restart    .     .     .     .     queue held  CANC  .     .
alarm, end        .     .     .     .     CANC  CANC  CANC  .     .
can be flown      .     .     .     .     .     .     .     .     .
no way            REFU  REFU  REFU  REFU  .     .     .     REFU  REFU
restart           .     FAIL  wait  wait  FAIL  FAIL  FAIL  FAIL  FAIL
"""


def cells() -> list[tuple[str, QueueState, str]]:
    _, *rows = TABLE.strip("\n").splitlines()
    width = 18
    return [
        (row[:width].strip(), state, cell)
        for row in rows
        for state, cell in zip(REACHED, row[width:].split(), strict=True)
    ]


@pytest.mark.parametrize("state", REACHED)
def test_every_state_is_reached(state: QueueState) -> None:
    assert REACHED[state](OnPreempt.RESUME).task(1).state is state


@pytest.mark.parametrize(("name", "state", "cell"), cells())
def test_every_input_in_every_state_does_what_the_table_says(
    name: str, state: QueueState, cell: str
) -> None:
    then = OnPreempt(name.partition(", ")[2]) if name.startswith("alarm") else OnPreempt.RESUME
    before = REACHED[state](then)
    give = INPUTS[name]
    if name in ("yes", "no") and state is QueueState.WAITING:
        give = partial(replied_early, choice=name)
    if cell == "-":
        with pytest.raises(TaskError):
            give(before)
        return
    after, decisions = give(before)
    expected = state if cell == "." else WORDS[cell]
    ended = [each.task for each in decisions if isinstance(each, TaskEnded) and each.task.id == 1]
    if STAGES[expected] in ENDED:
        assert [task.state for task in ended] == [expected]
        assert all(task.ended_at is not None for task in ended)
        with pytest.raises(TaskError, match="no open task"):
            after.task(1)
    else:
        assert not ended
        task = after.task(1)
        assert task.state is expected
        is_asked = expected in (QueueState.WAITING, QueueState.ASKED_AGAIN)
        assert (task.question is not None) == is_asked


def test_the_test_has_every_input_for_every_open_state() -> None:
    assert len(cells()) == len(INPUTS) * len(REACHED)
    assert {name for name, _, _ in cells()} == set(INPUTS)
    assert set(REACHED) == {state for state in QueueState if STAGES[state] not in ENDED}


def test_the_table_is_total_and_no_task_leaves_an_end() -> None:
    assert set(TRANSITIONS) == set(TaskSignal)
    for row in TRANSITIONS.values():
        assert set(row) == set(QueueState)
        for state in QueueState:
            if STAGES[state] in ENDED:
                assert row[state] in (None, state)


BESIDE = {
    "wait": "wait",
    "queue": "queue",
    "held": "held",
    "run": "FAIL",
    "pause": "FAIL",
    "ends": "FAIL",
}


@pytest.mark.parametrize("word", BESIDE)
def test_after_a_restart_what_does_not_fly_stays_in_the_queue(word: str) -> None:
    before = REACHED[WORDS[word]](OnPreempt.RESUME)
    (task,) = before.tasks
    beside = replace(task, traits=replace(task.traits, flies=False))
    after, decisions = replace(before, tasks=(beside,)).restarted(910.0)
    ended = tuple(each.task for each in decisions if isinstance(each, TaskEnded))
    (task,) = (*after.tasks, *ended)
    assert task.state is WORDS[BESIDE[word]]
    assert (task.code is ReasonCode.RESTARTED) == bool(ended)
