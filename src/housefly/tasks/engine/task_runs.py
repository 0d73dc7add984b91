"""The runs of the tasks: begun after a fresh rehearsal, stepped on fresh news of the pilot only."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from housefly.messages import Order, OrderKind, OrderSource, Phase
from housefly.messages.words import Words, literal
from housefly.tasks.api.values import ENDED, ReasonCode, RehearsalReport, TaskStage
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.engine.task_actions import TaskActions
from housefly.tasks.engine.task_drones import TaskDrones
from housefly.tasks.engine.task_record import TaskRecord
from housefly.tasks.engine.task_rehearsals import RehearsalUrgency, TaskRehearsals
from housefly.tasks.execution.step_inbox import SILENT_TIME, StepInbox
from housefly.tasks.execution.task_run import TaskRun
from housefly.tasks.execution.values import GiveOrder, TaskInputs
from housefly.tasks.scheduler.transitions import ACTIVE, QueueState
from housefly.tasks.scheduler.values import (
    CancelRun,
    ContinueRun,
    Decision,
    DroneAvailability,
    PauseRun,
    PreemptTask,
    ResumeTask,
    RunReport,
    ScheduledTask,
    StartTask,
)

_log = logging.getLogger(__name__)

READY_TIMEOUT = 60.0
"""A drone that is not ready so long after its task's turn ends the task [s]."""
PILOT_LOST_TIMEOUT = 3.0
"""A pilot silent for longer [s] ends the task: by then the drone hovers or lands by itself."""
_STRANDED_PHASES = frozenset({Phase.OUTBOUND, Phase.LOOKING, Phase.HOLDING})
"""Phases from which nobody would bring a drone home for a long time."""
_HOME_REPEAT_TIME = 3.0
"""It is sent home again after this [s]."""


