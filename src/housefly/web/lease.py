"""One pilot, many watchers: who has control. Pure; the caller brings the time."""

from __future__ import annotations

from dataclasses import dataclass

PATIENCE = 3.0
"""Control is lost when its holder was not heard for this long [s]."""


@dataclass(slots=True)
class Lease:
    """The right to fly, held by one viewer at most.

    Attributes:
        holder: number of the viewer who has control, or None.
        heard_at: when the holder was last heard [s].
    """

    holder: int | None = None
    heard_at: float = 0.0

    def take(self, viewer: int, now: float, *, flying: bool, held: bool) -> str:
        """Give control to the viewer; returns "" or, in words, why not."""
        if self.holder not in (None, viewer) and flying and not held:
            return "someone else flies the drone: hold the button to take over"
        self.holder, self.heard_at = viewer, now
        return ""

    def release(self, viewer: int) -> str:
        """Lay down control; returns "" or, in words, why not."""
        if self.holder != viewer:
            return "you do not have control"
        self.holder = None
        return ""

    def give(self, viewer: int, to: int, now: float) -> str:
        """Hand control over to another viewer; returns "" or, in words, why not."""
        if self.holder != viewer:
            return "you do not have control"
        self.holder, self.heard_at = to, now
        return ""

    def heard(self, viewer: int, now: float) -> None:
        """Note a sign of life."""
        if viewer == self.holder:
            self.heard_at = now

    def expired(self, now: float) -> bool:
        """Free the lease when its holder was silent too long; returns whether it did."""
        if self.holder is None or now - self.heard_at <= PATIENCE:
            return False
        self.holder = None
        return True
