"""A limit on frames, so that a runaway sender cannot starve the pilot."""

from __future__ import annotations

FRAMES_PER_SECOND_MAX = 2000
"""Frames accepted in a second; the fastest systems send a thousand."""


class FrameLimiter:
    """Admits a fixed number of frames in each second."""

    def __init__(self, limit: int = FRAMES_PER_SECOND_MAX) -> None:
        self._limit = limit
        self._second = float("-inf")
        self._admitted = 0

    def admits(self, now: float) -> bool:
        """Count a frame that arrives now [s]; return whether it is within the limit."""
        if now - self._second >= 1.0:
            self._second, self._admitted = now, 0
        self._admitted += 1
        return self._admitted <= self._limit
