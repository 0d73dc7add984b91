"""What was asked for and what ended: told to the room's memory, and kept for the board."""

from __future__ import annotations

from collections import deque

from housefly.tasks.api.values import TaskStatus
from housefly.tasks.scheduler.task_store import TaskStore
from housefly.tasks.scheduler.values import ScheduledTask
from housefly.tasks.task_actions import TaskActions

_SHOWN = 20
"""So many ended tasks are on the board."""


class TaskChronicle:
    """The tasks that ended lately, and who is told of tasks.

    Args:
        store: of the queue and the history.
        actions: tells the memory.
    """

    def __init__(self, store: TaskStore, actions: TaskActions) -> None:
        self._store, self._actions = store, actions
        self._ended: deque[TaskStatus] = deque(store.newest_ended(_SHOWN), _SHOWN)

    @property
    def ended(self) -> tuple[TaskStatus, ...]:
        """The tasks that ended last, the newest first."""
        return tuple(self._ended)

    def known(self, number: int) -> TaskStatus | None:
        """Return a task as it ended, or as it was kept last; None when nobody knows it."""
        found = next((one for one in self._ended if one.id == number), None)
        return found or self._store.status(number)

    def was_asked(self, task: ScheduledTask, unix: float) -> None:
        """Tell that a task was asked for, and what a person is asked now [Unix time, s]."""
        by = task.request.asked_by or "somebody"
        self._actions.tell("task asked", task, unix, title=task.traits.title, by=by)
        if task.question is not None:
            # A millisecond later: the memory sorts what happened at once by other things.
            self._actions.tell("person asked", task, unix + 0.001, words=task.question.words)

    def has_ended(self, task: ScheduledTask, status: TaskStatus, unix: float) -> None:
        """Tell how a task ended [Unix time, s]."""
        self._actions.end_clip(task.id)
        self._ended.appendleft(status)
        outcome = status.state.value
        self._actions.tell("task ended", task, unix, outcome=outcome, words=status.words)
