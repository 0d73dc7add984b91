"""How many commands one socket may send."""

from __future__ import annotations

from dataclasses import dataclass

COMMAND_RATE = 20.0
"""Commands a second that one socket may send; STOP and LAND are not counted."""
COMMAND_BURST = 40.0
"""Commands that may come at once after a pause."""


@dataclass(slots=True)
class CommandLimiter:
    """A token bucket.

    Attributes:
        tokens: commands that may pass now.
        at: when ``tokens`` was last updated [s].
        refused: commands refused since the bucket was last half full.
        rate: tokens a second.
        burst: most tokens.
    """

    tokens: float = COMMAND_BURST
    at: float = 0.0
    refused: int = 0
    rate: float = COMMAND_RATE
    burst: float = COMMAND_BURST

    def is_empty(self, now: float) -> bool:
        """Return whether nothing would pass at the time [s]."""
        return self.tokens + self.rate * max(0.0, now - self.at) < 1.0

    def spend(self, now: float) -> bool:
        """Take one token at the time [s]; returns False when there is none."""
        self.tokens = min(self.burst, self.tokens + self.rate * max(0.0, now - self.at))
        self.at = now
        if self.tokens >= self.burst / 2.0:
            self.refused = 0
        if self.tokens < 1.0:
            self.refused += 1
            return False
        self.tokens -= 1.0
        return True
