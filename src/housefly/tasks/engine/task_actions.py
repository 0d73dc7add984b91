"""Does what a running task wants done: orders, clips, words, questions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from housefly.errors import HouseflyError
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_values import StartClip, TakeSnapshot
from housefly.hub.api.told_events import ToldEventKind
from housefly.messages import Order, OrderKind, OrderSource
from housefly.messages.words import literal
from housefly.tasks.api.values import ParameterValue, PersonQuestion, RequestSurface, TaskStatus
from housefly.tasks.engine.task_drones import TaskDrone, TaskDrones
from housefly.tasks.engine.task_outlet import TaskOutlet, task_event, task_name
from housefly.tasks.engine.task_record import TaskRecord
from housefly.tasks.execution.step_inbox import task_sender
from housefly.tasks.execution.values import (
    AskPerson,
    CloseQuestion,
    GiveOrder,
    PublishMqtt,
    Report,
    Say,
    StopClip,
    TaskAction,
)
from housefly.tasks.scheduler.values import ScheduledTask

_ORDER_SOURCES = {
    RequestSurface.RULE: OrderSource.RULE,
    RequestSurface.ASSISTANT: OrderSource.ASSISTANT,
}
"""What gives the orders of a task that no person asked for."""
_REPORT_LINES_MAX = 100
"""Most lines of a task's report."""
_CLIP_EVENTS: dict[str, ToldEventKind] = {"clip": "clip kept", "snapshot": "snapshot kept"}


