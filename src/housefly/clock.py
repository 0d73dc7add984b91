"""Real and stepped clocks, and the offset of another clock.

Everything pure takes ``now`` as an argument; only shells read a clock.
"""

from __future__ import annotations

import time
from collections import deque
from typing import Protocol


class Clock(Protocol):
    """Where a shell reads the time [s]; monotonic, never wall time."""

    def now(self) -> float:
        """Return the current monotonic time [s]."""
        ...


class RealClock:
    """The machine's monotonic clock, shared by all processes of one machine."""

    def now(self) -> float:
        """Return CLOCK_MONOTONIC [s]."""
        return time.monotonic()


class SteppedClock:
    """A clock that only ``advance`` moves; it makes flights reproducible."""

    def __init__(self, start: float = 0.0) -> None:
        self._now = start

    def now(self) -> float:
        """Return the time [s] that was last set."""
        return self._now

    def advance(self, seconds: float) -> float:
        """Move forward by a non-negative number of seconds and return the new time."""
        if seconds < 0:
            raise ValueError("a stepped clock does not run backwards")
        self._now += seconds
        return self._now


class ClockOffset:
    """The offset between our clock and somebody's stamps, by the quickest of what came lately.

    It is the smallest ``received - stamped`` of a window: what came without delay tells it best.

    Args:
        window: how long an offset counts [s].
    """

    def __init__(self, window: float) -> None:
        self._window = window
        self._offsets: deque[tuple[float, float]] = deque()  # received at, offset: both rising

    def reset(self) -> None:
        """Forget the offsets: the other clock is another one now."""
        self._offsets.clear()

    def least(self, offset: float, received_at: float) -> float:
        """Take in an offset [s]; return the smallest in the window before ``received_at`` [s]."""
        while self._offsets and self._offsets[-1][1] >= offset:
            self._offsets.pop()
        self._offsets.append((received_at, offset))
        while self._offsets[0][0] < received_at - self._window:
            self._offsets.popleft()
        return self._offsets[0][1]
