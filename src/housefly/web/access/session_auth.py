"""Who may use the console: one-time links, signed sessions, and the key of the room API.

A link ``/?token=...`` works in one browser, also after a restart of the console. It is exchanged
for a signed session cookie that scripts cannot read and other sites cannot send, and for a proof
that only the page knows: browsers send cookies to every port of a host, so another server of this
machine may come by the cookie.
WebSockets must name their own page as Origin.
"""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Callable
from hashlib import sha256

from starlette.requests import HTTPConnection
from starlette.websockets import WebSocket

from housefly.clock import Clock, RealClock
from housefly.web.access.invitations import Invitation, Invitations
from housefly.web.access.roles import Role
from housefly.web.access.session import EndedSessions, Session
from housefly.web.access.users import User, UserBook

PROOF_HEADER = "x-housefly-proof"
SUBPROTOCOL = "housefly"
"""What a browser offers on a WebSocket beside ``proof.…``, because it cannot set headers there."""
_PROOF_PREFIX = "proof."
_COOKIE = "housefly"
_SECURE_PREFIX = "__Host-"
"""Browsers take such a cookie only over TLS and from this host itself."""
_LOGIN, _GUEST = "~", "+"
"""What the grant of a login begins with, and that of an invitation."""
LONGEST_LOGIN = 12 * 3600.0
"""A login is over after this time [s], and so is the visit of who was invited; the session of the
first link lives as long as the run.
"""


class SessionAuth:
    """Takes one-time links and checks the sessions that were made from them or by login.

    Links and sessions are signed, not stored: a console that restarts with the same secret still
    knows its browsers. What a user may do is looked up anew each time.

    Args:
        token: the first one-time link's token; it opens a session of the highest role.
        secret: key of the sessions.
        users: who may log in; None for nobody.
        ended: sessions that are over, and links that were used.
        clock: tells the age of a login, and of a link.

    Attributes:
        on_guest: is told of each invitation that was used.
    """

    def __init__(
        self,
        token: str,
        secret: str,
        users: UserBook | None = None,
        ended: EndedSessions | None = None,
        clock: Clock | None = None,
    ) -> None:
        self.on_guest: Callable[[Invitation], None] = lambda invitation: None
        self._first = token
        self._key = hmac.digest(secret.encode(), b"housefly console session", sha256)
        self._users, self._clock = users, clock or RealClock()
        self._ended = EndedSessions() if ended is None else ended
        self._invitations = Invitations(secret, self._clock, self._ended)

    def invite(self, role: Role) -> Invitation:
        """Return a new one-time link."""
        return self._invitations.new(role)

    def redeem(self, token: str) -> str | None:
        """Exchange a one-time token for a session cookie's value; None for an invalid token."""
        if hmac.compare_digest(self._first.encode(), token.encode()):
            return self._redeem_first()
        invitation = self._invitations.redeemed(token)
        if invitation is None:
            return None
        self.on_guest(invitation)
        return self._new_cookie(f"{_GUEST}{invitation.role.value}:{self._second}")

    def log_in(self, user: User) -> str:
        """Return the cookie's value of a new session of a user whose password was right."""
        return self._new_cookie(f"{_LOGIN}{user.name}:{user.fingerprint}:{self._second}")

    def log_out(self, session: Session) -> None:
        """End a session for good."""
        self._ended.add(session.name)

    def cookie_session(self, connection: HTTPConnection) -> Session | None:
        """Return the session whose cookie the browser sent; enough to show the page."""
        name, grant, signature = _three(connection.cookies.get(cookie_name(connection), ""))
        signed = hmac.compare_digest(signature.encode(), self._sign(f"{name}.{grant}").encode())
        return self._session(name, grant) if name and signed else None

    def session_of(self, connection: HTTPConnection) -> Session | None:
        """Return the session of a request that has its cookie and its proof."""
        session = self.cookie_session(connection)
        name = session.name if session else ""
        proved = hmac.compare_digest(_offered_proof(connection).encode(), self.proof(name).encode())
        return session if proved else None

    def has_session(self, connection: HTTPConnection) -> bool:
        """Return whether a request has cookie and proof of a session."""
        return self.session_of(connection) is not None

    def renewed(self, session: Session) -> Session | None:
        """Return a session with what it may do now, or None when it is over."""
        return self._session(session.name, session.grant)

    def proof(self, session: str) -> str:
        """Return what the page of a session, by name, knows beside the cookie."""
        return hmac.new(self._key, b"proof " + session.encode(), sha256).hexdigest()

    def is_own_page(self, connection: HTTPConnection) -> bool:
        """Return whether the request comes from a page of this server, with a session."""
        return same_origin(connection) and self.has_session(connection)

    async def admit(self, websocket: WebSocket) -> Session | None:
        """Return the session of a WebSocket; close one that another site or a stranger opens."""
        session = self.session_of(websocket)
        if session is not None and same_origin(websocket):
            return session
        await websocket.close(1008, "this page may not open the console")
        return None

    @property
    def _second(self) -> int:
        return int(self._clock.now())

    def _redeem_first(self) -> str | None:
        used = sha256(self._first.encode()).hexdigest()[:32]
        if used in self._ended:
            return None
        self._ended.add(used)
        return self._new_cookie(Role.ADMIN.value)

    def _new_cookie(self, grant: str) -> str:
        named = f"{secrets.token_urlsafe(24)}.{grant}"
        return f"{named}.{self._sign(named)}"

    def _session(self, name: str, grant: str) -> Session | None:
        if name in self._ended:
            return None
        if grant.startswith(_GUEST):
            return self._guest(name, grant)
        if not grant.startswith(_LOGIN):
            return Session(name, grant, Role(grant))
        user_name, fingerprint, begun = grant.removeprefix(_LOGIN).split(":")
        user = self._users.find(user_name) if self._users else None
        if user is None or user.fingerprint != fingerprint:
            return None
        if self._is_too_old(begun):
            return None
        return Session(name, grant, user.role, user.name)

    def _guest(self, name: str, grant: str) -> Session | None:
        role, begun = grant.removeprefix(_GUEST).split(":")
        return None if self._is_too_old(begun) else Session(name, grant, Role(role))

    def _is_too_old(self, begun: str) -> bool:
        return self._clock.now() - int(begun) > LONGEST_LOGIN

    def _sign(self, text: str) -> str:
        return hmac.new(self._key, text.encode(), sha256).hexdigest()


def _three(cookie: str) -> tuple[str, str, str]:
    """Return the parts of a cookie: name, grant, signature; empty ones when it is none."""
    parts = cookie.split(".")
    return (parts[0], parts[1], parts[2]) if len(parts) == 3 else ("", "", "")


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
    prefix = _SECURE_PREFIX if is_encrypted(connection) else ""
    return f"{prefix}{_COOKIE}_{connection.url.port or 'default'}"


def is_encrypted(connection: HTTPConnection) -> bool:
    """Return whether a request came over TLS."""
    return connection.url.scheme in ("https", "wss")


def same_origin(connection: HTTPConnection) -> bool:
    """Return whether the Origin header names this server; a missing header does not."""
    scheme = "https" if is_encrypted(connection) else "http"
    return connection.headers.get("origin") == f"{scheme}://{connection.headers.get('host')}"
