"""Sequence numbers of AT commands, and when they start again at 1.

A drone obeys a command only when its number is above the last one it obeyed; 1 always counts
(docs/wires.md, section 4).
"""

from __future__ import annotations

SILENCE = 2.0
"""After this long without a command the drone has forgotten us, and numbers start again [s]."""
DEAF = 0.3
"""How long the drone must complain about missing commands, although we send them, before numbers
start again [s].

Long enough that a few lost datagrams do not count: a restart whose own datagram is lost leaves us
    refused until the next one.
"""


class Numbering:
    """Counts commands; one for the life of a link."""

    def __init__(self) -> None:
        self._next = 1
        self._last_at: float | None = None
        self._heard_at: float = 0.0

    def take(self, count: int, now: float) -> int:
        """Return the first of ``count`` numbers to use now [s]."""
        if self._last_at is None or now - self._last_at > SILENCE:
            self._restart(now)
        first = self._next
        self._next += count
        self._last_at = now
        return first

    def drone_hears(self, hears: bool, now: float) -> None:
        """Note whether the drone's newest report shows that it receives our commands; restart when
        it has not for long.
        """
        if hears:
            self._heard_at = now
        elif self._last_at is not None and now - self._heard_at > DEAF:
            self._restart(now)

    def _restart(self, now: float) -> None:
        self._next = 1
        self._heard_at = now
