"""One input's changes to the queue: tasks move by the table, each move says what is to be done."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from housefly.errors import TaskError
from housefly.messages.words import UNSAID, Words, joined
from housefly.tasks.api.values import (
    ATTENDED,
    ENDED,
    Confirm,
    OnPreempt,
    PersonQuestion,
    ReasonCode,
    RehearsalReport,
    TaskRequest,
)
from housefly.tasks.scheduler import turns
from housefly.tasks.scheduler.queue_room import room_for
from housefly.tasks.scheduler.reasons import ASKING_REASONS, END_REASONS, ORDER_REFUSALS, SOMEBODY
from housefly.tasks.scheduler.transitions import (
    QUESTIONING,
    STAGES,
    TRANSITIONS,
    QueueState,
    TaskSignal,
)
from housefly.tasks.scheduler.values import (
    CONFIRM,
    CancelRun,
    ContinueRun,
    Decision,
    PauseRun,
    PreemptTask,
    ResumeTask,
    RunReport,
    ScheduledTask,
    SchedulerLimits,
    StartTask,
    TaskEnded,
)

_Q = QueueState
_PREEMPTIONS = {
    OnPreempt.RESUME: TaskSignal.SET_ASIDE,
    OnPreempt.RESTART: TaskSignal.START_OVER,
    OnPreempt.END: TaskSignal.BROKEN_OFF,
}


class QueueChanges:
    """The open tasks while one input changes them, and the decisions so far."""

    def __init__(self, limits: SchedulerLimits, tasks: Iterable[ScheduledTask]) -> None:
        self._limits = limits
        self._tasks = {task.id: task for task in tasks}
        self._decisions: list[Decision] = []

    @property
    def open(self) -> tuple[ScheduledTask, ...]:
        """The open tasks, by id."""
        return tuple(self._tasks.values())

    @property
    def decisions(self) -> tuple[Decision, ...]:
        """What is to be done, in order."""
        return tuple(self._decisions)

    def task(self, task_id: int) -> ScheduledTask:
        """Return an open task; raises TaskError(UNKNOWN_TASK)."""
        if task_id not in self._tasks:
            problem = f"no open task has the number {task_id}"
            raise TaskError(problem, ReasonCode.UNKNOWN_TASK.value)
        return self._tasks[task_id]

    def decide(self, decision: Decision) -> None:
        """Add a decision."""
        self._decisions.append(decision)

    def put(self, task: ScheduledTask) -> None:
        """Add a task, or replace it; one that ended leaves the queue and is told."""
        if task.stage in ENDED:
            self._tasks.pop(task.id, None)
            self.decide(TaskEnded(task))
        else:
            self._tasks[task.id] = task

    def refuse(self, task: ScheduledTask, code: ReasonCode, words: Words, now: float) -> None:
        """End a request that never comes into the queue."""
        state = _Q.EXPIRED if code is ReasonCode.DEADLINE else _Q.REFUSED
        self.put(replace(task, state=state, code=code, words=words, ended_at=now))

    def order(self, task_id: int, signal: TaskSignal, now: float, words: Words) -> None:
        """Do what a person orders; raises TaskError where the table refuses it."""
        task = self.task(task_id)
        if TRANSITIONS[signal][task.state] is None:
            problem = f"task {task_id} is {task.stage.value}: {ORDER_REFUSALS[signal]}"
            raise TaskError(problem, ReasonCode.NOT_READY.value)
        self.signal(task_id, signal, now, words)

    def signal(
        self,
        task_id: int,
        signal: TaskSignal,
        now: float,
        words: Words = UNSAID,
        code: ReasonCode | None = None,
    ) -> None:
        """Move an open task by the table; ``words`` and ``code`` say why instead of the usual."""
        task = self._tasks.get(task_id)
        target = TRANSITIONS[signal][task.state] if task is not None else None
        if task is None or target is None or (target is task.state and signal not in _RENEWS):
            return
        reason, usual = END_REASONS.get(signal, (ReasonCode.OK, UNSAID))
        moved = replace(task, state=target, words=words or usual, question=None)
        if STAGES[target] in ENDED:
            moved = replace(moved, code=code or reason, ended_at=now)
        elif target in QUESTIONING:
            moved = self.asked(moved, now, ASKING_REASONS[signal])
        elif signal is TaskSignal.TURN:
            moved = replace(moved, started_at=now if task.started_at is None else task.started_at)
        if target is _Q.ENDING:
            self.decide(CancelRun(task.id, moved.words))
        elif (decision := _DECISIONS.get((task.state, target))) is not None:
            self.decide(decision(task.id))
        self.put(moved)

    def asked(self, task: ScheduledTask, now: float, why: Words) -> ScheduledTask:
        """Return the task with the question whether it may begin."""
        began = task.state in (_Q.SUSPENDED, _Q.ASKED_AGAIN)
        title = _goal_of(task)
        words = Words("Start '{title}'? {why}.", title=title, why=why)
        if began:
            words = Words("Go on with '{title}'? {why}.", title=title, why=why)
        elif task.traits.flies:
            words = Words("Fly '{title}'? {why}.", title=title, why=why)
        question = PersonQuestion(
            id=CONFIRM,
            words=words,
            until=now + self._limits.confirm_time,
        )
        state = _Q.ASKED_AGAIN if began else _Q.WAITING
        return replace(task, state=state, question=question, words=why)

    def take(self, task_id: int, drone: str) -> None:
        """Give a task the drone that is to fly it."""
        self._tasks[task_id] = replace(self.task(task_id), drone=drone)

    def agree(self, task_id: int, by: str, now: float) -> None:
        """Take a yes: from now on the task counts as freshly wanted."""
        self._tasks[task_id] = replace(self.task(task_id), fresh_at=now)
        self.order(task_id, TaskSignal.YES, now, Words("{who} said yes", who=by or SOMEBODY))

    def merge(
        self, same: ScheduledTask, task: ScheduledTask, confirm: Confirm, now: float
    ) -> ScheduledTask:
        """Let a task that waits take over a second request for the same, and return it.

        A request that needs a yes itself makes nothing fly: it changes only what still waits for
        one.
        """
        if confirm is Confirm.AUTO:
            self._tasks[same.id] = replace(same, fresh_at=now)
            self.signal(same.id, TaskSignal.YES, now)
        merged = self.task(same.id)
        if confirm is Confirm.AUTO or merged.state is _Q.WAITING:
            merged = replace(merged, request=_joined(merged, task))
        merged = replace(merged, words=Words("also asked for by {who}", who=task.asker))
        self.put(merged)
        return merged

    def make_room(self, task: ScheduledTask, now: float, *, asks: bool) -> Words:
        """Let another one make way for a new task where it must; return why it may not wait.

        Args:
            task: the new one.
            now: Unix time [s].
            asks: whether it would wait for a yes.
        """
        room = room_for(task, self.open, self._limits, asks=asks)
        if room.makes_way is not None:
            words = Words("the queue was full, it made way for '{title}'", title=task.traits.title)
            self.signal(room.makes_way.id, TaskSignal.MADE_WAY, now, words)
        return room.refusal

    def rehearsed(self, task_id: int, report: RehearsalReport, now: float) -> None:
        """Keep a rehearsal; a task that does not run ends when it cannot be flown."""
        self.put(replace(self.task(task_id), rehearsal=report))
        if not report.may_fly:
            self.signal(task_id, TaskSignal.IMPOSSIBLE, now, report.words, report.code)

    def run_ended(self, run: RunReport, signal: TaskSignal, now: float) -> None:
        """Take the end of a run; of a task that has none it says nothing."""
        self.signal(run.id, signal, now, run.words, run.code)

    def preempt(self, holder: ScheduledTask, taker: ScheduledTask, now: float) -> None:
        """Take the drone from the task that has it, as its document says."""
        signal = _PREEMPTIONS[holder.traits.on_preempt]
        target = TRANSITIONS[signal][holder.state]
        self.decide(PreemptTask(holder.id, is_kept=target in (_Q.SUSPENDED, _Q.HELD_SUSPENDED)))
        self._tasks[holder.id] = replace(holder, fresh_at=now)
        self.signal(
            holder.id, signal, now, Words("'{title}' took the drone", title=taker.traits.title)
        )


_DECISIONS: dict[tuple[QueueState, QueueState], Callable[[int], Decision]] = {
    (_Q.QUEUED, _Q.RUNNING): StartTask,
    (_Q.SUSPENDED, _Q.RUNNING): ResumeTask,
    (_Q.RUNNING, _Q.PAUSED): PauseRun,
    (_Q.PAUSED, _Q.RUNNING): ContinueRun,
}
"""What a move asks of the run."""
_RENEWS = frozenset({TaskSignal.RESTARTED, TaskSignal.RESTARTED_BESIDE, TaskSignal.CANCEL})
"""Signals that ask again where a question is open, or cut short what is done on a cancel."""


def _goal_of(task: ScheduledTask) -> str:
    """Return what would be done: in the words in which it was asked for, or with what it is for."""
    if task.request.sentence:
        return task.request.sentence
    given = task.request.parameters.values()
    about = next((one for one in given if one and isinstance(one, str)), "")
    return joined(": ", (task.traits.title, about)) if about else task.traits.title


def _joined(task: ScheduledTask, other: ScheduledTask) -> TaskRequest:
    one, two = task.request, other.request
    urgent = turns.is_more_urgent(two.priority, one.priority)
    deadlines = (one.deadline, two.deadline)
    later = None if None in deadlines else max(each for each in deadlines if each is not None)
    joined = replace(one, priority=two.priority if urgent else one.priority, deadline=later)
    if two.surface in ATTENDED and one.surface not in ATTENDED:
        # What a person wants too is a person's from now on.
        return replace(joined, asked_by=two.asked_by, surface=two.surface, owner=two.owner)
    return joined
