"""The scheduler as a pure value: each input gives the next scheduler, and what is to be done."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from housefly.errors import TaskError
from housefly.geometry import distance
from housefly.messages.words import Words
from housefly.tasks.api.values import (
    Confirm,
    ReasonCode,
    RehearsalReport,
    RequestSurface,
    TaskRequest,
    TaskStage,
)
from housefly.tasks.scheduler import turns
from housefly.tasks.scheduler.changes import QueueChanges
from housefly.tasks.scheduler.reasons import SOMEBODY
from housefly.tasks.scheduler.transitions import ACTIVE, QueueState, TaskSignal
from housefly.tasks.scheduler.values import (
    Decision,
    DroneAvailability,
    RunReport,
    ScheduledTask,
    SchedulerLimits,
    TaskAdmitted,
    TaskMerged,
    TaskTraits,
)

_STRICTNESS = {Confirm.AUTO: 0, Confirm.ASK: 1, Confirm.NEVER: 2}
_CLOCK_STEP = 1.0
"""A clock that goes back by less is only set right [s]."""
_ENDINGS = {
    TaskStage.DONE: TaskSignal.RUN_DONE,
    TaskStage.FAILED: TaskSignal.RUN_FAILED,
    TaskStage.CANCELLED: TaskSignal.RUN_CANCELLED,
    TaskStage.REFUSED: TaskSignal.RUN_REFUSED,
    TaskStage.EXPIRED: TaskSignal.RUN_EXPIRED,
}


@dataclass(frozen=True, slots=True)
class Scheduler:
    """What waits and what runs; no clock, no file.

    Times are Unix time [s]. Every method that returns a pair returns the next scheduler and what
    is to be done, in order; the old one stays as it was. A task that ended is only in the
    ``TaskEnded`` that says so.

    Attributes:
        limits: bounds of the queue.
        next_id: of the next task.
        tasks: the open ones, by id.
    """

    limits: SchedulerLimits = field(default_factory=SchedulerLimits)
    next_id: int = 1
    tasks: tuple[ScheduledTask, ...] = ()

    def task(self, task_id: int) -> ScheduledTask:
        """Return an open task; raises TaskError(UNKNOWN_TASK)."""
        return QueueChanges(self.limits, self.tasks).task(task_id)

    def requested(
        self, request: TaskRequest, traits: TaskTraits, now: float
    ) -> tuple[Scheduler, tuple[Decision, ...]]:
        """Take a request, its parameters complete: it is queued, asked about, merged or refused."""
        confirm = _confirm_of(request, traits)
        changes = QueueChanges(self.limits, self.tasks)
        task = self._new_task(request, traits, now)
        same = turns.same_that_waits(request, self.tasks)
        if confirm is Confirm.NEVER:
            words = Words("'{title}' is not allowed to start from here", title=traits.title)
            changes.refuse(task, ReasonCode.NOT_ALLOWED, words, now)
        elif request.deadline is not None and request.deadline <= now:
            changes.refuse(task, ReasonCode.DEADLINE, Words("its deadline is over already"), now)
        elif same is not None:
            changes.decide(TaskMerged(changes.merge(same, task, confirm, now)))
            return self._after(changes, self.next_id)
        elif words := changes.make_room(task, now, asks=confirm is Confirm.ASK):
            changes.refuse(task, ReasonCode.QUEUE_FULL, words, now)
        else:
            if confirm is Confirm.ASK:
                task = changes.asked(task, now, Words("Asked for by {who}", who=task.asker))
            changes.put(task)
            changes.decide(TaskAdmitted(task))
        return self._after(changes, self.next_id + 1)

    def replied(
        self, task_id: int, choice: str, by: str, now: float
    ) -> tuple[Scheduler, tuple[Decision, ...]]:
        """Take a person's yes or no to a task's confirmation; too late, it counts as none.

        Raises:
            TaskError: there is no such task, it asks nothing, or this is no answer to it.
        """
        changes = QueueChanges(self.limits, self.tasks)
        question = changes.task(task_id).question
        if question is None:
            raise TaskError(f"task {task_id} asks nothing now", ReasonCode.BAD_PARAMETER.value)
        if choice not in question.choices:
            allowed = " or ".join(question.choices)
            problem = f"'{choice}' is no answer to '{question.words}'; allowed: {allowed}"
            raise TaskError(problem, ReasonCode.BAD_PARAMETER.value)
        if question.until is not None and now >= question.until:
            changes.signal(task_id, TaskSignal.UNANSWERED, now)
        elif choice == "yes":
            changes.agree(task_id, by, now)
        else:
            changes.signal(task_id, TaskSignal.NO, now, Words("{who} said no", who=by or SOMEBODY))
        return self._after(changes)

    def cancelled(
        self, task_id: int, by: str, now: float
    ) -> tuple[Scheduler, tuple[Decision, ...]]:
        """End a task, or with 0 every open one; raises TaskError for one that is not open."""
        changes = QueueChanges(self.limits, self.tasks)
        for each in [task.id for task in self.tasks] if task_id == 0 else [task_id]:
            changes.order(
                each, TaskSignal.CANCEL, now, Words("{who} cancelled it", who=by or SOMEBODY)
            )
        return self._after(changes)

    def paused(self, task_id: int, by: str, now: float) -> tuple[Scheduler, tuple[Decision, ...]]:
        """Hold a task where it is; raises TaskError where there is nothing to hold."""
        changes = QueueChanges(self.limits, self.tasks)
        changes.order(task_id, TaskSignal.PAUSE, now, Words("{who} paused it", who=by or SOMEBODY))
        return self._after(changes)

    def continued(
        self, task_id: int, by: str, now: float
    ) -> tuple[Scheduler, tuple[Decision, ...]]:
        """Let a paused task go on; raises TaskError where there is nothing to continue."""
        changes = QueueChanges(self.limits, self.tasks)
        changes.order(
            task_id, TaskSignal.CONTINUE, now, Words("{who} continued it", who=by or SOMEBODY)
        )
        return self._after(changes)

    def rehearsed(
        self, task_id: int, report: RehearsalReport, now: float
    ) -> tuple[Scheduler, tuple[Decision, ...]]:
        """Keep what a rehearsal found; what cannot be flown and does not run is refused."""
        changes = QueueChanges(self.limits, self.tasks)
        changes.rehearsed(task_id, report, now)
        return self._after(changes)

    def ticked(
        self, now: float, runs: Sequence[RunReport], *drones: DroneAvailability
    ) -> tuple[Scheduler, tuple[Decision, ...]]:
        """Take what the runs report, end what is late, and start what may start."""
        changes = QueueChanges(self.limits, self.tasks)
        for run in runs:
            if run.stage in _ENDINGS:
                changes.run_ended(run, _ENDINGS[run.stage], now)
        self._end_late(changes, now)
        self._start_beside(changes, now)
        safe = {run.id for run in runs if run.is_safe_point}
        self._fly_next(changes, {one.name: one for one in drones if one.is_ready}, safe, now)
        return self._after(changes)

    def taken_over(self, now: float, drone: str) -> tuple[Scheduler, tuple[Decision, ...]]:
        """A person flies by hand: what could have that drone asks again before it takes off."""
        changes = QueueChanges(self.limits, self.tasks)
        for task in self.tasks:
            waits = task.state in (QueueState.QUEUED, QueueState.SUSPENDED)
            if task.traits.flies and waits and task.wanted_drone in ("", drone):
                changes.signal(task.id, TaskSignal.STALE, now)
        return self._after(changes)

    def restarted(self, now: float) -> tuple[Scheduler, tuple[Decision, ...]]:
        """Take over the open tasks of a program that ended: nothing flies without a fresh yes."""
        changes = QueueChanges(self.limits, self.tasks)
        for task in self.tasks:
            flies = task.traits.flies
            signal = TaskSignal.RESTARTED if flies else TaskSignal.RESTARTED_BESIDE
            changes.signal(task.id, signal, now)
        return self._after(changes)

    def _new_task(self, request: TaskRequest, traits: TaskTraits, now: float) -> ScheduledTask:
        task = ScheduledTask(
            id=self.next_id,
            request=request,
            traits=traits,
            state=QueueState.QUEUED,
            asked_at=now,
            turn=self.next_id,
            fresh_at=now,
        )
        return replace(task, turn=turns.turn_of(task, self.tasks, self.limits.queue))

    def _end_late(self, changes: QueueChanges, now: float) -> None:
        for task in self.tasks:
            deadline, question = task.request.deadline, task.question
            if question is not None and question.until is not None and now >= question.until:
                changes.signal(task.id, TaskSignal.UNANSWERED, now)
            if deadline is not None and now >= deadline and task.started_at is None:
                changes.signal(task.id, TaskSignal.DEADLINE, now)

    def _start_beside(self, changes: QueueChanges, now: float) -> None:
        while (task := turns.next_task(changes.open, flies=False)) is not None:
            if sum(_has_run(each, flies=False) for each in changes.open) >= self.limits.beside:
                return
            changes.signal(task.id, TaskSignal.TURN, now)

    def _fly_next(
        self,
        changes: QueueChanges,
        ready: dict[str, DroneAvailability],
        safe: set[int],
        now: float,
    ) -> None:
        """Start the next flights where a drone is free or can be taken; ask where one is stale."""
        passed = set[int]()
        while ready:
            waiting = [task for task in changes.open if task.id not in passed]
            if (task := turns.next_task(waiting, flies=True)) is None:
                return
            drone = _drone_for(task, ready.values(), changes.open, safe)
            if drone is None:
                passed.add(task.id)
                continue
            if not -_CLOCK_STEP <= now - task.fresh_at <= self.limits.fresh_time:
                changes.signal(task.id, TaskSignal.STALE, now)
                continue
            if (holder := holder_of(drone.name, changes.open)) is not None:
                changes.preempt(holder, task, now)
            changes.take(task.id, drone.name)
            changes.signal(task.id, TaskSignal.TURN, now)
            del ready[drone.name]

    def _after(
        self, changes: QueueChanges, next_id: int | None = None
    ) -> tuple[Scheduler, tuple[Decision, ...]]:
        following = Scheduler(self.limits, next_id or self.next_id, changes.open)
        return following, changes.decisions


def _confirm_of(request: TaskRequest, traits: TaskTraits) -> Confirm:
    """Return the strictest of what request and document say; no assistant makes anything fly."""
    asked_by_assistant = traits.flies and request.surface is RequestSurface.ASSISTANT
    surface = Confirm.ASK if asked_by_assistant else Confirm.AUTO
    return max(request.confirm, traits.confirm, surface, key=_STRICTNESS.__getitem__)


def _has_run(task: ScheduledTask, *, flies: bool) -> bool:
    return task.state in ACTIVE and task.traits.flies is flies


def holder_of(drone: str, tasks: Iterable[ScheduledTask]) -> ScheduledTask | None:
    """Return the task that has a drone, or None."""
    flying = (each for each in tasks if _has_run(each, flies=True))
    return next((each for each in flying if each.drone in ("", drone)), None)


def _drone_for(
    task: ScheduledTask,
    ready: Iterable[DroneAvailability],
    tasks: Sequence[ScheduledTask],
    safe: set[int],
) -> DroneAvailability | None:
    """Return the drone that a task takes: a free one, the nearest; else one that makes way."""
    fit = [one for one in ready if task.wanted_drone in ("", one.name)]
    holders = {one.name: holder_of(one.name, tasks) for one in fit}
    free = [one for one in fit if holders[one.name] is None]
    if free:
        return min(free, key=lambda one: _distance_to_go(one, task))
    for one in fit:
        if (holder := holders[one.name]) is not None and _may_take(task, holder, safe):
            return one
    return None


def _distance_to_go(drone: DroneAvailability, task: ScheduledTask) -> float:
    """Return how far a drone is from the farthest point of a task's way [m]; 0 where unknown."""
    way = task.rehearsal.way if task.rehearsal is not None else ()
    if drone.place is None or not way:
        return 0.0
    return distance(drone.place, max(way, key=lambda point: distance(way[0], point)))


def _may_take(task: ScheduledTask, holder: ScheduledTask, safe: set[int]) -> bool:
    return holder.id in safe and turns.is_more_urgent(
        task.request.priority, holder.request.priority
    )
