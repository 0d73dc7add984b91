"""Follows one task from the terminal until it ends, and prints what changes."""

from __future__ import annotations

import sys
import time
from typing import TYPE_CHECKING

from housefly.app.task_words import question_line, rehearsal_line, step_line, task_line
from housefly.app.terminal import plain_console
from housefly.config.text import without_numbers
from housefly.tasks.api.values import ENDED, TaskStage, TaskStatus, TaskStepState

if TYPE_CHECKING:
    from housefly.tasks.client.task_queries import TaskQueries

_LOOK_PERIOD = 0.25
"""Time between two looks at the task [s]."""
_TOLD_STEPS = frozenset({TaskStepState.RUNNING, TaskStepState.DONE, TaskStepState.FAILED})


class TaskProgress:
    """Prints what is new of a task since it was last shown."""

    def __init__(self) -> None:
        self._told: set[str] = set()

    def show(self, task: TaskStatus) -> None:
        """Print what was not printed yet."""
        if task.rehearsal is not None:
            self._say(rehearsal_line(task.rehearsal))
        for step in task.steps:
            if step.state in _TOLD_STEPS:
                self._say(step_line(step))
        for words in task.report:
            self._say(f"  = {words}")
        if task.question is not None:
            self._say(question_line(task), key=f"? {task.question.id}")
        if task.state is not TaskStage.RUNNING:
            why = without_numbers(task.words)
            self._say(task_line(task), key=f"{task.state.value}: {why}")

    def _say(self, words: str, key: str = "") -> None:
        if (key or words) not in self._told:
            self._told.add(key or words)
            plain_console.print(words, soft_wrap=True)


def follow(tasks: TaskQueries, number: int) -> TaskStatus:
    """Print the progress of a task until it ends, asking its questions here; return its end."""
    progress, asked = TaskProgress(), set[str]()
    while True:
        task = find_task(tasks, number)
        progress.show(task)
        if task.state in ENDED:
            return task
        if task.question is not None and task.question.id not in asked and sys.stdin.isatty():
            asked.add(task.question.id)
            if choice := input("> ").strip():
                tasks.reply(number, choice, task.question.id)
        time.sleep(_LOOK_PERIOD)


def find_task(tasks: TaskQueries, number: int) -> TaskStatus:
    """Return a task, open or ended; raises TaskError when there is none of that number."""
    from housefly.errors import TaskError

    board = tasks.tasks()
    for task in (*board.tasks, *board.ended, *tasks.task_history(limit=1000)):
        if task.id == number:
            return task
    raise TaskError(f"there is no task {number}", "unknown_task")
