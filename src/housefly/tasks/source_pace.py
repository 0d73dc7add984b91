"""How often those who are no persons may ask something of the tasks."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock

from housefly.errors import TaskError
from housefly.tasks.api.values import ATTENDED, ReasonCode, RequestSurface

AT_ONCE = 20
"""So many requests, sentences and rehearsals of one surface after a pause."""
PERIOD = 3.0
"""Then one more each [s]."""


class SourcePace:
    """A bucket of requests a surface on which nobody may be looking; thread-safe.

    Args:
        clock: monotonic time [s].
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock, self._lock = clock, Lock()
        self._left: dict[RequestSurface, tuple[float, float]] = {}

    def spend(self, surface: RequestSurface) -> None:
        """Count a request; raises TaskError RATE_LIMIT when it is one too many."""
        if surface in ATTENDED:
            return
        with self._lock:
            now = self._clock()
            left, since = self._left.get(surface, (float(AT_ONCE), now))
            left = min(AT_ONCE, left + (now - since) / PERIOD)
            is_over = left < 1.0
            self._left[surface] = (left if is_over else left - 1.0), now
        if is_over:
            words = f"too many requests over {surface.value}; wait {PERIOD:.0f} s"
            raise TaskError(words, ReasonCode.RATE_LIMIT.value)
