"""Whether one more task may wait, and which one makes way for it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from housefly.messages.words import UNSAID, Words, figure
from housefly.tasks.api.values import Priority
from housefly.tasks.scheduler import turns
from housefly.tasks.scheduler.transitions import ACTIVE, QUESTIONING
from housefly.tasks.scheduler.values import ScheduledTask, SchedulerLimits


@dataclass(frozen=True, slots=True)
class QueueRoom:
    """Which task makes way, None for none; and why there is no room."""

    makes_way: ScheduledTask | None = None
    refusal: Words = UNSAID


def room_for(
    task: ScheduledTask, tasks: Iterable[ScheduledTask], limits: SchedulerLimits, *, asks: bool
) -> QueueRoom:
    """Return whether a new task finds room among the open ones.

    Args:
        task: the new one.
        tasks: the open ones.
        limits: of the queue.
        asks: whether the new one would wait for a yes.
    """
    waiting = [each for each in tasks if each.state not in ACTIVE]
    same = _of_source(task, waiting)
    if (asks or not task.is_attended) and len(same) >= limits.per_source:
        words = _wait_already(task, len(same))
        return _taken_from(turns.least_urgent(task, same), words)
    if len(waiting) < limits.queue:
        return QueueRoom()
    lesser = turns.least_urgent(task, waiting)
    if lesser is None and _is_spare_alarm(task, waiting, limits):
        return QueueRoom()
    return _taken_from(
        lesser, Words("{n} tasks wait already; cancel one or ask later", n=figure(limits.queue))
    )


def _taken_from(lesser: ScheduledTask | None, refusal: Words) -> QueueRoom:
    return QueueRoom(lesser) if lesser is not None else QueueRoom(refusal=refusal)


def _is_spare_alarm(
    task: ScheduledTask, waiting: list[ScheduledTask], limits: SchedulerLimits
) -> bool:
    """Return whether an alarm may wait although nobody makes way for it."""
    alarms = sum(each.request.priority is Priority.ALARM for each in waiting)
    return task.request.priority is Priority.ALARM and alarms < limits.alarms


def _of_source(task: ScheduledTask, waiting: list[ScheduledTask]) -> list[ScheduledTask]:
    """Return what is counted with a new task: of a person only what waits for a yes."""
    return [
        each
        for each in waiting
        if (each.is_attended, each.source) == (task.is_attended, task.source)
        and (not task.is_attended or each.state in QUESTIONING)
    ]


def _wait_already(task: ScheduledTask, count: int) -> Words:
    who = task.asker if task.is_attended else task.request.surface.value
    return Words("{n} tasks of {who} wait already; answer or cancel one", n=figure(count), who=who)
