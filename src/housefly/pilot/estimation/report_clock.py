"""When the drone wrote a report, on our clock.

A report that a busy machine reads late tells of an earlier moment. Poses are dated in the same way
(``tracking/capture_clock.py``): held against one another, both have to be.
"""

from __future__ import annotations

from math import inf, isfinite

from housefly.clock import ClockOffset

OFFSET_WINDOW = 1.0
"""The quickest report of so long before tells the offset of the drone's clock [s], as for poses."""
STANDS_AFTER = 1.0
"""A clock that has not moved for this long while reports come tells nothing [s]."""


class ReportClock:
    """Dates reports by the drone's own clock, as far as it tells it."""

    def __init__(self) -> None:
        self._offset = ClockOffset(OFFSET_WINDOW)
        self._drone_time = -inf
        self._moved_at = -inf

    def written_at(self, drone_time: float | None, received_at: float) -> float:
        """Return when a report was written [s], no later than it was received.

        Args:
            drone_time: by the drone's clock [s]; None or nan where it does not tell it.
            received_at: by ours [s].
        """
        if drone_time is None or not isfinite(drone_time):
            return received_at
        if drone_time < self._drone_time:  # it wrapped, or the drone started anew
            self._offset.reset()
        if drone_time != self._drone_time:
            self._drone_time, self._moved_at = drone_time, received_at
        elif received_at - self._moved_at > STANDS_AFTER:
            return received_at
        return drone_time + self._offset.least(received_at - drone_time, received_at)
