"""JSON answers that several HTTP surfaces give."""

from __future__ import annotations

from collections.abc import Mapping

from starlette.responses import JSONResponse, Response


def json_response(text: str | bytes) -> Response:
    """Return an answer from JSON text that no browser may keep."""
    headers = {"cache-control": "no-store"}
    return Response(text, media_type="application/json", headers=headers)


def error_response(
    status: int, words: str, headers: Mapping[str, str] | None = None
) -> JSONResponse:
    """Return a refusal with its reason in words."""
    return JSONResponse({"error": words}, status_code=status, headers=headers)