class TaskRuns:
    """The records of the open tasks, and their runs; not thread-safe.

    Attributes:
        person_ordered: the drones that a person ordered since the step before the last.
        recording: folder into which the whole run is recorded, or "".

    Args:
        drones: their pilots' steps, and what runs may ask.
        rehearsals: each flight is rehearsed first.
        actions: does what runs want done.
    """

    def __init__(
        self, drones: TaskDrones, rehearsals: TaskRehearsals, actions: TaskActions
    ) -> None:
        self._drones, self._rehearsals, self._actions = drones, rehearsals, actions
        self._records: dict[int, TaskRecord] = {}
        self._pilots = {name: _PilotWatch(drone.inbox) for name, drone in drones.items()}
        self._sent_home_at = dict.fromkeys(drones, float("-inf"))
        self.person_ordered: frozenset[str] = frozenset()
        self.recording = ""
        self._handlers: dict[type[Decision], Callable[[TaskRecord, Any], None]] = {
            StartTask: _start,
            PreemptTask: _preempt,
            ResumeTask: lambda record, _: self._resume_task(record),
            CancelRun: _cancel,
            PauseRun: lambda record, _: _pause(record),
            ContinueRun: lambda record, _: _resume(record),
        }

    def add(
        self, task_id: int, task: BoundTask, drone: str = "", *, is_attended: bool = True
    ) -> TaskRecord:
        """Take a task; one that flies is rehearsed soon, so that people hear early.

        Args:
            task_id: of the task.
            task: bound to its parameters.
            drone: that is to fly it; "" for any.
            is_attended: whether a person waits for it.
        """
        name = self._drones.or_first(drone).name
        record = self._records[task_id] = TaskRecord(task, recording=self.recording, drone=name)
        if task.flies:
            urgency = RehearsalUrgency.FLIGHT if is_attended else RehearsalUrgency.MACHINE
            self._rehearsals.begin(record, urgency)
        return record

    def record(self, task_id: int) -> TaskRecord | None:
        """Return the record of an open task, or None."""
        return self._records.get(task_id)

    def remove(self, task_id: int) -> TaskRecord | None:
        """Drop a task and its run without another step; return its record."""
        record = self._records.pop(task_id, None)
        if record is not None and record.rehearsal is not None:
            record.rehearsal.cancel()
        return record

    def drop_clip(self, clip: str, words: str) -> None:
        """Forget a clip that could not be kept, and say so in the report of its task."""
        for record in self._records.values():
            if clip in record.clips:
                record.clips.remove(clip)
                record.report.append(words)

    def decide(self, decision: Decision) -> None:
        """Do what the scheduler decided about a run; other decisions are not for here."""
        act = self._handlers.get(type(decision))
        record = self._records.get(getattr(decision, "id", 0))
        if act is not None and record is not None:
            act(record, decision)

    def rehearsed(self, unix: float) -> Iterable[tuple[int, RehearsalReport]]:
        """Yield the rehearsals that ended since the last call, by task."""
        for task_id, record in self._records.items():
            report = self._rehearsals.take_report(record, unix)
            if report is not None:
                yield task_id, report

    def step(
        self,
        tasks: Iterable[ScheduledTask],
        drones: Iterable[DroneAvailability],
        now: float,
        unix: float,
    ) -> tuple[RunReport, ...]:
        """Step every active run once, as far as the pilot's news are fresh; return how far it is.

        Args:
            tasks: of the queue.
            drones: whether each may be ordered now.
            now: the pilots' clock [s].
            unix: the same moment as Unix time [s].
        """
        availability = {one.name: one for one in drones}
        updates = {name: pilot.update(now, unix) for name, pilot in self._pilots.items()}
        self.person_ordered = frozenset(name for name, one in updates.items() if one.inputs.orders)
        reports = []
        for task in tasks:
            record = self._records.get(task.id)
            if record is None or task.state not in ACTIVE:
                continue
            _assign_drone(record, task.drone)
            pilot, drone = updates[record.drone], availability[record.drone]
            if record.run is None or record.resumes_after_rehearsal:
                if task.traits.flies and record.drone in self.person_ordered:
                    words = Words("a person ordered the drone before it began")
                    record.abandon(ReasonCode.PERSON_TOOK_OVER, words, TaskStage.CANCELLED)
                elif task.state is QueueState.RUNNING:  # not while it is paused
                    self._begin(task, record, drone, unix)
            elif task.traits.flies and pilot.lost_reason:
                record.abandon(ReasonCode.NOT_READY, literal(pilot.lost_reason))
            # What begins now gives its first order now: no tick is lost on the way into the air.
            is_heard = pilot.is_fresh and not pilot.lost_reason
            if not record.resumes_after_rehearsal and (not task.traits.flies or is_heard):
                self._step_one(task, record, pilot.inputs)
            if task.traits.flies and record.run is not None:
                record.watch_flight(self._is_airborne(record), now, unix)
            reports.append(_report_of(task.id, record))
        return tuple(reports)

    def leave_to_pilots(self, reports: Iterable[RunReport]) -> None:
        """Leave the drone to the pilot after a flight that ended; no other task takes it over."""
        for report in reports:
            record = self._records.get(report.id)
            has_run = record is not None and record.run is not None and record.task.flies
            if record is not None and report.stage in ENDED and has_run:
                self._drones[record.drone].inbox.give_up()

    def bring_home(self, name: str, now: float) -> None:
        """Send home a drone that a task left in the air, as when the next one was called off.

        Args:
            name: of the drone; no task has it.
            now: the pilot's clock [s].
        """
        inbox, is_due = self._drones[name].inbox, now - self._sent_home_at[name] > _HOME_REPEAT_TIME
        is_left, step = inbox.is_airborne and inbox.is_flown_by_task, inbox.newest
        if is_left and is_due and step is not None and step.outputs.phase in _STRANDED_PHASES:
            self._sent_home_at[name] = now
            self._actions.send_home(name, now)

    def _resume_task(self, record: TaskRecord) -> None:
        """Go on with a run that was set aside; from the ground only after another rehearsal."""
        if self._is_airborne(record) or not record.task.flies:
            _resume(record)
        else:
            record.resumes_after_rehearsal = True
            self._rehearsals.begin(record)

    def _is_airborne(self, record: TaskRecord) -> bool:
        return self._drones[record.drone].inbox.is_airborne

    def _begin(
        self, task: ScheduledTask, record: TaskRecord, drone: DroneAvailability, unix: float
    ) -> None:
        """Begin a run as soon as its rehearsal is fresh and says that it may fly."""
        if record.ending is not None:
            return
        if task.traits.flies and not self._rehearsals.is_fresh(record, unix):
            self._rehearsals.begin(record)
            return
        report = task.rehearsal if task.traits.flies else None
        if report is not None and not report.may_fly:
            record.abandon(report.code, report.words, TaskStage.REFUSED)
            return
        if task.traits.flies and not drone.is_ready:
            if task.started_at is not None and unix - task.started_at > READY_TIMEOUT:
                record.abandon(ReasonCode.NOT_READY, drone.words)
            return
        if record.run is not None:
            record.resumes_after_rehearsal = False
            record.run.resume()
            return
        record.run = TaskRun(record.task, self._drones[record.drone].room)
        self._actions.tell("task started", task, unix, title=task.traits.title)

    def _step_one(self, task: ScheduledTask, record: TaskRecord, inputs: TaskInputs) -> None:
        run = record.run
        if run is None or record.ending is not None:
            return
        try:
            actions = run.step(replace(inputs, replies=record.take_replies()))
        except Exception as error:
            _log.exception("task %d failed", task.id)
            words = Words(
                "a step failed inside ({error}); the log says why", error=type(error).__name__
            )
            record.abandon(ReasonCode.STEP_FAILED, words)
            is_up = task.traits.flies and self._is_airborne(record)
            actions = (GiveOrder(Order(OrderKind.HOME, source=OrderSource.TASK)),) if is_up else ()
        record.steps = run.steps
        self._actions.perform(task, record, actions, inputs.now, inputs.unix)


