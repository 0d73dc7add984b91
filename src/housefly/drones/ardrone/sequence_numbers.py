"""Sequence numbers of AT commands, and when they restart at 1.

A drone obeys a command only when its number is above the last one obeyed; 1 always counts
(docs/wires.md, section 4).
"""

from __future__ import annotations

SESSION_TIMEOUT = 2.0
"""After this long without a command the drone has forgotten us, and numbers restart [s]."""
_UNHEARD_MAX = 0.3
"""How long the drone may report missing commands while we send them, before numbers restart [s].

Long enough that a few lost datagrams do not count: when the datagram of the restart itself is lost,
commands are refused until the next restart.
"""


class SequenceNumbers:
    """Numbers commands; one instance for the life of a link."""

    def __init__(self) -> None:
        self._next = 1
        self._last_at: float | None = None
        self._received_at: float = 0.0

    def reserve(self, count: int, now: float) -> int:
        """Return the first of ``count`` numbers to use now [s]."""
        if self._last_at is None or now - self._last_at > SESSION_TIMEOUT:
            self._restart(now)
        first = self._next
        self._next += count
        self._last_at = now
        return first

    def report_reception(self, received: bool, now: float) -> None:
        """Note whether the drone's newest report shows that it receives our commands."""
        if received:
            self._received_at = now
        elif self._last_at is not None and now - self._received_at > _UNHEARD_MAX:
            self._restart(now)

    def _restart(self, now: float) -> None:
        self._next = 1
        self._received_at = now
