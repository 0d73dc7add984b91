"""What the page is told beside the draft: live tests, written files, refusals."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from starlette.responses import JSONResponse

from housefly.config.validation import refusal_words
from housefly.errors import ConfigError, HouseflyError, StaleEdits
from housefly.messages.words import Words, tree


@dataclass(frozen=True, slots=True)
class BodyView:
    """A body that the tracking system sees: its name, and where [m]."""

    name: str
    position: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class HeardView:
    """What was heard of a tracking system, or of a drone."""

    words: tuple[Words, ...]
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


class OpenedState(Enum):
    """How far a room is that the page opened."""

    CLOSED = "closed"
    STARTING = "starting"
    READY = "ready"
    ENDED = "ended"


@dataclass(frozen=True, slots=True)
class OpenedView:
    """The simulated room that the page opened.

    Attributes:
        state: how far it is.
        line: what it printed last.
        address: of its console; works once. "" before it answers.
    """

    state: OpenedState
    line: str = ""
    address: str = ""


def draft_refusal(error: HouseflyError) -> JSONResponse:
    """Return why something was not done; with the key that is wrong, if there is one."""
    key = error.key if isinstance(error, ConfigError) else ""
    return refused(409 if isinstance(error, StaleEdits) else 422, refusal_words(error), key)


def refused(status: int, words: Words, key: str = "") -> JSONResponse:
    """Return a refusal with its reason, and the key that is wrong, "" for none."""
    return JSONResponse({"error": tree(words), "key": key}, status_code=status)
