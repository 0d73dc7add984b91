"""Who may use the console: one-time links, signed sessions, and the key of the room API.

A link ``/?token=...`` works in one browser. It is exchanged for a signed session cookie that
scripts cannot read and other sites cannot send, and for a proof that only the page knows: browsers
send cookies to every port of a host, so another server of this machine may come by the cookie.
WebSockets must name their own page as Origin.
"""

from __future__ import annotations

import hmac
import secrets
from hashlib import sha256

from starlette.requests import HTTPConnection
from starlette.websockets import WebSocket

PROOF_HEADER = "x-housefly-proof"
SUBPROTOCOL = "housefly"
"""What a browser offers on a WebSocket beside ``proof.…``, because it cannot set headers there."""
_PROOF_PREFIX = "proof."
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

    def cookie_session(self, connection: HTTPConnection) -> str:
        """Return the session whose cookie the browser sent, or ""; enough to show the page."""
        name, _, signature = connection.cookies.get(cookie_name(connection), "").partition(".")
        signed = hmac.compare_digest(signature.encode(), self._sign(name).encode())
        return name if name and signed else ""

    def session_of(self, connection: HTTPConnection) -> str:
        """Return the session of a request that has its cookie and its proof, or ""."""
        name = self.cookie_session(connection)
        proved = hmac.compare_digest(_offered_proof(connection).encode(), self.proof(name).encode())
        return name if name and proved else ""

    def has_session(self, connection: HTTPConnection) -> bool:
        """Return whether a request has cookie and proof of a session."""
        return bool(self.session_of(connection))

    def proof(self, session: str) -> str:
        """Return what the page of a session knows beside the cookie."""
        return hmac.new(self._key, b"proof " + session.encode(), sha256).hexdigest()

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


def _offered_proof(connection: HTTPConnection) -> str:
    """Return the proof in a header, a subprotocol, or the address of an element such as <img>."""
    if found := connection.headers.get(PROOF_HEADER):
        return found
    for offered in connection.headers.get("sec-websocket-protocol", "").split(","):
        if offered.strip().startswith(_PROOF_PREFIX):
            return offered.strip().removeprefix(_PROOF_PREFIX)
    return connection.query_params.get("proof", "")


def chosen_subprotocol(connection: HTTPConnection) -> str | None:
    """Return the subprotocol that a WebSocket is accepted with, of those that it offers."""
    offered = connection.headers.get("sec-websocket-protocol", "").split(",")
    return SUBPROTOCOL if SUBPROTOCOL in {one.strip() for one in offered} else None


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
