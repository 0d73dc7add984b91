"""Bearer tokens of requests."""

from __future__ import annotations

import hmac

from starlette.requests import HTTPConnection


def bears(connection: HTTPConnection, key: str) -> bool:
    """Return whether a request carries a key as its bearer token; an empty key opens nothing."""
    scheme, _, offered = connection.headers.get("authorization", "").partition(" ")
    return scheme.lower() == "bearer" and is_key(offered, key)


def is_key(offered: str, key: str) -> bool:
    """Return whether what is offered is a key; an empty one opens nothing."""
    return bool(key) and hmac.compare_digest(offered.encode(), key.encode())
