"""What a recording tells: what it was asked by, and what became of it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class ClipOutcome(Enum):
    """What became of a clip or snapshot; a whole one and a cut off one are kept."""

    WHOLE = "whole"
    CUT_OFF = "cut off"
    EMPTY = "empty"
    FAILED = "failed"


KEPT = frozenset({ClipOutcome.WHOLE, ClipOutcome.CUT_OFF})
"""What is on the disk and can be found."""


@dataclass(frozen=True, slots=True)
class ClipOrigin:
    """Who wants it: id and service of the task, id of the event behind it."""

    task: int = 0
    service: str = ""
    cause: str = ""


@dataclass(frozen=True, slots=True)
class ClipResult:
    """What became of a clip or snapshot, in words for people."""

    clip: str
    outcome: ClipOutcome
    words: str
