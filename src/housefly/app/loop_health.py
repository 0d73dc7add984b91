"""How punctual the pilot loop is and how fast things arrive."""

from __future__ import annotations

from collections import deque


class Lateness:
    """Lateness of the loop's ticks over a sliding window."""

    def __init__(self, window: int) -> None:
        self._late: deque[float] = deque(maxlen=window)

    def add(self, late: float) -> None:
        """Record one tick's lateness [s]."""
        self._late.append(max(0.0, late))

    def percentiles(self) -> tuple[float, float, float]:
        """Return median, 99th percentile and maximum [s]; zeros before the first tick."""
        if not self._late:
            return 0.0, 0.0, 0.0
        ordered = sorted(self._late)
        last = len(ordered) - 1
        return ordered[last // 2], ordered[round(last * 0.99)], ordered[last]


class Gap:
    """How much later than planned each step comes, whatever held it up.

    A stopped process, swapping and a collection of garbage count wherever they fall: what matters
    is the time since the step before.
    """

    def __init__(self, period: float) -> None:
        self._period = period
        self._last: float | None = None

    def lateness(self, now: float) -> float:
        """Return how much later than planned the step of now comes [s]."""
        last, self._last = self._last, now
        return 0.0 if last is None else max(0.0, now - last - self._period)
