"""What reads the parameters of a request into one kind of question."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

from pydantic import TypeAdapter

from housefly.hub.api.endpoints import Endpoint
from housefly.tasks.api.endpoints import TaskEndpoint


class QuestionReader(NamedTuple):
    """Reads one kind of question.

    Attributes:
        adapter: reads and checks the values.
        parameters: the names that a request may give.
    """

    adapter: TypeAdapter[Any]
    parameters: frozenset[str]


@cache
def question_reader(endpoint: Endpoint | TaskEndpoint) -> QuestionReader:
    """Return what reads the question of a path; it is made once for all servers."""
    adapter: TypeAdapter[Any] = TypeAdapter(endpoint.question)
    return QuestionReader(adapter, frozenset(adapter.json_schema()["properties"]) - {"ask"})
