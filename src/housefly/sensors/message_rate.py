"""Message rate and age of a source, and a limit of its rate; pure, times are passed in."""

from __future__ import annotations

from collections import deque
from math import inf

RATE_WINDOW = 5.0
"""Time over which a rate is measured [s]."""
_MOST = 512


class MessageRate:
    """Arrival times of one source."""

    def __init__(self) -> None:
        self._heard: deque[float] = deque(maxlen=_MOST)

    def add(self, now: float) -> None:
        """Add an arrival at this time [s]."""
        self._heard.append(now)

    def age(self, now: float) -> float:
        """Return the time since the last arrival [s], infinite if there was none."""
        return now - self._heard[-1] if self._heard else inf

    def rate_hz(self, now: float) -> float:
        """Return the arrivals per second over ``RATE_WINDOW`` [Hz]; 0 with fewer than two."""
        recent = [at for at in self._heard if at > now - RATE_WINDOW]
        return (len(recent) - 1) / (now - recent[0]) if len(recent) > 1 and now > recent[0] else 0.0


class TokenBucket:
    """A rate limiter that allows bursts of up to one second.

    Args:
        rate_hz: messages per second allowed in the long run [Hz]; a single one is always allowed.
    """

    def __init__(self, rate_hz: float) -> None:
        self._rate = rate_hz
        self._size = max(1.0, rate_hz)
        self._left = self._size
        self._at = -inf

    def consume(self, now: float) -> bool:
        """Take one token at this time [s]; return False if none is left."""
        self._left = min(self._size, self._left + self._rate * max(0.0, now - self._at))
        self._at = max(now, self._at)
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True
