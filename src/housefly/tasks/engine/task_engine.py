"""Runs the tasks of the drones: the queue, and what its decisions mean. Driven by ``tick``.

Nothing here reads a clock or opens a wire: time comes in, orders go out by the outlet.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import replace

from housefly.config.house_mode import HouseMode
from housefly.errors import TaskError
from housefly.messages import Order, OrderKind, OrderSource
from housefly.messages.words import UNSAID, Words, error_words, literal, said
from housefly.tasks.api.values import (
    ATTENDED,
    ReasonCode,
    RehearsalReport,
    RequestSurface,
    TaskRequest,
    TaskStage,
    TaskStatus,
)
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.engine.task_actions import TaskActions
from housefly.tasks.engine.task_drones import TaskDrones
from housefly.tasks.engine.task_record import task_status
from housefly.tasks.engine.task_runs import TaskRuns
from housefly.tasks.execution.values import GiveOrder, PersonReply
from housefly.tasks.rules.mode_table import launch_permit
from housefly.tasks.scheduler.board import board_order, waiting_words
from housefly.tasks.scheduler.scheduler import Scheduler, holder_of
from housefly.tasks.scheduler.task_store import KeptTask, TaskStore
from housefly.tasks.scheduler.transitions import ACTIVE, QueueState
from housefly.tasks.scheduler.values import (
    CONFIRM,
    Decision,
    DroneAvailability,
    RunReport,
    ScheduledTask,
    SchedulerLimits,
    TaskAdmitted,
    TaskEnded,
    TaskMerged,
    TaskTraits,
)

_DOUBLE_CLICK_TIME = 5.0
"""The same wish of the same asker within this is one wish [s]."""
_ENDED_SHOWN = 20
"""So many ended tasks are on the board."""
_ONLY_OWN = "you can end only what you asked for; STOP is for all"


class TaskEngine:
    """The open tasks of the drones; not thread-safe.

    Args:
        store: keeps the queue and what ended.
        limits: of the queue.
        runs: of the open tasks.
        actions: does and tells.
        drones: of the site.
    """

    def __init__(
        self,
        store: TaskStore,
        limits: SchedulerLimits,
        runs: TaskRuns,
        actions: TaskActions,
        drones: TaskDrones,
    ) -> None:
        self._drones = drones
        self._available = tuple(
            DroneAvailability(False, Words("the tasks have just begun"), name) for name in drones
        )
        self._store, self._runs, self._actions = store, runs, actions
        self._scheduler = store.load(limits)
        self._ended: deque[TaskStatus] = deque(store.newest_ended(_ENDED_SHOWN), _ENDED_SHOWN)

    def restore(self, bind: Callable[[TaskRequest], BoundTask], unix: float) -> None:
        """Take over the tasks of a program that ended: what flew ends, what waits is asked again.

        Args:
            bind: binds a request to its document; raises TaskError.
            unix: Unix time [s].
        """
        for task in self._scheduler.tasks:
            try:
                bound = bind(task.request)
                if scheduling_traits(bound) != task.traits:
                    raise _bad(f"'{task.traits.title}' was changed meanwhile; ask again")
                record = self._runs.add(
                    task.id, bound, task.request.drone, is_attended=task.is_attended
                )
                if (before := self._ended_or_stored(task.id)) is not None:
                    record.clips, record.report = list(before.clips), list(before.report)
                    record.steps = before.steps
                    record.took_off_at, record.flown = before.took_off_at, before.flown
                    if task.started_at is not None and before.took_off_at is None:
                        record.flown = None  # it may have flown since it was kept
            except TaskError as error:
                report = RehearsalReport(False, ReasonCode.BAD_PARAMETER, error_words(error))
                self._commit(self._scheduler.rehearsed(task.id, report, unix), unix)
        self._commit(self._scheduler.restarted(unix), unix)

    @property
    def problem(self) -> str:
        """Why the queue cannot be kept, in words, or ""."""
        return self._store.problem

    @property
    def open(self) -> tuple[TaskStatus, ...]:
        """The open tasks, as they will fly, each with why it does not yet."""
        waits = waiting_words(self._scheduler, *self._available)
        return tuple(
            task_status(task, self._runs.record(task.id), waits.get(task.id, UNSAID))
            for task in board_order(self._scheduler)
        )

    @property
    def ended(self) -> tuple[TaskStatus, ...]:
        """The tasks that ended last, the newest first."""
        return tuple(self._ended)

    def request(self, request: TaskRequest, task: BoundTask, unix: float) -> TaskStatus:
        """Take a request, its parameters complete; return its task, which may be refused.

        Args:
            request: who wants what.
            task: what it is bound to.
            unix: Unix time [s].
        """
        if (same := self._asked_just_now(request, unix)) is not None:
            return self.status(same.id)
        outcome = self._scheduler.requested(request, scheduling_traits(task), unix)
        told = [
            one.task
            for one in outcome[1]
            if isinstance(one, TaskAdmitted | TaskMerged)
            or (isinstance(one, TaskEnded) and one.task.request is request)
        ]
        for decision in outcome[1]:
            if isinstance(decision, TaskAdmitted):
                is_attended = request.surface in ATTENDED
                self._runs.add(decision.task.id, task, request.drone, is_attended=is_attended)
        self._commit(outcome, unix)
        return self.status(told[0].id)

    def _asked_just_now(self, request: TaskRequest, unix: float) -> ScheduledTask | None:
        """Return the same running task of the same asker: a second click wants no second flight."""
        wanted = _request_key(request)
        for task in self._scheduler.tasks:
            is_new = 0.0 <= unix - task.asked_at <= _DOUBLE_CLICK_TIME
            if task.state is QueueState.RUNNING and is_new and _request_key(task.request) == wanted:
                return task
        return None

    def reply(self, task_id: int, question: str, choice: str, by: str, unix: float) -> TaskStatus:
        """Answer a question of a task; raises TaskError when there is none, or not this answer."""
        record, task = self._runs.record(task_id), self._scheduler.task(task_id)
        asked = record.question if record is not None and question != CONFIRM else None
        if asked is None or record is None:
            if question != CONFIRM:
                raise _bad(f"task {task_id} does not ask {question!r} now")
            self._commit(self._scheduler.replied(task_id, choice, by, unix), unix)
            self._actions.tell("person answered", task, unix, words=choice, by=by)
            return self.status(task_id)
        if asked.id != question or choice not in asked.choices:
            raise _bad(f"{choice!r} is no answer to {asked.words!r}: {' or '.join(asked.choices)}")
        record.question = None
        record.replies.append(PersonReply(question, choice, by))
        self._actions.tell("person answered", task, unix, words=choice, by=by)
        return self.status(task_id)

    def cancel(
        self, task_id: int, by: str, unix: float, only_of: str = ""
    ) -> tuple[TaskStatus, ...]:
        """End a task, or with 0 every open one, and return those.

        Args:
            task_id: of the task.
            by: who ends it, for people.
            unix: Unix time [s].
            only_of: id of whose tasks may be ended; "" for all.

        Raises:
            TaskError: there is no such task, or it is of somebody else.
        """
        wanted = [self._scheduler.task(task_id)] if task_id else list(self._scheduler.tasks)
        if only_of:
            wanted = [task for task in wanted if task.request.owner == only_of]
            if not wanted:
                raise TaskError(_ONLY_OWN, ReasonCode.NOT_ALLOWED.value)
        for task in wanted:
            self._commit(self._scheduler.cancelled(task.id, by, unix), unix)
        return tuple(self.status(task.id) for task in wanted)

    def pause(self, task_id: int, by: str, unix: float) -> TaskStatus:
        """Let a task hover, or hold it in the queue; raises TaskError."""
        self._commit(self._scheduler.paused(task_id, by, unix), unix)
        return self.status(task_id)

    def resume(self, task_id: int, by: str, unix: float) -> TaskStatus:
        """Go on with a paused task; raises TaskError."""
        self._commit(self._scheduler.continued(task_id, by, unix), unix)
        return self.status(task_id)

    def tick(self, drones: tuple[DroneAvailability, ...], now: float, unix: float) -> None:
        """Step the runs, take what ended, start what may start.

        Args:
            drones: whether each may be ordered now.
            now: the pilot's clock [s].
            unix: the same moment as Unix time [s].
        """
        self._available = drones
        self._store.retry()
        for task_id, report in tuple(self._runs.rehearsed(unix)):
            self._commit(self._scheduler.rehearsed(task_id, report, unix), unix)
        reports = self._runs.step(self._scheduler.tasks, drones, now, unix)
        for name in sorted(self._runs.person_ordered):
            self._commit(self._scheduler.taken_over(unix, name), unix)
        self._runs.leave_to_pilots(reports)
        self._commit(self._scheduler.ticked(unix, reports, *drones), unix)
        for name in self._drones:
            if holder_of(name, self._scheduler.tasks) is None:
                self._runs.bring_home(name, now)

    def change_mode(self, mode: HouseMode, unix: float) -> None:
        """End the flights that may not be asked for in the new mode of the house.

        Args:
            mode: of the house.
            unix: Unix time [s].
        """
        for task in self._scheduler.tasks:
            request = task.request
            if task.state is QueueState.ENDING:
                continue  # a second cancel would leave out what it does on the first
            permit = launch_permit(
                mode,
                request.surface,
                confirm=request.confirm,
                priority=request.priority,
                names_mode=request.surface is RequestSurface.RULE,
                flies=task.traits.flies,
            )
            if not permit.is_given:
                by = f"mode {mode.value} of the house"
                self._commit(self._scheduler.cancelled(task.id, by, unix), unix)

    def meant_task(self, only_of: str = "", drone: str = "") -> int | None:
        """Return the task that people mean when they name none: what flies, flies next, is open.

        Args:
            only_of: id of whose tasks count; "" for all.
            drone: with which drone; "" for any.
        """
        tasks = sorted(
            (
                one
                for one in board_order(self._scheduler)
                if only_of in ("", one.request.owner)
                and drone in ("", one.drone or one.wanted_drone)
            ),
            key=lambda task: (not task.traits.flies, task.state not in ACTIVE),
        )
        return tasks[0].id if tasks else None

    def close(self, words: str, now: float, unix: float) -> None:
        """End what runs, because the program ends; what flies is sent home.

        Args:
            words: why.
            now: the pilot's clock [s].
            unix: the same moment as Unix time [s].
        """
        active = [task for task in self._scheduler.tasks if task.state in ACTIVE]
        for task in active:
            record = self._runs.record(task.id)
            has_run = record is not None and record.run is not None
            is_up = record is not None and self._drones[record.drone].inbox.is_airborne
            if has_run and record is not None and task.traits.flies and is_up:
                home = (GiveOrder(Order(OrderKind.HOME, source=OrderSource.TASK)),)
                self._actions.perform(task, record, home, now, unix)
        why = literal(words)
        reports = [
            RunReport(task.id, TaskStage.CANCELLED, ReasonCode.CANCELLED, why) for task in active
        ]
        self._commit(self._scheduler.ticked(unix, reports), unix)

    def keep_clip(self, task_id: int, clip: str, words: str = "") -> None:
        """Remember a clip or snapshot of an open task, and report what is wrong with it."""
        record = self._runs.record(task_id)
        if record is None:
            return
        if clip not in record.clips:
            record.clips.append(clip)
        if words:
            record.report.append(words)

    def drop_clip(self, clip: str, words: str) -> None:
        """Forget a clip or snapshot that could not be kept, and report why."""
        self._runs.drop_clip(clip, words)

    def status(self, task_id: int) -> TaskStatus:
        """Return a task, open or ended lately; raises TaskError."""
        for task in self._scheduler.tasks:
            if task.id == task_id:
                return task_status(task, self._runs.record(task_id))
        if (known := self._ended_or_stored(task_id)) is not None:
            return known
        raise TaskError(f"there is no task {task_id}", ReasonCode.UNKNOWN_TASK.value)

    def _commit(self, outcome: tuple[Scheduler, tuple[Decision, ...]], unix: float) -> None:
        """Take the next queue: it is kept first, then what it means is done."""
        before = {task.id: task for task in self._scheduler.tasks}
        self._scheduler, decisions = outcome
        changed = [task for task in self._scheduler.tasks if before.get(task.id) is not task]
        ended = [one.task for one in decisions if isinstance(one, TaskEnded)]
        statuses = {task.id: self._end_status(task) for task in ended}
        kept = [KeptTask(task, task_status(task, self._runs.record(task.id))) for task in changed]
        self._store.keep([*kept, *(KeptTask(task, statuses[task.id]) for task in ended)])
        for decision in decisions:
            if isinstance(decision, TaskAdmitted):
                self._actions.tell_asked(decision.task, unix)
            elif isinstance(decision, TaskEnded):
                task, status = decision.task, statuses[decision.task.id]
                self._runs.remove(task.id)
                self._actions.end_clip(task.id)
                self._ended.appendleft(status)
                self._actions.tell_ended(task, status, unix)
            else:
                self._runs.decide(decision)

    def _ended_or_stored(self, task_id: int) -> TaskStatus | None:
        """Return a task as it ended, or as it was kept last; None when nobody knows it."""
        found = next((one for one in self._ended if one.id == task_id), None)
        return found or self._store.status(task_id)

    def _end_status(self, task: ScheduledTask) -> TaskStatus:
        status = task_status(task, self._runs.record(task.id))
        return replace(status, words=task.words or said(task.stage))


def _request_key(request: TaskRequest) -> tuple[object, ...]:
    """Return what makes two requests the same wish."""
    one = request
    return one.service, one.parameters, one.asked_by, one.owner, one.drone


def scheduling_traits(task: BoundTask) -> TaskTraits:
    """Return what the scheduler must know of a task."""
    return TaskTraits(task.title, task.flies, task.confirm, task.on_preempt)


def _bad(words: str) -> TaskError:
    return TaskError(words, ReasonCode.BAD_PARAMETER.value)
