"""Middleware: changes over HTTP that are refused, by whichever route, stand in the audit log."""

from __future__ import annotations

import json
from collections.abc import Callable

from starlette.requests import HTTPConnection, Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from housefly.web.access.refusal_log import RefusalLog
from housefly.web.access.session_auth import SessionAuth

_READING = frozenset({"GET", "HEAD", "OPTIONS"})
_SELF_WRITTEN = frozenset({"/login", "/logout"})
"""Their refusals are written elsewhere, with the name that was tried and the address."""
_PATH_LENGTH = 80
_NOBODY = "somebody without a session"


class RefusedChanges:
    """Writes down who was refused what, and why.

    Args:
        app: answers.
        auth: the console's sessions.
        name_of: the name that others see for a session's owner.
        refusals: where it is written.
    """

    def __init__(
        self,
        app: ASGIApp,
        auth: SessionAuth,
        name_of: Callable[[str], str],
        refusals: RefusalLog,
    ) -> None:
        self._app, self._auth, self._name_of, self._refusals = app, auth, name_of, refusals

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, and look at the answer."""
        if scope["type"] != "http" or scope["method"] in _READING or scope["path"] in _SELF_WRITTEN:
            await self._app(scope, receive, send)
            return
        status = 0

        async def watched(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
            elif status >= 400:
                self._write(scope, status, message.get("body", b""))
                status = 0
            await send(message)

        await self._app(scope, receive, watched)

    def _write(self, scope: Scope, status: int, body: bytes) -> None:
        if scope.get("state", {}).get("is_written_down"):
            return
        session = self._auth.session_of(HTTPConnection(scope))
        who = (session.user or self._name_of(session.owner)) if session else _NOBODY
        what = f"{scope['method']} {scope['path'][:_PATH_LENGTH]} refused, {status}{_reason(body)}"
        self._refusals.refused(who, session.name if session else "", what)


def mark_as_written(request: Request) -> None:
    """Say that the audit log has a request already, whatever becomes of it."""
    request.state.is_written_down = True


def _reason(body: bytes) -> str:
    """Return why, as an answer of ours says it, to follow a status; "" where it does not."""
    try:
        tree = json.loads(body)
    except ValueError:
        return ""
    words = tree.get("error") or tree.get("reason") if isinstance(tree, dict) else None
    return f": {words}" if isinstance(words, str) else ""
