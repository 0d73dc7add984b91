"""Collects the pilot's steps between two ticks of a task."""

from __future__ import annotations

import threading
from collections import deque

from housefly.messages import (
    DroneStatus,
    Event,
    Order,
    OrderAnswer,
    OrderKind,
    OrderSource,
    PilotStep,
)
from housefly.messages.order_fault import NAME_LENGTH_MAX
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.tasks.execution.values import PersonReply, TaskInputs

_MAX_KEPT = 200
"""At most this many events, orders and answers between two ticks are told, the newest."""
SILENT_TIME = 1.0
"""A pilot silent for longer [s] gets no orders: what is known of the flight is old."""


def task_sender(task: int, service: str) -> str:
    """Return who a task's orders are from: "task 12: look"."""
    return f"task {task}: {service}"[:NAME_LENGTH_MAX]


_OF_TASKS = frozenset({OrderSource.TASK, OrderSource.RULE, OrderSource.ASSISTANT})


def _is_of_task(order: Order) -> bool:
    """Return whether a task gave an order, whoever asked for the task; no task ever gives STOP."""
    return order.source in _OF_TASKS and order.kind is not OrderKind.STOP


class StepInbox:
    """Makes the inputs of a tick from the steps since the last one; thread-safe.

    Attributes:
        steps: heard so far.
        run: counts the pilot's starts as heard here: a new one knows of no mission.
        is_flown_by_task: whether the last order was a task's.
    """

    def __init__(self) -> None:
        self.steps = self.run = 0
        self.is_flown_by_task = False
        self._lock = threading.Lock()
        self._step: PilotStep | None = None
        self._events: deque[Event] = deque(maxlen=_MAX_KEPT)
        self._orders: deque[Order] = deque(maxlen=_MAX_KEPT)
        self._answers: deque[OrderAnswer] = deque(maxlen=_MAX_KEPT)

    def add(self, step: PilotStep) -> None:
        """Add a step, from any thread."""
        with self._lock:
            if self._step is not None and step.sequence < self._step.sequence:
                self.run += 1
                self.is_flown_by_task = False  # a new pilot knows of no task
            self.steps += 1
            self._step = step
            self._events.extend(step.outputs.events)
            self._answers.extend(step.outputs.answers)
            for order in step.inputs.orders:
                self.is_flown_by_task = _is_of_task(order)
                if not self.is_flown_by_task:
                    self._orders.append(order)

    @property
    def newest(self) -> PilotStep | None:
        """The newest step; None before the first."""
        return self._step

    def age(self, now: float) -> float:
        """Return how long the pilot has been silent [s]; infinity before its first step."""
        step = self._step
        return float("inf") if step is None else now - step.now

    @property
    def is_airborne(self) -> bool:
        """Whether the drone said that it flies, when it was last heard."""
        return self.status in AIRBORNE_STATUSES

    @property
    def status(self) -> DroneStatus | None:
        """What the drone last said that it does."""
        step = self._step
        telemetry = None if step is None else step.inputs.telemetry
        return None if telemetry is None else telemetry.status

    def fresh_status(self, now: float) -> DroneStatus | None:
        """Return what the drone says that it does; None when that is old."""
        telemetry = None if self._step is None else self._step.inputs.telemetry
        if telemetry is None or now - telemetry.received_at > SILENT_TIME:
            return None
        return telemetry.status

    def give_up(self) -> None:
        """No task has the drone any more, though it flies."""
        self.is_flown_by_task = False

    def drain(
        self,
        now: float,
        unix: float,
        replies: tuple[PersonReply, ...] = (),
        *,
        keep: bool = False,
    ) -> TaskInputs:
        """Return the inputs of a tick; each event, order and answer is told once.

        Args:
            now: the pilot's clock [s].
            unix: the same moment as Unix time [s].
            replies: of people, since the last tick.
            keep: whether those are told again at the next tick.
        """
        with self._lock:
            step, events, orders = self._step, tuple(self._events), tuple(self._orders)
            answers = tuple(self._answers)
            if not keep:
                self._events.clear()
                self._orders.clear()
                self._answers.clear()
        if step is None:
            return TaskInputs(now, unix, replies=replies)
        outputs, telemetry = step.outputs, step.inputs.telemetry
        estimate = outputs.estimate
        return TaskInputs(
            now,
            unix,
            None if telemetry is None else telemetry.status,
            outputs.phase,
            outputs.safety,
            outputs.goal_name,
            None if estimate is None else estimate.position,
            None if estimate is None else estimate.yaw,
            events,
            outputs.warnings,
            replies,
            None if telemetry is None else telemetry.battery,
            orders,
            0.0 if estimate is None else estimate.pose_age,
            answers,
        )
