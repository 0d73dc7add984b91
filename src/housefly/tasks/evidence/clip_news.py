"""What a recording tells: what it was asked by, and what became of it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class ClipOutcome(Enum):
    """What became of a clip or snapshot."""

    WHOLE = "whole"
    EMPTY = "empty"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class ClipOrigin:
    """Who wants it: id and service of the task, id of the event behind it."""

    task: int = 0
    service: str = ""
    cause: str = ""


@dataclass(frozen=True, slots=True)
class ClipNews:
    """What became of a clip or snapshot, in words for people."""

    clip: str
    outcome: ClipOutcome
    words: str
