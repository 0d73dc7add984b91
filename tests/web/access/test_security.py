from __future__ import annotations

import pytest

from housefly.web.access.security import HostGuard


@pytest.mark.parametrize("host", ["127.0.0.1", "LOCALHOST:8080", "[::1]:8080", "lab.local:8443"])
async def test_names_of_ours_pass_with_and_without_a_port(host: str) -> None:
    assert await passes(host)


@pytest.mark.parametrize("host", ["", "evil.example", "127.0.0.1.evil.example", "lab.localx", "["])
async def test_other_names_do_not(host: str) -> None:
    assert not await passes(host)


async def passes(host: str) -> bool:
    """Return whether a request for a host name reaches the application."""
    reached = False

    async def app(*_: object) -> None:
        nonlocal reached
        reached = True

    async def send(_: object) -> None:
        pass

    async def receive() -> dict[str, str]:
        return {}

    guard = HostGuard(app, frozenset({"127.0.0.1", "localhost", "::1", "lab.local"}))
    scope = {
        "type": "http",
        "method": "GET",
        "path": "/",
        "query_string": b"",
        "headers": [(b"host", host.encode())],
    }
    await guard(scope, receive, send)  # type: ignore[arg-type]
    return reached