@dataclass(frozen=True, slots=True)
class _PilotUpdate:
    """What a pilot said since the last tick.

    Attributes:
        is_fresh: it has made a step, lately.
        lost_reason: why a flight can no longer be followed, or "".
        inputs: of the runs of its drone.
    """

    is_fresh: bool
    lost_reason: str
    inputs: TaskInputs


class _PilotWatch:
    """Tells what is new of one drone's pilot, and whether it still is the same."""

    def __init__(self, inbox: StepInbox) -> None:
        self._inbox, self._run, self._steps = inbox, inbox.run, -1

    def update(self, now: float, unix: float) -> _PilotUpdate:
        age = self._inbox.age(now)
        is_fresh = self._inbox.steps != self._steps and age <= SILENT_TIME
        inputs = self._inbox.drain(now, unix, keep=not is_fresh)
        lost_reason = self._lost_reason(age)
        self._steps, self._run = self._inbox.steps, self._inbox.run
        return _PilotUpdate(is_fresh, lost_reason, inputs)

    def _lost_reason(self, age: float) -> str:
        if self._inbox.run != self._run:
            return "the pilot was started again; the drone comes home or lands by itself"
        if age > PILOT_LOST_TIMEOUT:
            return "the pilot does not answer; the drone lands by itself"
        return ""


def _assign_drone(record: TaskRecord, drone: str) -> None:
    """Let another drone than the one that was rehearsed fly a task: it is rehearsed anew."""
    if drone in ("", record.drone):
        return
    if record.rehearsal is not None:
        record.rehearsal.cancel()
    record.drone, record.rehearsal, record.rehearsed_at = drone, None, float("-inf")


def _report_of(task_id: int, record: TaskRecord) -> RunReport:
    if record.ending is not None:
        return replace(record.ending, id=task_id)
    run = record.run
    if run is None:
        return RunReport(task_id, is_safe_point=True)
    stage = run.stage if run.stage in ENDED else TaskStage.RUNNING
    return RunReport(task_id, stage, run.code, run.words, run.is_safe_point)


def _start(record: TaskRecord, _: StartTask) -> None:
    record.run, record.ending, record.resumes_after_rehearsal = None, None, False


def _preempt(record: TaskRecord, decision: PreemptTask) -> None:
    if decision.is_kept:
        _pause(record)
    else:
        record.run = None


def _pause(record: TaskRecord) -> None:
    if record.run is not None:
        record.run.pause()


def _resume(record: TaskRecord) -> None:
    if record.run is not None:
        record.run.resume()


def _cancel(record: TaskRecord, decision: CancelRun) -> None:
    if record.run is None:
        record.abandon(ReasonCode.CANCELLED, decision.words, TaskStage.CANCELLED)
    else:
        record.run.cancel(decision.words)
