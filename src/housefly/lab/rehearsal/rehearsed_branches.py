"""The ways that a task can take by what people answer: each is rehearsed, with the longest waits.

Nobody answers in the first; in each other one somebody gives another answer to one of the questions
that came up, at the last moment, or at once where the question is given up before. Answers after
which the task does the same are one.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from housefly.lab.lockstep.task_flight import TaskFlight, TaskScript
from housefly.tasks.api.values import ReasonCode, TaskStage, TaskStepState
from housefly.tasks.document.step_forms import CONDITION_FORMS
from housefly.tasks.document.steps import (
    ArgumentValue,
    ConditionKind,
    StepKind,
    TaskCondition,
    TaskStep,
)
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.document.templates import names_in, plain_text
from housefly.tasks.execution.values import AskPerson, CloseQuestion

BRANCHES_MAX = 8
"""A task with more ways by answers than this is not rehearsed to its end."""
_WAITS = frozenset({StepKind.WAIT, StepKind.REPEAT})
_TOLD = frozenset({StepKind.SAY, StepKind.ANNOUNCE, StepKind.REPORT, StepKind.PUBLISH,
                   StepKind.RECORD, StepKind.SNAPSHOT, StepKind.FAIL, StepKind.ASK})  # fmt: skip
"""Steps that do the same whatever the answer in their texts is."""
_EARLY = 0.5
"""An early answer comes after this [s]."""
_TICK = 0.2
"""A question that was open for less than its time by more than this [s] was given up."""


@dataclass(frozen=True, slots=True)
class RehearsedBranch:
    """One way that a task can take, and its flight.

    Attributes:
        flight: what happened.
        words: what was answered, as "if nobody answers ..." or ""; for people.
        waited: longest time that its questions wait [s]; an early answer saves it.
        fails_by_itself: the document says that it ends as failed there.
    """

    flight: TaskFlight
    words: str
    waited: float
    fails_by_itself: bool


def longest(task: BoundTask) -> BoundTask:
    """Return the task in which nothing that is waited for ever comes before its time is over."""
    return replace(task, steps=_longest(task.steps), on_cancel=_longest(task.on_cancel))


def fly_branches(
    task: BoundTask, fly: Callable[[TaskScript], TaskFlight]
) -> Iterator[RehearsedBranch]:
    """Yield each way that a task can take by what people answer, more than BRANCHES_MAX at most.

    Args:
        task: what is rehearsed.
        fly: flies it while people answer by a script.
    """
    compared = _compared(task.steps)
    left: list[dict[str, str]] = [{}]
    for _ in range(BRANCHES_MAX + 1):
        if not left:
            return
        given = left.pop(0)
        replies = {question: choice for question, choice in given.items() if choice}
        decided = dict(given)
        for flight in _late_and_early(replies, fly):
            asked = _asked(flight)
            for question, ask in asked.items():
                if question in decided or question not in compared:
                    continue
                left += [{**decided, question: c} for c in _others(ask, compared[question])]
                decided[question] = ""
            yield RehearsedBranch(
                flight,
                _words(decided, asked),
                sum(time for _, time in _waits(flight)),
                _fails_by_itself(flight, task),
            )


def _late_and_early(
    replies: dict[str, str], fly: Callable[[TaskScript], TaskFlight]
) -> Iterator[TaskFlight]:
    """Yield the flight with the latest answers, and one with early ones when none came so late."""
    flight = fly(TaskScript(replies=replies, silent=True, late=True))
    yield flight
    if any(_is_given_up(flight, question) for question in replies):
        yield fly(TaskScript(replies=replies, silent=True, reply_time=_EARLY))


def _longest(steps: tuple[TaskStep, ...]) -> tuple[TaskStep, ...]:
    return tuple(
        replace(
            step,
            arguments={
                name: value
                for name, value in step.arguments.items()
                if not (step.kind in _WAITS and name == "until")
            },
            blocks={word: _longest(block) for word, block in step.blocks.items()},
        )
        for step in steps
    )


def _compared(steps: tuple[TaskStep, ...]) -> dict[str, set[str] | None]:
    """Return what the reply to each question is compared with; None where each is another way."""
    found: dict[str, set[str] | None] = {}
    for first in steps:
        for step in first.every_step():
            for value in step.arguments.values():
                if isinstance(value, TaskCondition):
                    _add_compared(value, found)
                elif step.kind not in _TOLD:
                    found |= dict.fromkeys(_names_used(value))
    return found


def _names_used(value: ArgumentValue) -> list[str]:
    texts = value if isinstance(value, tuple) else (value,)
    return [name for text in texts if isinstance(text, str) for name in names_in(text)]


def _add_compared(condition: TaskCondition, found: dict[str, set[str] | None]) -> None:
    for part in condition.parts:
        _add_compared(part, found)
    if condition.kind is not ConditionKind.REPLY:
        for value in condition.arguments.values():
            found |= dict.fromkeys(_names_used(value))
        return
    usual = {form.name: str(form.default) for form in CONDITION_FORMS[condition.kind]}
    question = str(condition.arguments.get("to", usual["to"]))
    text = str(condition.arguments["equals"])
    known = found.setdefault(question, set())
    if names_in(text):
        found[question] = None
    elif known is not None:
        known.add(plain_text(text, str))


def _others(ask: AskPerson, compared: set[str] | None) -> list[str]:
    """Return one answer for each way on but the one that silence takes."""

    def way(choice: str) -> str:
        return choice if compared is None or choice in compared else ""

    ways = {way(choice): choice for choice in reversed(ask.choices)}
    ways.pop(way(ask.otherwise), None)
    return list(ways.values())


def _every_ask(flight: TaskFlight) -> list[AskPerson]:
    found = (one.action for one in flight.actions_of(AskPerson))
    return [action for action in found if isinstance(action, AskPerson)]


def _waits(flight: TaskFlight) -> Iterator[tuple[AskPerson, float]]:
    """Yield each question and how long it was open [s]."""
    closes = [(one.at, one.action) for one in flight.actions_of(CloseQuestion)]
    for one in flight.actions_of(AskPerson):
        ask = one.action
        if isinstance(ask, AskPerson):
            ends = (at for at, close in closes if close == CloseQuestion(ask.id) and at >= one.at)
            yield ask, min(next(ends, flight.ended_at) - one.at, ask.timeout or 0.0)


def _is_given_up(flight: TaskFlight, question: str) -> bool:
    return any(
        ask.id == question and time < (ask.timeout or 0.0) - _TICK for ask, time in _waits(flight)
    )


def _asked(flight: TaskFlight) -> dict[str, AskPerson]:
    return {ask.id: ask for ask in reversed(_every_ask(flight))}


def _words(decided: dict[str, str], asked: dict[str, AskPerson]) -> str:
    said = [
        f"'{choice}' is answered to '{asked[question].words}'"
        if choice
        else f"nobody answers '{asked[question].words}'"
        for question, choice in decided.items()
        if question in asked
    ]
    return f"if {' and '.join(said)}" if said else ""


def _fails_by_itself(flight: TaskFlight, task: BoundTask) -> bool:
    if (flight.stage, flight.code) != (TaskStage.FAILED, ReasonCode.STEP_FAILED):
        return False
    steps = (step for first in task.steps for step in first.every_step())
    failed = {status.name for status in flight.steps if status.state is TaskStepState.FAILED}
    texts = (
        str(step.arguments["words"])
        for step in steps
        if step.kind is StepKind.FAIL and (step.name or step.kind.value) in failed
    )
    return any(re.fullmatch(_pattern(text), flight.words) for text in texts)


def _pattern(text: str) -> str:
    """Return what the words of a step match, whatever its names stand for."""
    parts = plain_text(text.replace("\0", ""), lambda name: "\0").split("\0")
    return ".*".join(map(re.escape, parts))