class TaskActions:
    """Does the actions of tasks, one after the other; never raises for what a task wants.

    Args:
        outlet: takes orders, events and MQTT.
        drones: with their recorders; what happens is told of the one whose task it is.
    """

    def __init__(self, outlet: TaskOutlet, drones: TaskDrones) -> None:
        self._outlet, self._drones = outlet, drones
        self._filming_drones: dict[int, str] = {}  # by the id of the task that films
        self._handlers: dict[type[TaskAction], Callable[[_ActionContext, Any], None]] = {
            GiveOrder: self._order,
            StartClip: self._start_clip,
            StopClip: lambda context, _: self._stop_clip(context.task.id),
            TakeSnapshot: self._snapshot,
            Say: self._say,
            AskPerson: self._ask,
            CloseQuestion: self._close_question,
            PublishMqtt: lambda _, wanted: self._outlet.publish_mqtt(wanted.topic, wanted.payload),
            Report: self._report,
        }

    def perform(
        self,
        task: ScheduledTask,
        record: TaskRecord,
        actions: tuple[TaskAction, ...],
        now: float,
        unix: float,
    ) -> None:
        """Do what a task wants.

        Args:
            task: whose actions these are.
            record: of the task.
            actions: in order.
            now: the pilot's clock, which stamps orders [s].
            unix: the same moment as Unix time [s].
        """
        context = _ActionContext(task, record, now, unix)
        for action in actions:
            self._handlers[type(action)](context, action)

    def tell(
        self, kind: ToldEventKind, task: ScheduledTask, unix: float, **facts: str | float | bool
    ) -> None:
        """Tell the room's memory what became of a task; the cause is the task, or its own cause."""
        cause = task.request.cause if kind == "task asked" else task_name(task.id)
        known: dict[str, ParameterValue] = {
            "task": float(task.id),
            "service": task.request.service,
            "because": task.request.cause,
        }
        body = self._drones.or_first(task.drone).body
        self._outlet.tell(task_event(kind, body, unix, cause, known | facts))

    def tell_asked(self, task: ScheduledTask, unix: float) -> None:
        """Tell that a task was asked for, and what a person is asked now [Unix time, s]."""
        by = task.request.asked_by or "somebody"
        self.tell("task asked", task, unix, title=task.traits.title, by=by)
        if task.question is not None:
            # A millisecond later: the memory sorts what happened at once by other things.
            self.tell("person asked", task, unix + 0.001, words=task.question.words)

    def tell_ended(self, task: ScheduledTask, status: TaskStatus, unix: float) -> None:
        """Tell how a task ended [Unix time, s]."""
        self.tell("task ended", task, unix, outcome=status.state.value, words=status.words)

    def tell_clip(self, drone: TaskDrone, clip: str, unix: float) -> int:
        """Tell that a clip is kept; return the number of its task, 0 for a person's or unknown."""
        try:
            info = drone.clips.index.info(clip)
        except HouseflyError:
            return 0
        facts = {"clip": clip, "place": info.place, "thing": info.thing}
        cause = task_name(info.task) if info.task else info.cause
        event = task_event(_CLIP_EVENTS[info.kind], drone.body, unix, cause, dict(facts))
        self._outlet.tell(event)
        return info.task

    def send_home(self, drone: str, now: float) -> None:
        """Send home a drone that no task flies any more; ``now`` stamps the order [s]."""
        sender, source = task_sender(0, "home"), OrderSource.TASK
        order = Order(OrderKind.HOME, issued_at=now, sender=sender, source=source)
        self._outlet.order(order, drone)

    def end_clip(self, task_id: int) -> None:
        """End the clip of a task that ends, however it ended."""
        self._stop_clip(task_id)

    def _stop_clip(self, task_id: int) -> None:
        drone = self._filming_drones.pop(task_id, None)
        if drone is not None and drone not in self._filming_drones.values():
            self._drones[drone].clips.stop()

    def _order(self, context: _ActionContext, wanted: GiveOrder) -> None:
        request = context.task.request
        sender = task_sender(context.task.id, request.service)
        source = _ORDER_SOURCES.get(request.surface, OrderSource.TASK)
        order = replace(wanted.order, issued_at=context.now, sender=sender, source=source)
        self._outlet.order(order, self._drones.or_first(context.task.drone).name)

    def _start_clip(self, context: _ActionContext, wanted: StartClip) -> None:
        drone = self._drones.or_first(context.task.drone)
        self._filming_drones = {
            one: name for one, name in self._filming_drones.items() if name != drone.name
        }
        self._filming_drones[context.task.id] = drone.name
        context.keep(lambda: drone.clips.start(wanted, context.origin))

    def _snapshot(self, context: _ActionContext, wanted: TakeSnapshot) -> None:
        clips = self._drones.or_first(context.task.drone).clips
        context.keep(lambda: clips.snapshot(wanted, context.origin))

    def _say(self, context: _ActionContext, wanted: Say) -> None:
        self.tell("said", context.task, context.unix, words=wanted.words)
        self._outlet.say(wanted.words)

    def _ask(self, context: _ActionContext, wanted: AskPerson) -> None:
        until = None if wanted.timeout is None else context.unix + wanted.timeout
        words = literal(wanted.words)
        question = PersonQuestion(wanted.id, words, wanted.choices, until, wanted.otherwise)
        context.record.question = question
        self.tell("person asked", context.task, context.unix, words=wanted.words)

    def _close_question(self, context: _ActionContext, wanted: CloseQuestion) -> None:
        question = context.record.question
        if question is not None and question.id == wanted.id:
            context.record.question = None

    def _report(self, context: _ActionContext, wanted: Report) -> None:
        context.report(wanted.words)
        self.tell("found", context.task, context.unix, words=wanted.words)


class _ActionContext:
    """For which task something is done, and when."""

    def __init__(self, task: ScheduledTask, record: TaskRecord, now: float, unix: float) -> None:
        self.task, self.record, self.now, self.unix = task, record, now, unix

    @property
    def origin(self) -> ClipOrigin:
        request = self.task.request
        return ClipOrigin(self.task.id, request.service, request.cause)

    def report(self, words: str) -> None:
        if len(self.record.report) < _REPORT_LINES_MAX:
            self.record.report.append(words)

    def keep(self, record: Callable[[], str]) -> None:
        """Record something and remember its id, or report why it cannot be recorded."""
        try:
            self.record.clips.append(record())
        except HouseflyError as error:
            self.report(str(error))
