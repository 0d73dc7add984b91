"""Questions to the tasks and answers as JSON; a refusal is an object with an error and a code."""

from __future__ import annotations

import json
from typing import Annotated, Any

from pydantic import Field, TypeAdapter, ValidationError

from housefly.errors import TaskError, WireError
from housefly.hub.api.json import first_problem
from housefly.tasks.api.answers import TASK_ANSWER_TYPES, TaskAnswer
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.api.values import ReasonCode

_QUESTION: TypeAdapter[TaskQuestion] = TypeAdapter(
    Annotated[TaskQuestion, Field(discriminator="ask")]
)
_ANSWERS: dict[type[TaskAnswer], TypeAdapter[Any]] = {
    kind: TypeAdapter(kind) for kind in set(TASK_ANSWER_TYPES.values())
}


def task_question_to_json(question: TaskQuestion) -> str:
    """Return a question as JSON."""
    return _QUESTION.dump_json(question).decode()


def task_question_from_json(text: str) -> TaskQuestion:
    """Return the question; raises WireError that names the first bad key."""
    try:
        return _QUESTION.validate_json(text)
    except ValidationError as error:
        raise WireError(first_problem(error)) from error


def task_answer_to_json(answer: TaskAnswer) -> str:
    """Return an answer as JSON."""
    return str(_ANSWERS[type(answer)].dump_json(answer).decode())


def task_refusal_to_json(error: Exception) -> str:
    """Return a refusal as JSON, with its reason code."""
    code = error.code if isinstance(error, TaskError) else ReasonCode.BAD_PARAMETER.value
    return json.dumps({"error": str(error), "code": code}, ensure_ascii=False)


def task_answer_from_json(question: TaskQuestion, text: str) -> Any:
    """Return the answer to a question.

    Raises:
        TaskError: it was refused; its code says why.
        WireError: this is no answer to it.
    """
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise WireError(f"not JSON: {error}") from error
    if isinstance(tree, dict) and "error" in tree:
        raise TaskError(str(tree["error"]), str(tree.get("code", "")))
    try:
        # Read as JSON: enums and tuples come as their JSON forms.
        return _ANSWERS[TASK_ANSWER_TYPES[type(question)]].validate_json(text)
    except ValidationError as error:
        raise WireError(f"not an answer: {first_problem(error)}") from error
