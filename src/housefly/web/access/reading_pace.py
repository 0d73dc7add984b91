"""Middleware: one session asks only so often, so that others and STOP never wait behind it."""

from __future__ import annotations

from starlette.requests import HTTPConnection
from starlette.types import ASGIApp, Receive, Scope, Send

from housefly.clock import Clock
from housefly.hub.api.endpoints import API_PREFIX
from housefly.web.access.session_auth import SessionAuth
from housefly.web.http.rate_limit import CommandLimiter
from housefly.web.http.responses import error_response

_RATE, _BURST = 50.0, 200.0
"""Questions a second of one session, and at once after a pause."""
_MAX_KNOWN = 1000
_COUNTED = (f"{API_PREFIX}/", "/coverage", "/edits", "/flights")
_READING = frozenset({"GET", "HEAD"})
_WORDS = "too much at once: wait a moment"


class ReadingPace:
    """Refuses what is too much; changes have limits of their own, and STOP has none.

    Programs with the key of the run are not counted: they are of this user.
    """

    def __init__(self, app: ASGIApp, auth: SessionAuth, clock: Clock) -> None:
        self._app, self._auth, self._clock = app, auth, clock
        self._paces: dict[str, CommandLimiter] = {}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if self._is_too_much(scope):
            await error_response(429, _WORDS, {"retry-after": "1"})(scope, receive, send)
        else:
            await self._app(scope, receive, send)

    def _is_too_much(self, scope: Scope) -> bool:
        if scope["type"] != "http" or scope["method"] not in _READING:
            return False
        if not scope["path"].startswith(_COUNTED):
            return False
        session = self._auth.session_of(HTTPConnection(scope))
        return session is not None and not self._pace_of(session.owner).spend(self._clock.now())

    def _pace_of(self, owner: str) -> CommandLimiter:
        if owner not in self._paces and len(self._paces) >= _MAX_KNOWN:
            del self._paces[next(iter(self._paces))]
        fresh = CommandLimiter(_BURST, self._clock.now(), 0, _RATE, _BURST)
        return self._paces.setdefault(owner, fresh)
