"""Tasks as lines for the terminal."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import TYPE_CHECKING

from housefly.app.room_words import clock_time
from housefly.config.text import without_numbers
from housefly.messages.words import literal
from housefly.tasks.document.open_library import NO_DRONE

if TYPE_CHECKING:
    from housefly.tasks.api.answers import TaskBoard
    from housefly.tasks.api.values import RehearsalReport, TaskStatus, TaskStepStatus

_STEP_MARKS = {
    "waiting": "·",
    "running": ">",
    "done": "+",
    "failed": "x",
    "skipped": "-",
}


def task_line(task: TaskStatus) -> str:
    """Return one task: number, title, how far it is and why, who wanted it."""
    words = f": {task.words}" if task.words not in ("", task.state.value) else ""
    by = f"  (by {task.asked_by})" if task.asked_by else ""
    return f"{task.id}  {task.title}  {task.state.value}{words}{by}"


def step_line(step: TaskStepStatus) -> str:
    """Return one step and how far it is."""
    return f"  {_STEP_MARKS[step.state.value]} {step.words or step.name}"


def rehearsal_line(report: RehearsalReport) -> str:
    """Return what a rehearsal found."""
    if not report.may_fly:
        return f"rehearsed: {report.words} ({report.code.value})"
    figures = (
        ("{:.0f} s", report.duration),
        ("{:.0f} % of the battery", None if report.charge is None else 100.0 * report.charge),
        ("at least {:.2f} m from anything", report.clearance),
        ("first look after {:.0f} s", report.first_look),
    )
    found = ", ".join(form.format(value) for form, value in figures if value is not None)
    return f"rehearsed in {report.took:.1f} s: {found or report.words}"


def question_line(task: TaskStatus) -> str:
    """Return what waits for a person."""
    question = task.question
    if question is None:
        return ""
    wait = ""
    if question.until is not None:
        left = max(0.0, question.until - time.time())
        wait = f"; {question.otherwise} in {left:.0f} s"
    return f"? {question.words} ({' / '.join(question.choices)}{wait})"


def history_line(task: TaskStatus, now: float) -> str:
    """Return an ended task: when, what, how it ended, given the time now [Unix time, s]."""
    cause = f" because of {task.cause}" if task.cause else ""
    return f"{clock_time(task.asked_at, now)}  {task_line(task)}{cause}"


def board_lines(board: TaskBoard) -> list[str]:
    """Return everything that a board shows."""
    lines = [f"{board.mode.value}; {board.drone}" + ("; the camera records" * board.records)]
    lines += [f"! {words}" for words in board.notices]
    for task in board.tasks:
        lines.append(task_line(task))
        lines += [step_line(step) for step in task.steps]
        lines += [question_line(task)] if task.question else []
    if not board.tasks:
        wish = "where is the cup" if board.drone == NO_DRONE else "look at the refrigerator"
        lines.append(f'nothing to do: `housefly ask "{wish}"`')
    if board.ended:
        lines += ["", "ended:", *(history_line(task, board.at) for task in board.ended[:5])]
    return lines


def shows_the_same(one: TaskBoard, other: TaskBoard) -> bool:
    """Return whether two boards differ in nothing but time and the numbers in their reasons."""
    return _steady(one) == _steady(other)


def _steady(board: TaskBoard) -> TaskBoard:
    tasks = tuple(replace(task, words=literal(without_numbers(task.words))) for task in board.tasks)
    notices = tuple(without_numbers(words) for words in board.notices)
    return replace(
        board, at=0.0, drone=literal(without_numbers(board.drone)), tasks=tasks, notices=notices
    )
