"""Questions and answers as JSON; a refusal is a JSON object with ``error`` and ``unknown``."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Annotated, Any

from pydantic import Field, TypeAdapter, ValidationError

from housefly.config.pydantic_words import words_of
from housefly.config.validation import dotted
from housefly.errors import HouseflyError, ThingError, WireError
from housefly.hub.api.answers import ANSWER_TYPES, Answer
from housefly.hub.api.questions import Question
from housefly.messages.words import with_trees

_QUESTION: TypeAdapter[Question] = TypeAdapter(Annotated[Question, Field(discriminator="ask")])
_ANSWERS: dict[type[Answer], TypeAdapter[Any]] = {
    kind: TypeAdapter(kind) for kind in set(ANSWER_TYPES.values())
}


def question_to_json(question: Question) -> str:
    """Return a question as JSON; raises WireError for a number that is not finite."""
    try:
        return json.dumps(asdict(question), allow_nan=False)
    except ValueError as error:
        raise WireError(f"not all numbers of the question {question.ask!r} are finite") from error


def question_from_json(text: str) -> Question:
    """Return the question; raises WireError that names the first bad key."""
    try:
        return _QUESTION.validate_json(text)
    except ValidationError as error:
        raise WireError(first_problem(error)) from error


def checked_question(question: Question) -> Question:
    """Return the question, checked; raises WireError that names the first bad value."""
    return question_from_json(question_to_json(question))


def answer_to_json(answer: Answer) -> str:
    """Return an answer as JSON."""
    return json.dumps(asdict(answer, dict_factory=with_trees), allow_nan=False, ensure_ascii=False)


def refusal_to_json(error: HouseflyError) -> str:
    """Return a refusal as JSON; ``unknown`` says that there is no such thing."""
    return json.dumps(
        {"error": str(error), "unknown": isinstance(error, ThingError)}, ensure_ascii=False
    )


def answer_from_json(question: Question, text: str) -> Answer:
    """Return the answer to a question.

    Raises:
        ThingError: there is no such thing.
        WireError: the question was refused, or this is no answer to it.
    """
    tree = _tree(text)
    if "error" in tree:
        raise (ThingError if tree.get("unknown") else WireError)(str(tree["error"]))
    try:
        answer: Answer = _ANSWERS[ANSWER_TYPES[type(question)]].validate_python(tree)
    except ValidationError as error:
        raise WireError(f"not an answer: {first_problem(error)}") from error
    return answer


def first_problem(error: ValidationError) -> str:
    """Return the first problem in words, naming its key."""
    first = error.errors()[0]
    key = dotted(first["loc"][1:] or first["loc"]) or "question"
    return f"{key}: {words_of(first)}"


def _tree(text: str) -> dict[str, Any]:
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise WireError(f"not JSON: {error}") from error
    if not isinstance(tree, dict):
        raise WireError("not a JSON object")
    return tree
