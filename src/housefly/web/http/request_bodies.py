"""JSON bodies of requests: bounded before they are read, read strictly."""

from __future__ import annotations

from typing import Any

from pydantic_core import from_json
from starlette.requests import Request


async def bounded_body(request: Request, limit: int) -> bytes | None:
    """Return the body, or None when it is larger than the limit [bytes]."""
    read = b""
    async for part in request.stream():
        read += part
        if len(read) > limit:
            return None
    return read


def json_object(body: bytes) -> dict[str, Any]:
    """Return the object in a body; an empty body is an empty object.

    Raises:
        ValueError: it is none; infinite numbers, and those that are none, are refused too.
    """
    try:
        tree = from_json(body, allow_inf_nan=False) if body.strip() else {}
    except (ValueError, RecursionError) as error:
        raise ValueError("the body is not JSON") from error
    if not isinstance(tree, dict):
        raise ValueError("the body is a JSON object")
    return tree
