"""Capture times from a sender's own time stamps, and which of its frames are new."""

from __future__ import annotations

from housefly.tracking.capture_clock import CaptureClock
from housefly.tracking.counts import FrameCounts

CLOCK_JUMP = 1.0
"""Stamps this much ahead of or behind the time that passed here [s] mean that the clock was set."""


class SenderClock:
    """Maps a sender's stamps to our monotonic clock; drops what is repeated or late.

    Args:
        counts: kept up to date.
    """

    def __init__(self, counts: FrameCounts) -> None:
        self._counts = counts
        self._clock = CaptureClock()
        self._stamp: int | None = None
        self._received_at = float("-inf")

    def captured_at(
        self, stamp: int, period: float, latency: float, received_at: float
    ) -> float | None:
        """Return when a frame was captured [s], or None when it is not newer than the last one.

        Args:
            stamp: the sender's time of capture [periods].
            period: unit of the stamp [s].
            latency: from capture to sending, as sent or as configured [s].
            received_at: when the frame arrived [s].
        """
        if not self._is_new(stamp, period, received_at):
            return None
        self._stamp, self._received_at = stamp, received_at
        return self._clock.captured_at(stamp, period, latency, received_at)

    def _is_new(self, stamp: int, period: float, received_at: float) -> bool:
        if self._stamp is None:
            return True
        step = (stamp - self._stamp) * period
        if step <= -CLOCK_JUMP or step - (received_at - self._received_at) >= CLOCK_JUMP:
            self._clock.reset()
            self._counts.jumps += 1
            return True
        self._counts.repeated += step == 0
        self._counts.backward += step < 0
        return step > 0
