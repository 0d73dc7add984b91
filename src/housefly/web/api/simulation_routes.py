"""The simulated room over HTTP: ``GET /simulation`` tells what can be done, ``POST`` does it.

A request is a ``SimulatedAct`` with the ``tab`` that asks. What may end a flight is for who has
control of the drone, and a real room has none of it.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Protocol

from pydantic import TypeAdapter
from pydantic_core import to_json
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from housefly.bus.simulated_room import SimulatedAct, SimulatedDeed, act_from_json
from housefly.errors import WireError
from housefly.messages.words import Words, joined
from housefly.web.access.session_auth import SessionAuth
from housefly.web.api.simulated_room import SimulatedRoom, SimulationView
from housefly.web.http.request_bodies import bounded_body, json_object
from housefly.web.http.responses import error_response, json_response

MAX_BODY_SIZE = 1024
"""Largest request [bytes]."""
_TAB_MAX = 64
_VIEW: TypeAdapter[SimulationView] = TypeAdapter(SimulationView)
_REAL = "this room is real: nothing is put back, charged or broken from here"


class _Console(Protocol):
    """What the console of a drone knows of a browser tab and of who has control."""

    def name_of_tab(self, owner: str, tab: str) -> str:
        """Return the name that others see."""

    def control_objection(self, owner: str, tab: str) -> Words:
        """Return why this tab does not have control, in words, or UNSAID."""

    def announce(self, words: Words) -> None:
        """Put a line into everybody's event log."""


class SimulationRoutes:
    """Answers pages.

    Args:
        room: the simulated one; None where the room is real.
        auth: the console's sessions.
        console_of: the console of a drone, the first for "", None where there is none.
    """

    def __init__(
        self,
        room: SimulatedRoom | None,
        auth: SessionAuth,
        console_of: Callable[[str], _Console | None],
    ) -> None:
        self._room, self._auth, self._console_of = room, auth, console_of
        self._thread = ThreadPoolExecutor(1, "simulation")

    def routes(self) -> list[BaseRoute]:
        """Return ``/simulation``."""
        return [
            Route("/simulation", self._show, methods=["GET"]),
            Route("/simulation", self._act, methods=["POST"]),
        ]

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    async def _show(self, request: Request) -> Response:
        if not self._auth.has_session(request):
            return error_response(401, "this browser has no session")
        if self._room is None:
            return _answer(SimulationView(False))
        return _answer(await self._asked(self._room.view))

    async def _act(self, request: Request) -> Response:
        session = self._auth.session_of(request) if self._auth.is_own_page(request) else None
        if session is None:
            return error_response(403, "this page may not change the room")
        if self._room is None:
            return error_response(404, _REAL)
        body = await bounded_body(request, MAX_BODY_SIZE)
        if body is None:
            return error_response(413, f"that is too much; allowed: up to {MAX_BODY_SIZE} bytes")
        try:
            tab, act = _parsed(body)
        except (ValueError, WireError) as error:
            return error_response(422, str(error))
        console = self._console_of(act.drone)
        if console is None:
            return error_response(422, f"drone: there is none called {act.drone!r}")
        if objection := console.control_objection(session.owner, tab):
            return error_response(403, objection)
        room = self._room
        view = await self._asked(lambda: room.do(act))
        if view.done and act.deed is not SimulatedDeed.LOOK:
            by = console.name_of_tab(session.owner, tab)
            console.announce(joined(": ", (by, view.words)))
        return _answer(view)

    async def _asked(self, work: Callable[[], SimulationView]) -> SimulationView:
        return await asyncio.get_running_loop().run_in_executor(self._thread, work)


def _answer(view: SimulationView) -> Response:
    return json_response(_VIEW.dump_json(view))


def _parsed(body: bytes) -> tuple[str, SimulatedAct]:
    """Return the tab that asks, and what for; raises ValueError or WireError in words."""
    tree = json_object(body)
    tab = tree.pop("tab", None)
    if not isinstance(tab, str) or len(tab) > _TAB_MAX:
        raise ValueError("tab: which tab of the console asks, as text")
    return tab, act_from_json(to_json(tree))
