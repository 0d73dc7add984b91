"""Capture times on our clock from a server's frame numbers."""

from __future__ import annotations

from housefly.clock import ClockOffset

OFFSET_WINDOW = 1.0
"""Window of the min-filter [s]: long against jitter, short against a server's clock drift."""


class CaptureClock:
    """Maps frame numbers to our monotonic clock by a min-filter.

    A frame arrives at ``received = number * period + offset + latency + delay`` where delay >= 0 is
    the network's. The smallest ``received - latency - number * period`` of the last second is the
    best offset known, so jitter on the way does not reach the capture time. Times never run
    backwards.
    """

    def __init__(self) -> None:
        self._offset = ClockOffset(OFFSET_WINDOW)
        self._last = float("-inf")

    def reset(self) -> None:
        """Forget the offsets: the server restarted its count."""
        self._offset.reset()

    def captured_at(self, number: int, period: float, latency: float, received_at: float) -> float:
        """Return when a frame was captured [s].

        Args:
            number: the server's frame number.
            period: time between two numbers [s]; 0 when the server does not send it.
            latency: from exposure to sending, as sent or as configured [s].
            received_at: when the frame arrived [s].
        """
        captured = latest = received_at - latency
        if period > 0:
            offset = self._offset.least(latest - number * period, received_at)
            captured = min(latest, number * period + offset)
        self._last = max(captured, self._last)
        return self._last
