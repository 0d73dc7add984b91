"""Asks the tasks of a room over HTTP, from this or another machine."""

from __future__ import annotations

import json
from dataclasses import fields
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from typing import Any, NamedTuple
from urllib.parse import quote, urlencode

from housefly.errors import LinkError, TaskError
from housefly.hub.api.endpoints import API_PREFIX
from housefly.hub.client.console_address import console_address_of
from housefly.tasks.api.endpoints import (
    FILLED_IN,
    SAID_BY_PROGRAMS,
    SILENT_SERVICES,
    TASK_ENDPOINTS,
    TaskEndpoint,
)
from housefly.tasks.api.json import task_question_to_json
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.api.values import ReasonCode

_ENDPOINTS = {endpoint.question: endpoint for endpoint in TASK_ENDPOINTS}
_NEVER_SAID = tuple(name for name in FILLED_IN if name not in SAID_BY_PROGRAMS)


class HttpTasks:
    """Opens a connection for each question, so that no request is made twice.

    Args:
        address: of the console, for example http://10.0.0.7:8080.
        key: bearer token of the run.
        timeout: of one question [s].

    Raises:
        LinkError: that is no address.
    """

    def __init__(self, address: str, key: str, timeout: float) -> None:
        self._address = console_address_of(address)
        self._kind = HTTPSConnection if self._address.is_secure else HTTPConnection
        self._key, self._timeout = key, timeout

    def ask(self, question: TaskQuestion) -> str:
        """Return the answer or the refusal as JSON.

        Raises:
            TaskError: it says what only the console may fill in.
            LinkError: nobody answers, does not let us ask, or is not Housefly.
        """
        request = task_request(question)
        return self._answered(request.method, request.path, request.body)

    def _answered(self, method: str, path: str, body: str | None) -> str:
        connection = self._kind(self._address.host, self._address.port, timeout=self._timeout)
        headers = {"Authorization": f"Bearer {self._key}", "Content-Type": "application/json"}
        try:
            connection.request(method, path, body, headers)
            answer = connection.getresponse()
            text = answer.read().decode()
        except (OSError, HTTPException, UnicodeDecodeError) as error:
            raise LinkError(f"the room does not answer: {error}") from error
        finally:
            connection.close()
        return checked_task_answer(answer.status, text)


class HttpTaskRequest(NamedTuple):
    """How a question is asked over HTTP."""

    method: str
    path: str
    body: str | None


def task_request(question: TaskQuestion) -> HttpTaskRequest:
    """Return how a question is asked; raises TaskError for what only the console may fill in."""
    endpoint = _ENDPOINTS[type(question)]
    given = _given(question)
    path = f"{API_PREFIX}{_path(endpoint, given)}"
    if endpoint.method == "POST":
        return HttpTaskRequest("POST", path, json.dumps(given))
    kept = {name: value for name, value in given.items() if value not in (None, "")}
    return HttpTaskRequest("GET", f"{path}?{urlencode(kept)}", None)


def checked_task_answer(status: int, text: str) -> str:
    """Return an answer's JSON, as the tasks themselves give it.

    Raises:
        LinkError: who answers does not let us ask, is not Housefly, or has no tasks.
    """
    if status == 200:
        return text
    refusal = _refusal(status, text)
    if status == 401 or refusal.startswith(SILENT_SERVICES):
        raise LinkError(refusal)
    return text


def _given(question: TaskQuestion) -> dict[str, Any]:
    """Return what is said; raises TaskError for what would be lost on the way."""
    defaults = {one.name: one.default for one in fields(question)}
    for name in _NEVER_SAID:
        if name in defaults and getattr(question, name) != defaults[name]:
            words = f"{name} is filled in by the console, and cannot be said over HTTP"
            raise TaskError(words, ReasonCode.BAD_PARAMETER.value)
    tree: dict[str, Any] = json.loads(task_question_to_json(question))
    return {name: value for name, value in tree.items() if name not in ("ask", *_NEVER_SAID)}


def _path(endpoint: TaskEndpoint, given: dict[str, Any]) -> str:
    """Return the path with its parameter, taken from what is said."""
    head, brace, rest = endpoint.path.partition("{")
    if not brace:
        return endpoint.path
    name, _, tail = rest.partition("}")
    return f"{head}{quote(str(given.pop(name)), safe='')}{tail}"


def _refusal(status: int, text: str) -> str:
    try:
        return str(json.loads(text)["error"])
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise LinkError(f"what answers is not the room: status {status}") from error
