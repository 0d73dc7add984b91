"""When a scan was taken, by the scanner's own clock: one that waited on the way is old.

A busy machine leaves scans in the socket, seconds of them. Dated by their arrival, people would
stand where they stood then.
"""

from __future__ import annotations

from math import inf

from housefly.wires.scip.replies import STAMP_PERIOD

CLOCK_DRIFT = 5e-4
"""A scanner's clock may run slower than ours by this share."""


class ScanClock:
    """Dates the scans of one connection: the quickest of them tells the offset of the clocks.

    It is never forgotten, as ``ClockOffset`` forgets: what waits in a stream may stay late for
    minutes.
    """

    def __init__(self) -> None:
        self._stamp, self._unwrapped = -1, 0
        self._offset, self._received_at = inf, 0.0

    def taken_at(self, stamp: int, received_at: float) -> float:
        """Return when a scan left the scanner [s], no later than it was received.

        Args:
            stamp: of the scanner's clock [ms], 24 bits.
            received_at: by our clock [s].
        """
        step = (stamp - self._stamp) % STAMP_PERIOD
        if self._stamp < 0 or step > STAMP_PERIOD // 2:  # the first, or its clock was set back
            self._unwrapped, self._offset = stamp, inf
        else:
            self._unwrapped += step
            self._offset += CLOCK_DRIFT * (received_at - self._received_at)
        self._stamp, self._received_at = stamp, received_at
        seconds = self._unwrapped / 1000.0
        self._offset = min(self._offset, received_at - seconds)
        return seconds + self._offset
