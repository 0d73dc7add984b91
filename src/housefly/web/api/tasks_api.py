"""The tasks over HTTP, below ``/api/v1``: every path is one question of ``tasks.api``.

Who asks needs the console's session, or the key of this run; a change by a browser must come from
our own page. The server says who asked and where, never the body. Whoever may not fly may ask for a
flight: it waits until somebody who may says yes.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from pydantic import ValidationError
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from housefly.bus.bus import Bus
from housefly.bus.topics import TASKS_QUERY
from housefly.clock import Clock
from housefly.config.pydantic_words import words_of
from housefly.config.validation import dotted
from housefly.errors import HouseflyError
from housefly.tasks.api.endpoints import (
    FILLED_IN,
    SILENT_SERVICES,
    TASK_ENDPOINTS,
    TaskEndpoint,
)
from housefly.tasks.api.json import task_question_to_json
from housefly.tasks.api.questions import (
    CancelTask,
    PauseTask,
    Sentence,
    TaskQuestion,
    Webhook,
)
from housefly.tasks.api.values import ReasonCode, RequestSurface
from housefly.tasks.intents.stop_words import says_stop
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.bearer import bears
from housefly.web.access.refused_changes import mark_as_written
from housefly.web.access.roles import Role, role_for_path, role_objection
from housefly.web.access.session_auth import SessionAuth
from housefly.web.api.question_reader import QuestionReader, question_reader
from housefly.web.api.task_asker import TaskAsker, filled_in, program_asking
from housefly.web.api.task_limits import TaskLimits
from housefly.web.api.tasks_endpoints import status_of_reason
from housefly.web.http.request_bodies import bounded_body, json_object
from housefly.web.http.responses import json_response

MAX_TASK_BODY = 16 * 1024
"""Largest request [bytes]."""
ANSWER_TIMEOUT = 10.0
"""How long the tasks may take to answer [s]; a rehearsal takes one or two."""
_WHO_MAY_ASK = "ask with the session of the console, or with the key of this run as a bearer token"
_WHO_MAY_RING = "a webhook needs its own key as a bearer token"
_SAFER = (CancelTask, PauseTask)
"""They never wait behind anything that takes long, nor does STOP in words."""


class TasksApi:
    """Passes questions on to the tasks.

    Args:
        bus: where the tasks are.
        auth: the console's sessions.
        clock: the server's clock.
        key: the bearer token of programs; "" lets none in.
        hook_key: the bearer token of webhooks; "" lets none in.
        name_of: the name that others see for a session's owner.
        audit: where every change is written down.
    """

    def __init__(
        self,
        bus: Bus,
        auth: SessionAuth,
        clock: Clock,
        *,
        key: str = "",
        hook_key: str = "",
        name_of: Callable[[str], str] = lambda owner: "a browser",
        audit: AuditLog | None = None,
    ) -> None:
        self._bus, self._auth, self._key, self._hook_key = bus, auth, key, hook_key
        self._name_of, self._audit, self._limits = name_of, audit, TaskLimits(clock)
        self._threads = ThreadPoolExecutor(4, "tasks")
        self._safer_threads = ThreadPoolExecutor(2, "tasks-safer")

    def routes(self) -> list[Route]:
        """Return the routes, relative to ``API_PREFIX``."""
        return [Route(one.path, self._handler(one), methods=[one.method]) for one in TASK_ENDPOINTS]

    def close(self) -> None:
        """Shut the threads down without waiting for answers."""
        for threads in (self._threads, self._safer_threads):
            threads.shutdown(wait=False, cancel_futures=True)

    def _handler(self, endpoint: TaskEndpoint) -> Callable[[Request], Any]:
        reader = question_reader(endpoint)

        async def answer(request: Request) -> Response:
            if not self._may_enter(request, endpoint):
                return self._who_are_you(request, endpoint)
            body = await bounded_body(request, MAX_TASK_BODY)
            if body is None:
                return task_refusal(413, f"that is too much; allowed: up to {MAX_TASK_BODY} bytes")
            try:
                given = json_object(body) if endpoint.method == "POST" else _query(request)
                asker = self._asker(request, endpoint, given)
                if asker is None:  # the session ended before the body came
                    return self._who_are_you(request, endpoint)
                if objection := _objection(request, endpoint, asker):
                    return task_refusal(403, objection, ReasonCode.NOT_ALLOWED)
                question = filled_in(_question(reader, request, given), asker)
            except ValidationError as error:
                return task_refusal(422, _first_fault(error))
            except ValueError as error:
                return task_refusal(422, str(error))
            if not (_is_stop(question) or self._limits.spend(asker.counted_as, endpoint.pace)):
                return task_refusal(429, "too much at once: wait a moment", ReasonCode.RATE_LIMIT)
            if endpoint.method == "POST":
                mark_as_written(request)
            return await self._answered(endpoint, question, asker)

        return answer

    async def _answered(
        self, endpoint: TaskEndpoint, question: TaskQuestion, asker: TaskAsker
    ) -> Response:
        answer = await self._asked(question)
        if endpoint.method == "POST" and self._audit is not None:
            became = "" if answer.status_code == 200 else f": refused, {answer.status_code}"
            told = f"tasks: {task_question_to_json(question)}{became}"
            self._audit.record(asker.name, asker.session, told)
        return answer

    async def _asked(self, question: TaskQuestion) -> Response:
        try:
            text = await self._text(question)
        except HouseflyError as error:
            words = f"{SILENT_SERVICES}: {error}"
            return task_refusal(503, words, ReasonCode.NOT_READY)
        if text.startswith('{"error"'):
            tree = json.loads(text)
            return JSONResponse(tree, status_of_reason(str(tree.get("code", ""))))
        return json_response(text)

    async def _text(self, question: TaskQuestion) -> str:
        is_safer = isinstance(question, _SAFER) or _is_stop(question)
        threads = self._safer_threads if is_safer else self._threads
        return await asyncio.get_running_loop().run_in_executor(
            threads, self._bus.ask, TASKS_QUERY, task_question_to_json(question), ANSWER_TIMEOUT
        )

    # --- who asks

    def _may_enter(self, request: Request, endpoint: TaskEndpoint) -> bool:
        if endpoint.question is Webhook:
            return bears(request, self._hook_key)
        if bears(request, self._key):
            return True
        if endpoint.method == "POST":
            return self._auth.is_own_page(request)
        return self._auth.has_session(request)

    def _who_are_you(self, request: Request, endpoint: TaskEndpoint) -> Response:
        if endpoint.question is not Webhook and self._auth.has_session(request):
            return task_refusal(403, "this page may not ask for anything", ReasonCode.NOT_ALLOWED)
        words = _WHO_MAY_RING if endpoint.question is Webhook else _WHO_MAY_ASK
        headers = {"www-authenticate": "Bearer"}
        return task_refusal(401, words, ReasonCode.NOT_ALLOWED, headers)

    def _asker(
        self, request: Request, endpoint: TaskEndpoint, given: dict[str, Any]
    ) -> TaskAsker | None:
        """Return who asks now, or None for nobody that we know."""
        if endpoint.question is Webhook:
            return TaskAsker("a webhook", Role.ASK, RequestSurface.WEBHOOK, "", "webhook")
        if bears(request, self._key):
            return program_asking(given if endpoint.method == "POST" else {})
        session = self._auth.session_of(request)
        if session is None:
            return None
        name = session.user or self._name_of(session.owner)
        surface = RequestSurface.CONSOLE
        return TaskAsker(name, session.role, surface, session.name, session.owner)


def task_refusal(
    status: int,
    words: str,
    code: ReasonCode = ReasonCode.BAD_PARAMETER,
    headers: dict[str, str] | None = None,
) -> JSONResponse:
    """Return a refusal with its reason in words and as a code, as the tasks themselves give it."""
    return JSONResponse({"error": words, "code": code.value}, status, headers)


def _first_fault(error: ValidationError) -> str:
    first = error.errors()[0]
    return f"{dotted(first['loc'])}: {words_of(first)}"


def _objection(request: Request, endpoint: TaskEndpoint, asker: TaskAsker) -> str:
    """Return why a role is not enough, in words, or ""; it may have changed since the headers."""
    if endpoint.question is Webhook:
        return ""
    needed = role_for_path(request.scope["path"], changes=endpoint.method == "POST")
    return role_objection(asker.role, needed or Role.WATCH)


def _is_stop(question: TaskQuestion) -> bool:
    """Return whether somebody says STOP: that is never too much."""
    return isinstance(question, Sentence) and says_stop(question.text)


def _query(request: Request) -> dict[str, Any]:
    """Return the parameters of a query; raises ValueError for one that is given twice."""
    given: dict[str, Any] = {}
    for name, value in request.query_params.multi_items():
        if name in given:
            raise ValueError(f"{name}: given twice")
        given[name] = value
    return given


def _question(reader: QuestionReader, request: Request, given: dict[str, Any]) -> TaskQuestion:
    """Return a request's question; raises ValueError or ValidationError naming the parameter."""
    known = reader.parameters - {*FILLED_IN, *request.path_params}
    if unknown := sorted(set(given) - known):
        there = ", ".join(sorted(known)) or "none"
        raise ValueError(f"{unknown[0]}: no such parameter; there are: {there}")
    question: TaskQuestion = reader.adapter.validate_json(
        json.dumps({**given, **request.path_params})
    )
    return question
