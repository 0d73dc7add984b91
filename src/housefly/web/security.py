"""Who may come in: one-time links, sessions, and the checks on every request against pages of other
sites.

A link ``/?token=...`` is good for one browser; it is exchanged for a signed session cookie that
scripts cannot read and other sites cannot send. Host names are allow-listed (DNS rebinding),
WebSockets must name their own page as Origin.
"""

from __future__ import annotations

import hmac
import ipaddress
import secrets
from hashlib import sha256

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import HTTPConnection
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocketClose

from housefly.errors import ConfigError

COOKIE = "housefly"
LOOPBACK_NAMES = frozenset({"127.0.0.1", "localhost", "::1"})
INVITES_MAX = 20

HEADERS = {
    "content-security-policy": (
        "default-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'"
    ),
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), microphone=(), geolocation=()",
}


def check_bind(host: str, *, insecure: bool) -> None:
    """Refuse to listen where other machines can reach us without encryption, unless asked to.

    Raises:
        ConfigError: naming the key and the way out.
    """
    try:
        is_loopback = host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        is_loopback = False
    if not is_loopback and not insecure:
        raise ConfigError(
            "web.host",
            f"is {host!r}: other machines could reach the console over an unencrypted link;"
            " allowed: a loopback address such as 127.0.0.1 (use an SSH tunnel from elsewhere), or"
            " the option --insecure if you trust everyone on that network",
        )


class Doorkeeper:
    """Knows the links that are still good and the sessions that were made from them.

    Sessions are signed, not stored: a console that is started again with the same secret knows its
        browsers.

    Args:
        token: the first one-time link's token.
        secret: key of the sessions.
    """

    def __init__(self, token: str, secret: str) -> None:
        self._open: list[str] = [token]
        self._key = hmac.digest(secret.encode(), b"housefly console session", sha256)

    def invite(self) -> str:
        """Return a new one-time token; the oldest unused one dies when there are too many."""
        token = secrets.token_urlsafe(24)
        self._open = [*self._open[1 - INVITES_MAX :], token]
        return token

    def redeem(self, token: str) -> str | None:
        """Use up a token and return the value of a new session's cookie, or None when the token is
        not good (any more).
        """
        for known in self._open:
            if hmac.compare_digest(known.encode(), token.encode()):
                self._open.remove(known)
                name = secrets.token_urlsafe(24)
                return f"{name}.{self._sign(name)}"
        return None

    def knows(self, connection: HTTPConnection) -> bool:
        """Tell whether a request carries the cookie of one of our sessions."""
        name, _, signature = connection.cookies.get(cookie_name(connection), "").partition(".")
        return bool(name) and hmac.compare_digest(signature.encode(), self._sign(name).encode())

    def _sign(self, name: str) -> str:
        return hmac.new(self._key, name.encode(), sha256).hexdigest()


def api_key(secret: str) -> str:
    """Return the key that programs ask the room's API with, in a run with this secret."""
    return hmac.new(secret.encode(), b"housefly room api", sha256).hexdigest()


def cookie_name(connection: HTTPConnection) -> str:
    """Return the name of our cookie; browsers do not keep the cookies of two ports of one machine
    apart, so it holds the port.
    """
    return f"{COOKIE}_{connection.url.port or 'default'}"


def same_origin(connection: HTTPConnection) -> bool:
    """Tell whether a request comes from a page of this very server; requests without an Origin do
    not.
    """
    scheme = "https" if connection.url.scheme in ("https", "wss") else "http"
    return connection.headers.get("origin") == f"{scheme}://{connection.headers.get('host')}"


class Guard:
    """Middleware: turns away foreign Host names and puts the protective headers on every answer."""

    def __init__(self, app: ASGIApp, hosts: frozenset[str]) -> None:
        self._app, self._hosts = app, hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or turn it away."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
        elif _host_name(Headers(scope=scope).get("host", "")) not in self._hosts:
            await self._turn_away(scope, receive, send)
        else:
            await self._app(scope, receive, _with_headers(send))

    async def _turn_away(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "websocket":
            await WebSocketClose(code=1008, reason="unknown host name")(scope, receive, send)
            return
        text = f"This console answers to {', '.join(sorted(self._hosts))} only.\n"
        await PlainTextResponse(text, status_code=421)(scope, receive, _with_headers(send))


def _host_name(host: str) -> str:
    if host.startswith("["):
        return host[1:].partition("]")[0].lower()
    return host.partition(":")[0].lower()


def _with_headers(send: Send) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            MutableHeaders(scope=message).update(HEADERS)
        await send(message)

    return sending
