"""One pre-flight check as people read it, and what is known of the frames of a site."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.messages.words import UNSAID, Words, joined, said


@dataclass(frozen=True, slots=True)
class PreflightCheck:
    """One line of the list that is looked at before a take-off.

    Attributes:
        code: short name.
        title: what is looked at, in words.
        fault: what is the matter when it fails, in words.
        passed: whether all is well.
        required: no take-off without it.
        value: what was found, in words; UNSAID where the fault says it.
        limit: what is allowed, in words.
        why: what would happen otherwise.
        mend: what to do.
    """

    code: str
    title: Words
    fault: Words
    passed: bool
    required: bool
    value: Words
    limit: Words
    why: Words
    mend: Words

    @property
    def refusal(self) -> Words:
        """Why there is no take-off while it fails, and what to do."""
        if not self.value:
            return joined("; ", (self.fault, self.mend))
        return Words(
            "{why}: {found}, must be {limit}; {mend}",
            why=self.fault,
            found=self.value,
            limit=self.limit,
            mend=self.mend,
        )


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
    words: Words = UNSAID

    @property
    def said(self) -> Words:
        """What is known, in words."""
        return joined(", ", filter(None, (said(self.state), self.words)))


FRAMES_NOT_NEEDED = FramesKnown()
"""Simulated rooms, and whoever has no frames to check."""
