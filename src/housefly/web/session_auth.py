"""Who may use the console: one-time links, signed sessions, and the key of the room API.

A link ``/?token=...`` works in one browser. It is exchanged for a signed session cookie that
scripts cannot read and other sites cannot send. WebSockets must name their own page as Origin.
"""

from __future__ import annotations

import hmac
import secrets
from hashlib import sha256

from starlette.requests import HTTPConnection
from starlette.websockets import WebSocket

_COOKIE = "housefly"
_MAX_INVITES = 20


class SessionAuth:
    """Holds the open one-time links and checks the sessions that were made from them.

    Sessions are signed, not stored: a console that restarts with the same secret still knows its
    browsers.

    Args:
        token: the first one-time link's token.
        secret: key of the sessions.
    """

    def __init__(self, token: str, secret: str) -> None:
        self._open: list[str] = [token]
        self._key = hmac.digest(secret.encode(), b"housefly console session", sha256)

    def invite(self) -> str:
        """Return a new one-time token; too many open ones expire the oldest."""
        token = secrets.token_urlsafe(24)
        self._open = [*self._open[1 - _MAX_INVITES :], token]
        return token

    def redeem(self, token: str) -> str | None:
        """Exchange a one-time token for a session cookie's value; None for an invalid token."""
        for known in self._open:
            if hmac.compare_digest(known.encode(), token.encode()):
                self._open.remove(known)
                name = secrets.token_urlsafe(24)
                return f"{name}.{self._sign(name)}"
        return None

    def has_session(self, connection: HTTPConnection) -> bool:
        """Return whether the browser sent a cookie that we signed."""
        name, _, signature = connection.cookies.get(cookie_name(connection), "").partition(".")
        return bool(name) and hmac.compare_digest(signature.encode(), self._sign(name).encode())

    def is_own_page(self, connection: HTTPConnection) -> bool:
        """Return whether the request comes from a page of this server, with a session."""
        return same_origin(connection) and self.has_session(connection)

    async def admit(self, websocket: WebSocket) -> bool:
        """Close a WebSocket that another site or a stranger opens; return whether it may go on."""
        if self.is_own_page(websocket):
            return True
        await websocket.close(1008, "this page may not open the console")
        return False

    def _sign(self, name: str) -> str:
        return hmac.new(self._key, name.encode(), sha256).hexdigest()


def api_key(secret: str) -> str:
    """Return the bearer token of the room API in a run with this secret."""
    return hmac.new(secret.encode(), b"housefly room api", sha256).hexdigest()


def cookie_name(connection: HTTPConnection) -> str:
    """Return our cookie's name; it holds the port, which browsers do not tell cookies apart by."""
    return f"{_COOKIE}_{connection.url.port or 'default'}"


def same_origin(connection: HTTPConnection) -> bool:
    """Return whether the Origin header names this server; a missing header does not."""
    scheme = "https" if connection.url.scheme in ("https", "wss") else "http"
    return connection.headers.get("origin") == f"{scheme}://{connection.headers.get('host')}"
