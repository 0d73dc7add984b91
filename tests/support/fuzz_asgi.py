"""Requests to our applications as they stand on the wire, without the wire."""

from __future__ import annotations

import asyncio
from typing import Any
from urllib.parse import unquote

from fuzz_target import split

from housefly.web.access.session_auth import PROOF_HEADER, SUBPROTOCOL, SessionAuth

TOKEN, SECRET, HOST = "a-token-for-tests-only", "a-secret-for-tests-only", "127.0.0.1:8080"

Headers = list[tuple[bytes, bytes]]


def session() -> Headers:
    """Return what a page of a fresh session sends."""
    auth = SessionAuth(TOKEN, SECRET)
    cookie = auth.redeem(TOKEN) or ""
    headers = {
        "host": HOST, "origin": f"http://{HOST}", "cookie": f"housefly_8080={cookie}",
        PROOF_HEADER: auth.proof(cookie.partition(".")[0]), "sec-websocket-protocol": SUBPROTOCOL,
    }  # fmt: skip
    return [(key.encode(), value.encode()) for key, value in headers.items()]


def scope_of(kind: str, target: bytes, headers: Headers) -> dict[str, Any]:
    """Return the scope of a request or of a WebSocket."""
    path, query = split(target, b"?")
    return {
        "type": kind, "asgi": {"version": "3.0"}, "http_version": "1.1", "root_path": "",
        "scheme": "http" if kind == "http" else "ws", "server": ("127.0.0.1", 8080),
        "client": ("127.0.0.1", 5), "path": unquote(path.decode("latin-1")), "raw_path": path,
        "query_string": query, "headers": headers, "subprotocols": [SUBPROTOCOL], "state": {},
    }  # fmt: skip


def http_status(app: Any, loop: asyncio.AbstractEventLoop, data: bytes) -> int:
    """Return how a request is answered; what its head leaves out a page of ours would say."""
    head, body = split(data, b"\n\n")
    first, *lines = head.split(b"\n")
    method, target = split(first, b" ")
    told = [tuple(part.strip() for part in split(line, b":")) for line in lines if b":" in line]
    names = {key.lower() for key, _ in told}
    headers = [(key.lower(), value) for key, value in told]
    headers += [pair for pair in session() if pair[0] not in names]
    scope = scope_of("http", target, headers)
    scope["method"] = method.decode("latin-1").upper()
    answers: list[dict[str, Any]] = []

    waiting = [{"type": "http.request", "body": body, "more_body": False}]

    async def receive() -> dict[str, Any]:
        if waiting:
            return waiting.pop()
        while not answers:  # whoever asks waits for the beginning of an answer
            await asyncio.sleep(0.001)
        return {"type": "http.disconnect"}

    async def send(message: dict[str, Any]) -> None:
        answers.append(message)

    loop.run_until_complete(asyncio.wait_for(app(scope, receive, send), 60.0))
    return int(answers[0]["status"])
