"""A limit on frames, so that a sender gone mad cannot keep the pilot from its work."""

from __future__ import annotations

MOST = 2000
"""Frames a second that are looked at; the fastest systems send a thousand."""


class FloodGate:
    """Lets so many frames pass in each second."""

    def __init__(self, most: int = MOST) -> None:
        self._most = most
        self._second = float("-inf")
        self._passed = 0

    def admits(self, now: float) -> bool:
        """Tell whether a frame that arrives now [s] is within the limit, and count it."""
        if now - self._second >= 1.0:
            self._second, self._passed = now, 0
        self._passed += 1
        return self._passed <= self._most
