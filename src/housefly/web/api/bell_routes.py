"""The bell of a simulated room over HTTP: ``GET /bell`` tells of it, ``POST /bell`` presses it."""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor

from pydantic import TypeAdapter
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from housefly.web.access.session_auth import SessionAuth
from housefly.web.api.simulated_bell import BellView, SimulatedBell
from housefly.web.http.responses import error_response, json_response

_VIEW: TypeAdapter[BellView] = TypeAdapter(BellView)
_REAL = "this room is real: only a hand rings its bell"
_AT_ONCE = "somebody has just pressed the bell: wait for what comes of it"


class BellRoutes:
    """Answers pages.

    Args:
        bell: of a simulated room; None where the room is real.
        auth: the console's sessions.
    """

    def __init__(self, bell: SimulatedBell | None, auth: SessionAuth) -> None:
        self._bell, self._auth = bell, auth
        self._thread = ThreadPoolExecutor(1, "bell")
        self._rings = False

    def routes(self) -> list[BaseRoute]:
        """Return ``/bell``."""
        return [
            Route("/bell", self._show, methods=["GET"]),
            Route("/bell", self._press, methods=["POST"]),
        ]

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    async def _show(self, request: Request) -> Response:
        if not self._auth.has_session(request):
            return error_response(401, "this browser has no session")
        return _answer(BellView(self._bell is not None))

    async def _press(self, request: Request) -> Response:
        if not self._auth.is_own_page(request):
            return error_response(403, "this page may not ring")
        if self._bell is None:
            return error_response(404, _REAL)
        if self._rings:
            return _answer(BellView(True, False, _AT_ONCE))
        self._rings = True
        try:
            loop = asyncio.get_running_loop()
            return _answer(await loop.run_in_executor(self._thread, self._bell.press))
        finally:
            self._rings = False


def _answer(view: BellView) -> Response:
    return json_response(_VIEW.dump_json(view))
