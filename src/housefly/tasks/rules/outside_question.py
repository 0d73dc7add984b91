"""Questions and requests of programs that prove nothing: checked, and asked of a person first."""

from __future__ import annotations

from dataclasses import replace

from housefly.errors import TaskError
from housefly.tasks.api.json import task_question_from_json
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    RehearseTask,
    RequestTask,
    Sentence,
    ServicesQuestion,
    TaskQuestion,
)
from housefly.tasks.api.values import Confirm, Priority, ReasonCode, RequestSurface

_ALLOWED = (RequestTask, RehearseTask, CancelTask, BoardQuestion, ServicesQuestion, Sentence)
"""What may be asked from outside: nobody says yes to anything there, and nobody sets a mode."""


def outside_question(
    text: str, *, by: str, owner: str, surface: RequestSurface, is_trusted: bool
) -> TaskQuestion:
    """Return what a JSON text asks, in the name of who said it.

    Args:
        text: JSON of a question.
        by: who asks, for people.
        owner: id of who asks.
        surface: where.
        is_trusted: whether what it asks for may fly without a yes.

    Raises:
        WireError: it is no question.
        TaskError: NOT_ALLOWED from outside.
    """
    question = task_question_from_json(text)
    if not isinstance(question, _ALLOWED):
        words = f"{question.ask!r} is not asked over {surface.name}"
        raise TaskError(words, ReasonCode.NOT_ALLOWED.value)
    match question:
        case RequestTask():
            # An alarm would take the drone from whoever flies.
            priority = Priority.PERSON if question.priority is Priority.ALARM else question.priority
            return replace(
                question,
                by=by,
                surface=surface,
                cause=surface.value,
                confirm=_confirm(question.confirm, is_trusted),
                priority=priority,
                owner=owner,
            )
        case Sentence():
            confirm = _confirm(question.confirm, is_trusted)
            told = replace(question, by=by, surface=surface, confirm=confirm)
            return replace(told, may_fly=False, owner=owner)
        case RehearseTask():
            return replace(question, surface=surface)
        case CancelTask():
            return replace(question, by=by, only_of="")
    return question


def _confirm(asked: Confirm, is_trusted: bool) -> Confirm:
    return Confirm.AUTO if is_trusted and asked is Confirm.AUTO else Confirm.ASK
