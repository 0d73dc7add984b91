"""Keeps a loop on its period, and counts how often something comes."""

from __future__ import annotations

import asyncio
from collections import deque

from housefly.clock import Clock, RealClock


class Rate:
    """Keeps an asyncio loop on a fixed period without accumulating drift.

    After a stall it does not catch up: missed ticks are counted and skipped.
    """

    def __init__(self, frequency_hz: float, clock: Clock | None = None) -> None:
        self.period = 1.0 / frequency_hz
        self.missed = 0
        self._clock = clock or RealClock()
        self._next = self._clock.now() + self.period

    async def sleep(self) -> float:
        """Wait for the next tick and return how late [s] it was.

        One that is late already lets the others of its loop run: a pilot that always is must still
        hear STOP.
        """
        await asyncio.sleep(max(0.0, self._next - self._clock.now()))
        late = self._clock.now() - self._next
        skipped = max(0, int(late / self.period))
        self.missed += skipped
        self._next += (skipped + 1) * self.period
        return late


class Frequency:
    """Arrivals per second over the last second."""

    def __init__(self) -> None:
        self._arrivals: deque[float] = deque(maxlen=2000)

    def add(self, now: float) -> None:
        """Record one arrival."""
        self._arrivals.append(now)

    def rate_hz(self, now: float) -> float:
        """Return how many arrived within the last second."""
        while self._arrivals and self._arrivals[0] <= now - 1.0:
            self._arrivals.popleft()
        return float(len(self._arrivals))
