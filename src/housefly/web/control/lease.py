"""Who has control: one pilot, any number of watchers. Pure; the caller passes the time."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages.words import UNSAID, Words

LEASE_TIMEOUT = 3.0
"""Control is lost when its holder was not heard for this long [s]."""
RETURN_TIMEOUT = 10.0
"""After a restart of the console control waits this long for its holder [s]."""


@dataclass(slots=True)
class Lease:
    """The right to fly, held by one viewer at most.

    Attributes:
        holder: number of the viewer who has control, or None.
        renewed_at: when the holder was last heard [s].
    """

    holder: int | None = None
    renewed_at: float = 0.0

    def reserve(self, viewer: int, now: float) -> None:
        """Keep control for who had it before a restart of the console, and soon comes back."""
        self.holder, self.renewed_at = viewer, now + RETURN_TIMEOUT - LEASE_TIMEOUT

    def acquire(self, viewer: int, now: float, *, flying: bool, held: bool) -> Words:
        """Give control to the viewer; returns UNSAID or, in words, why not."""
        if self.holder not in (None, viewer) and flying and not held:
            return Words("someone else flies the drone: hold the button to take over")
        self.holder, self.renewed_at = viewer, now
        return UNSAID

    def release(self, viewer: int) -> Words:
        """Give up control; returns UNSAID or, in words, why not."""
        if self.holder != viewer:
            return Words("you do not have control")
        self.holder = None
        return UNSAID

    def hand_over(self, viewer: int, to: int, now: float) -> Words:
        """Pass control to another viewer; returns UNSAID or, in words, why not."""
        if self.holder != viewer:
            return Words("you do not have control")
        self.holder, self.renewed_at = to, now
        return UNSAID

    def renew(self, viewer: int, now: float) -> None:
        """Note a sign of life of the holder."""
        if viewer == self.holder:
            self.renewed_at = max(self.renewed_at, now)

    def expire(self, now: float) -> bool:
        """Free the lease when its holder was silent too long; returns whether it did."""
        if self.holder is None or now - self.renewed_at <= LEASE_TIMEOUT:
            return False
        self.holder = None
        return True
