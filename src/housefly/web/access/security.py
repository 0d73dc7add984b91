"""Checks against pages of other sites on every request.

Host names are allow-listed against DNS rebinding, and every answer carries protective headers.
"""

from __future__ import annotations

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocketClose

LOOPBACK_NAMES = frozenset({"127.0.0.1", "localhost", "::1"})

_PROTECTIVE_HEADERS = {
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


class HostGuard:
    """Middleware: rejects foreign Host names and adds the protective headers to every answer."""

    def __init__(self, app: ASGIApp, hosts: frozenset[str]) -> None:
        self._app, self._hosts = app, hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or reject it."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
        elif not _is_readable(scope):
            await self._reject(scope, receive, send)
        elif _is_asked_by_another_site(scope):
            await self._refuse(scope, receive, send)
        elif _host_name(Headers(scope=scope).get("host", "")) not in self._hosts:
            await self._reject(scope, receive, send)
        else:
            await self._app(scope, receive, _with_headers(send))

    async def _refuse(self, scope: Scope, receive: Receive, send: Send) -> None:
        text = "Pages of other sites may not ask this console.\n"
        await PlainTextResponse(text, status_code=403)(scope, receive, _with_headers(send))

    async def _reject(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "websocket":
            await WebSocketClose(code=1008, reason="unknown host name")(scope, receive, send)
            return
        text = f"This console answers to {', '.join(sorted(self._hosts))} only.\n"
        await PlainTextResponse(text, status_code=421)(scope, receive, _with_headers(send))


def _is_asked_by_another_site(scope: Scope) -> bool:
    """Return whether a page of another origin, another port included, asks for more than a page."""
    headers = Headers(scope=scope)
    return (
        scope["type"] == "http"
        and headers.get("sec-fetch-site", "none") in ("cross-site", "same-site")
        and headers.get("sec-fetch-mode") != "navigate"
    )


def _is_readable(scope: Scope) -> bool:
    """Return whether an address can be made of the request: ASCII, with a port that is a number."""
    host = Headers(scope=scope).get("host", "")
    _, _, port = host.rpartition("]")[2].partition(":")
    in_range = not port or (port.isascii() and port.isdigit() and len(port) <= 5)
    return scope["query_string"].isascii() and in_range and int(port or 0) < 65536


def _host_name(host: str) -> str:
    if host.startswith("["):
        return host[1:].partition("]")[0].lower()
    return host.partition(":")[0].lower()


def _with_headers(send: Send) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in _PROTECTIVE_HEADERS.items():
                headers.setdefault(name, value)  # the login page has a form, and says so
        await send(message)

    return sending
