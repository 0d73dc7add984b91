"""How many commands one socket may send."""

from __future__ import annotations

from dataclasses import dataclass

COMMAND_RATE = 20.0
"""Commands a second that one socket may send; STOP and LAND are not counted."""
COMMAND_BURST = 40.0
"""Commands that may come at once after a pause."""


@dataclass(slots=True)
class CommandLimiter:
    """A token bucket: fills at ``COMMAND_RATE`` up to ``COMMAND_BURST``.

    Attributes:
        tokens: commands that may pass now.
        at: when ``tokens`` was last updated [s].
        refused: commands refused since one last passed.
    """

    tokens: float = COMMAND_BURST
    at: float = 0.0
    refused: int = 0

    def spend(self, now: float) -> bool:
        """Take one token at the time [s]; returns False when there is none."""
        self.tokens = min(COMMAND_BURST, self.tokens + COMMAND_RATE * max(0.0, now - self.at))
        self.at = now
        if self.tokens < 1.0:
            self.refused += 1
            return False
        self.tokens -= 1.0
        self.refused = 0
        return True
