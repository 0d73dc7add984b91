"""How often one person or program may ask something of the tasks."""

from __future__ import annotations

from housefly.clock import Clock
from housefly.tasks.api.endpoints import Pace
from housefly.web.http.rate_limit import CommandLimiter

_BUCKETS = {Pace.COUNTED: (5.0, 30.0), Pace.COSTLY: (1.0, 8.0)}
"""Requests a second, and at once after a pause."""
_MAX_KNOWN = 1000


class TaskLimits:
    """A token bucket a person and pace; everything happens on one asyncio loop.

    Args:
        clock: the server's clock.
    """

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._buckets: dict[tuple[str, Pace], CommandLimiter] = {}

    def spend(self, who: str, pace: Pace) -> bool:
        """Count a request; returns False when it is one too many."""
        if pace not in _BUCKETS:
            return True
        key = (who, pace)
        if key not in self._buckets and len(self._buckets) >= _MAX_KNOWN:
            del self._buckets[next(iter(self._buckets))]
        rate, burst = _BUCKETS[pace]
        fresh = CommandLimiter(burst, self._clock.now(), 0, rate, burst)
        return self._buckets.setdefault(key, fresh).spend(self._clock.now())
