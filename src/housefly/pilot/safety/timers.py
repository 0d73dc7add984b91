"""Small memories of a flight: since when something holds, and what happened lately."""

from __future__ import annotations

from collections import deque
from math import isfinite, nan
from typing import Generic, TypeVar

T = TypeVar("T")


class Stopwatch:
    """Measures how long something has held without a break."""

    def __init__(self) -> None:
        self._since = nan

    def update(self, holds: bool, now: float) -> float:
        """Return how long it has held at a time [s]; 0 when it does not hold."""
        if not holds:
            self._since = nan
            return 0.0
        if not isfinite(self._since):
            self._since = now
        return now - self._since


class Window(Generic[T]):
    """What was seen in the last seconds, oldest first."""

    def __init__(self, span: float) -> None:
        self._span = span
        self._seen: deque[tuple[float, T]] = deque()

    def add(self, now: float, value: T) -> None:
        """Take in what is seen at a time [s]."""
        self._seen.append((now, value))

    def add_or_renew(self, now: float, value: T) -> None:
        """Take in what is seen at a time [s]; what is seen again has its newest time only."""
        if self._seen and self._seen[-1][1] == value:
            self._seen.pop()
        self._seen.append((now, value))

    def oldest(self, now: float) -> T:
        """Return the oldest that was seen within the span before a time [s]."""
        self._forget(now)
        return self._seen[0][1]

    def values(self, now: float) -> list[T]:
        """Return what was seen within the span before a time [s]."""
        self._forget(now)
        return [value for _, value in self._seen]

    def _forget(self, now: float) -> None:
        while self._seen and now - self._seen[0][0] > self._span:
            self._seen.popleft()

    def clear(self) -> None:
        """Forget everything."""
        self._seen.clear()
