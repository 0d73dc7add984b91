"""One pre-flight check as people read it, and what is known of the frames of a site."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


@dataclass(frozen=True, slots=True)
class PreflightCheck:
    """One line of the list that is looked at before a take-off.

    Attributes:
        code: short name.
        title: what is looked at, in words.
        fault: what is the matter when it fails, in words.
        passed: whether all is well.
        required: no take-off without it.
        value: what was found, in words.
        limit: what is allowed, in words.
        why: what would happen otherwise.
        mend: what to do.
    """

    code: str
    title: str
    fault: str
    passed: bool
    required: bool
    value: str
    limit: str
    why: str
    mend: str


class FrameCheckState(Enum):
    """Whether somebody has carried the drone to compare tracking, drone and map."""

    NOT_NEEDED = "not needed: the room is simulated"
    NEVER = "never"
    STALE = "before the site's [tracking] was changed"
    WRONG = "found wrong"
    RIGHT = "checked"


@dataclass(frozen=True, slots=True)
class FramesKnown:
    """What is known of the frames of a site.

    Attributes:
        state: whether they were checked, and right.
        words: when they were, or what is wrong.
    """

    state: FrameCheckState = FrameCheckState.NOT_NEEDED
    words: str = ""

    @property
    def said(self) -> str:
        """What is known, in words."""
        return f"{self.state.value}, {self.words}" if self.words else self.state.value


FRAMES_NOT_NEEDED = FramesKnown()
"""Simulated rooms, and whoever has no frames to check."""
