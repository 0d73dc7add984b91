"""Which drone a browser means: its page names it in the address."""

from __future__ import annotations

from starlette.requests import HTTPConnection


def drone_of_request(request: HTTPConnection) -> str:
    """Return the drone that a browser names in its address, or ""."""
    return request.query_params.get("drone", "")
