"""Places and zones over HTTP: ``GET /edits``, ``POST /edits``, ``/edits/undo``, ``/edits/use``.

Only pages of this server with a session may change them, and of those only the one that has
control. A request names the version it is based on: 409 when somebody saved in between, 422 in
words when the room would not be flyable. ``/edits/use`` gives it to the drone at once: 409 while
that does not stand.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any, NamedTuple, Protocol

from pydantic import TypeAdapter
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route

from housefly.errors import EditsError, HouseflyError, StaleEdits
from housefly.messages.words import Words
from housefly.web.access.session_auth import SessionAuth
from housefly.web.api.edit_service import EditService, EditsNotUsed, EditsView
from housefly.web.http.request_bodies import bounded_body
from housefly.web.http.responses import error_response, json_response

MAX_BODY_SIZE = 64 * 1024
"""Largest request [bytes]."""
_BODY_KEYS = {"based_on", "tab", "edits"}

_VIEW: TypeAdapter[EditsView] = TypeAdapter(EditsView)


class _Control(Protocol):
    """What the console knows of a browser tab and of who has control."""

    def name_of_tab(self, owner: str, tab: str) -> str:
        """Return the name that others see."""

    def control_objection(self, owner: str, tab: str) -> str:
        """Return why this tab does not have control, in words, or ""."""

    def announce(self, words: Words) -> None:
        """Put a line into everybody's event log."""


class _EditRequest(NamedTuple):
    based_on: int
    tab: str
    edits: Any


class EditsApi:
    """The routes of an edit service.

    Args:
        service: checks and keeps edits; None where there are none.
        auth: the console's sessions.
        control: who has control.
        objection: says in words why the pilot may not be started again now, or "".
    """

    def __init__(
        self,
        service: EditService | None,
        auth: SessionAuth,
        control: _Control,
        objection: Callable[[], str],
    ) -> None:
        self._service, self._auth, self._control = service, auth, control
        self._objection = objection
        self._thread = ThreadPoolExecutor(1, "edits")

    def routes(self) -> list[BaseRoute]:
        """Return the routes."""
        return [
            Route("/edits", self._show, methods=["GET"]),
            Route("/edits", self._save, methods=["POST"]),
            Route("/edits/undo", self._undo, methods=["POST"]),
            Route("/edits/use", self._use, methods=["POST"]),
        ]

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    async def _show(self, request: Request) -> Response:
        if not self._auth.has_session(request):
            return error_response(401, "this browser has no session")
        return await self._answer(lambda service: service.view())

    async def _save(self, request: Request) -> Response:
        return await self._changed(
            request,
            lambda service, asked, by: service.save(asked.edits, asked.based_on, by),
            lambda by: Words("{who} saved places and zones", who=by),
        )

    async def _undo(self, request: Request) -> Response:
        return await self._changed(
            request,
            lambda service, asked, by: service.undo(asked.based_on, by),
            lambda by: Words("{who} undid a change of places and zones", who=by),
        )

    async def _use(self, request: Request) -> Response:
        return await self._changed(
            request,
            lambda service, asked, by: service.use(asked.based_on),
            _starts_again,
            self._objection,
        )

    async def _changed(
        self,
        request: Request,
        work: Callable[[EditService, _EditRequest, str], EditsView],
        did: Callable[[str], Words],
        also: Callable[[], str] = lambda: "",
    ) -> Response:
        session = self._auth.session_of(request) if self._auth.is_own_page(request) else None
        if session is None:
            return error_response(403, "this page may not change the room")
        body = await bounded_body(request, MAX_BODY_SIZE)
        if body is None:
            return error_response(413, f"that is too much; allowed: up to {MAX_BODY_SIZE} bytes")
        try:
            asked = _parsed(body)
        except ValueError as error:
            return error_response(422, str(error))
        if objection := self._control.control_objection(session.owner, asked.tab):
            return error_response(403, objection)
        if objection := also():
            return error_response(409, objection)
        by = self._control.name_of_tab(session.owner, asked.tab)
        answer = await self._answer(lambda service: work(service, asked, by))
        if answer.status_code == 200:
            self._control.announce(did(by))
        return answer

    async def _answer(self, work: Callable[[EditService], EditsView]) -> Response:
        if self._service is None:
            return error_response(404, "places and zones cannot be edited here")
        if reason := self._service.disabled_reason:
            return error_response(404, reason)
        loop = asyncio.get_running_loop()
        try:
            view = await loop.run_in_executor(self._thread, partial(work, self._service))
        except (StaleEdits, EditsNotUsed) as error:
            return error_response(409, str(error))
        except EditsError as error:
            return JSONResponse({"error": str(error), "item": error.item}, status_code=422)
        except HouseflyError as error:
            return error_response(503, str(error))
        return json_response(_VIEW.dump_json(view))


def _parsed(body: bytes) -> _EditRequest:
    """Return the request in a body; raises ValueError in words."""
    try:
        tree = json.loads(body)
    except (ValueError, RecursionError) as error:
        raise ValueError("the body is not JSON") from error
    if not isinstance(tree, dict) or not set(tree) <= _BODY_KEYS:
        raise ValueError(f"the body is an object with {', '.join(sorted(_BODY_KEYS))}")
    based_on, tab = tree.get("based_on"), tree.get("tab")
    if not isinstance(based_on, int) or isinstance(based_on, bool) or not 0 <= based_on <= 10**9:
        raise ValueError(
            "based_on: the number of the version that the change is based on, 0 or more"
        )
    if not isinstance(tab, str) or len(tab) > 64:
        raise ValueError("tab: which tab of the console asks, as text")
    return _EditRequest(based_on, tab, tree.get("edits", {}))


def _starts_again(by: str) -> Words:
    return Words(
        "{who} starts the pilot again, so that the drone has the newest places and zones", who=by
    )
