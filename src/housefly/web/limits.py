"""How many commands one socket may send."""

from __future__ import annotations

from dataclasses import dataclass

RATE = 20.0
"""Commands a second that one socket may send; STOP and LAND are not counted."""
BURST = 40.0
"""Commands that may come at once after a pause."""


@dataclass(slots=True)
class Bucket:
    """A token bucket: ``RATE`` tokens a second, ``BURST`` at most. ``over`` counts refusals since
    the last pause.
    """

    tokens: float = BURST
    at: float = 0.0
    over: int = 0

    def spend(self, now: float) -> bool:
        """Take one token at the time [s]; returns False when there is none."""
        self.tokens = min(BURST, self.tokens + RATE * max(0.0, now - self.at))
        self.at = now
        if self.tokens < 1.0:
            self.over += 1
            return False
        self.tokens -= 1.0
        self.over = 0
        return True
