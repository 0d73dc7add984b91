"""Places and zones over HTTP: ``GET /edits``, ``POST /edits`` and ``POST /edits/undo``.

Only pages of this server with a session may change them, and of those the one that has control.
Whoever saves names the version
that the change is based on: 409 when somebody saved in between, 422 in words when the room would
    not be flyable.
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
from housefly.web.edit_desk import EditDesk, EditsView
from housefly.web.security import Doorkeeper, same_origin

BODY_MAX = 64 * 1024
"""Largest request [bytes]."""
KEYS = {"based_on", "tab", "edits"}

_VIEW: TypeAdapter[EditsView] = TypeAdapter(EditsView)


class Seat(Protocol):
    """Who sits before a tab."""

    def name_at(self, tab: str) -> str:
        """Return the name that others see."""

    def objection_at(self, tab: str) -> str:
        """Return why this tab may not change anything now, or ""."""

    def told(self, words: str) -> None:
        """Put a line into everybody's log."""


class _Wish(NamedTuple):
    based_on: int
    tab: str
    edits: Any


class EditsApi:
    """Serves an edit desk.

    Args:
        desk: where edits are checked and kept; None when nobody brought one.
        doorkeeper: knows the console's sessions.
        seat: knows who has control.
    """

    def __init__(self, desk: EditDesk | None, doorkeeper: Doorkeeper, seat: Seat) -> None:
        self._desk, self._doorkeeper, self._seat = desk, doorkeeper, seat
        self._thread = ThreadPoolExecutor(1, "edits")

    def routes(self) -> list[BaseRoute]:
        """Return the routes."""
        return [
            Route("/edits", self._show, methods=["GET"]),
            Route("/edits", self._save, methods=["POST"]),
            Route("/edits/undo", self._undo, methods=["POST"]),
        ]

    def close(self) -> None:
        """Let go of the thread without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    async def _show(self, request: Request) -> Response:
        if not self._doorkeeper.knows(request):
            return _refused(401, "this browser has no session")
        return await self._answer(lambda desk: desk.view())

    async def _save(self, request: Request) -> Response:
        return await self._changed(
            request, lambda desk, wish, by: desk.save(wish.edits, wish.based_on, by), "saved"
        )

    async def _undo(self, request: Request) -> Response:
        return await self._changed(
            request, lambda desk, wish, by: desk.undo(wish.based_on, by), "undid a change of"
        )

    async def _changed(
        self, request: Request, work: Callable[[EditDesk, _Wish, str], EditsView], did: str
    ) -> Response:
        if not (same_origin(request) and self._doorkeeper.knows(request)):
            return _refused(403, "this page may not change the room")
        body = await _body(request)
        if body is None:
            return _refused(413, f"that is too much; allowed: up to {BODY_MAX} bytes")
        try:
            wish = _wish(body)
        except ValueError as error:
            return _refused(422, str(error))
        if objection := self._seat.objection_at(wish.tab):
            return _refused(403, objection)
        by = self._seat.name_at(wish.tab)
        answer = await self._answer(lambda desk: work(desk, wish, by))
        if answer.status_code == 200:
            self._seat.told(f"{by} {did} places and zones")
        return answer

    async def _answer(self, work: Callable[[EditDesk], EditsView]) -> Response:
        if self._desk is None or self._desk.closed:
            return _refused(
                404, self._desk.closed if self._desk else "places and zones cannot be edited here"
            )
        try:
            view = await asyncio.get_running_loop().run_in_executor(
                self._thread, partial(work, self._desk)
            )
        except StaleEdits as error:
            return _refused(409, str(error))
        except EditsError as error:
            return JSONResponse({"error": str(error), "item": error.item}, status_code=422)
        except HouseflyError as error:
            return _refused(503, str(error))
        return Response(
            _VIEW.dump_json(view),
            media_type="application/json",
            headers={"cache-control": "no-store"},
        )


async def _body(request: Request) -> bytes | None:
    """Return the body, or None when it is too large."""
    read = b""
    async for part in request.stream():
        read += part
        if len(read) > BODY_MAX:
            return None
    return read


def _wish(body: bytes) -> _Wish:
    """Return what a body asks for; raises ValueError in words."""
    try:
        tree = json.loads(body)
    except (ValueError, RecursionError) as error:
        raise ValueError("the body is not JSON") from error
    if not isinstance(tree, dict) or not set(tree) <= KEYS:
        raise ValueError(f"the body is an object with {', '.join(sorted(KEYS))}")
    based_on, tab = tree.get("based_on"), tree.get("tab")
    if not isinstance(based_on, int) or isinstance(based_on, bool) or not 0 <= based_on <= 10**9:
        raise ValueError(
            "based_on: the number of the version that the change is based on, 0 or more"
        )
    if not isinstance(tab, str) or len(tab) > 64:
        raise ValueError("tab: which tab of the console asks, as text")
    return _Wish(based_on, tab, tree.get("edits", {}))


def _refused(status: int, words: str) -> Response:
    return JSONResponse({"error": words}, status_code=status)
