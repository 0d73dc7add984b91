"""What the page is told beside the draft: live tests, written files, refusals."""

from __future__ import annotations

from dataclasses import dataclass

from starlette.responses import JSONResponse

from housefly.errors import ConfigError, HouseflyError, StaleEdits
from housefly.web.http.responses import error_response


@dataclass(frozen=True, slots=True)
class BodyView:
    """A body that the tracking system sees: its name, and where [m]."""

    name: str
    position: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class HeardView:
    """What was heard of a tracking system, or of a drone, in words."""

    words: tuple[str, ...]
    bodies: tuple[BodyView, ...]


@dataclass(frozen=True, slots=True)
class WrittenFile:
    """A file that was written, and what is in it."""

    path: str
    text: str


@dataclass(frozen=True, slots=True)
class WrittenView:
    """The files of the site."""

    files: tuple[WrittenFile, ...]


def draft_refusal(error: HouseflyError) -> JSONResponse:
    """Return why something was not done; with the key that is wrong, if there is one."""
    if isinstance(error, StaleEdits):
        return error_response(409, str(error))
    key = error.key if isinstance(error, ConfigError) else ""
    words = f"{key}: {error.problem}" if isinstance(error, ConfigError) else str(error)
    return JSONResponse({"error": words, "key": key}, status_code=422)
