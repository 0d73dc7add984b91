"""Middleware: whoever is in does over HTTP only what the role allows, whatever the route does."""

from __future__ import annotations

from starlette.requests import HTTPConnection
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocketClose

from housefly.web.access.roles import role_for_path, role_objection
from housefly.web.access.session_auth import SessionAuth
from housefly.web.http.responses import error_response

_READING = frozenset({"GET", "HEAD"})


class RoleGuard:
    """Refuses what a session's role is not enough for; a route refuses whoever has no session."""

    def __init__(self, app: ASGIApp, auth: SessionAuth) -> None:
        self._app, self._auth = app, auth

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or reject it."""
        if scope["type"] == "lifespan" or not (objection := self._objection(scope)):
            await self._app(scope, receive, send)
        elif scope["type"] == "websocket":
            await WebSocketClose(code=1008, reason=objection)(scope, receive, send)
        else:
            await error_response(403, objection)(scope, receive, send)

    def _objection(self, scope: Scope) -> str:
        changes = scope["type"] == "http" and scope["method"] not in _READING
        needed = role_for_path(scope["path"], changes=changes)
        session = self._auth.session_of(HTTPConnection(scope)) if needed else None
        if needed is None or session is None:
            return ""
        return role_objection(session.role, needed)
