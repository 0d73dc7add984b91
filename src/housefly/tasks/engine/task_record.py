"""One task as the service holds it: what it is bound to, its run, and what came of it so far."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import dataclass, field

from housefly.messages.words import UNSAID, Words
from housefly.tasks.api.values import (
    ENDED,
    PersonQuestion,
    ReasonCode,
    RehearsalReport,
    TaskStage,
    TaskStatus,
    TaskStepStatus,
)
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.execution.task_run import TaskRun
from housefly.tasks.execution.values import PersonReply
from housefly.tasks.scheduler.values import RunReport, ScheduledTask


@dataclass(slots=True)
class TaskRecord:
    """What is known of a task besides its place in the queue.

    Attributes:
        task: bound to its parameters.
        run: behavior tree; None until it begins.
        resumes_after_rehearsal: whether the run goes on as soon as it has been rehearsed again.
        rehearsal: under way; None when there is none.
        attempts: rehearsals that ended.
        rehearsed_at: when the newest rehearsal ended [Unix time, s].
        ending: how it ended when its run cannot say so itself.
        question: that its run asks people.
        replies: that its run has not seen yet.
        clips, report: what came of it.
        steps: how far they are, or were.
        took_off_at: when the drone was first in the air for it [Unix time, s].
        flown: how long it was in the air for it [s]; None where nobody knows whether it was.
        airborne_at: when it was last seen in the air, by the pilot's clock [s].
        recording: folder into which the whole run is recorded, or "".
        drone: with which it is, or was, rehearsed; "" for any.
    """

    task: BoundTask
    run: TaskRun | None = None
    resumes_after_rehearsal: bool = False
    rehearsal: Future[RehearsalReport] | None = None
    attempts: int = 0
    rehearsed_at: float = float("-inf")
    ending: RunReport | None = None
    question: PersonQuestion | None = None
    replies: list[PersonReply] = field(default_factory=list)
    clips: list[str] = field(default_factory=list)
    report: list[str] = field(default_factory=list)
    steps: tuple[TaskStepStatus, ...] = ()
    took_off_at: float | None = None
    flown: float | None = 0.0
    airborne_at: float | None = None
    recording: str = ""
    drone: str = ""

    def watch_flight(self, is_airborne: bool, now: float, unix: float) -> None:
        """Count the time in the air.

        Args:
            is_airborne: whether the drone flies now.
            now: the pilot's clock [s].
            unix: the same moment as Unix time [s].
        """
        if is_airborne and self.took_off_at is None:
            self.took_off_at = unix
        if is_airborne and self.airborne_at is not None:
            self.flown = (self.flown or 0.0) + max(0.0, now - self.airborne_at)
        self.airborne_at = now if is_airborne else None

    def abandon(self, code: ReasonCode, words: Words, stage: TaskStage = TaskStage.FAILED) -> None:
        """End it here, without another step of its run."""
        self.ending = RunReport(0, stage, code, words)

    def take_replies(self) -> tuple[PersonReply, ...]:
        """Return the replies that are new, once."""
        replies, self.replies = tuple(self.replies), []
        return replies


def task_status(
    task: ScheduledTask, record: TaskRecord | None, waiting: Words = UNSAID
) -> TaskStatus:
    """Return a task as the board shows it.

    Args:
        task: in the queue, or as it ended.
        record: what else is known of it.
        waiting: why it does not run yet, in words.
    """
    request, run = task.request, record.run if record else None
    is_open = task.stage not in ENDED
    words, stage = task.words, task.stage
    if is_open and record is not None:
        if record.rehearsal is not None:
            words = words or Words("it is rehearsed")
        elif task.stage is TaskStage.QUEUED:
            words = words or waiting
        elif run is not None and task.stage is TaskStage.RUNNING:
            words = run.words or words
    return TaskStatus(
        task.id,
        request.service,
        task.traits.title,
        dict(request.parameters),
        stage,
        task.code,
        words,
        request.asked_by,
        request.surface,
        request.cause,
        request.priority,
        task.asked_at,
        task.started_at,
        task.ended_at,
        request.deadline,
        record.steps if record else (),
        (task.question or (record.question if record else None)) if is_open else None,
        task.rehearsal,
        tuple(record.clips) if record else (),
        tuple(record.report) if record else (),
        record.took_off_at if record else None,
        record.flown if record else 0.0,
        record.recording if record and record.took_off_at is not None else "",
        task.drone or request.drone,
        run.look if run is not None and is_open else None,
    )
