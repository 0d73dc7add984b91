"""Bearer tokens of requests."""

from __future__ import annotations

import hmac

from starlette.requests import HTTPConnection


def bears(connection: HTTPConnection, key: str) -> bool:
    """Return whether a request carries a key as its bearer token; an empty key opens nothing."""
    scheme, _, offered = connection.headers.get("authorization", "").partition(" ")
    if scheme.lower() != "bearer" or not key:
        return False
    return hmac.compare_digest(offered.encode(), key.encode())
