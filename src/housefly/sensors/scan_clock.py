"""When a scan was taken, by the scanner's own clock: one that waited on the way is old.

A busy machine leaves scans in the socket, seconds of them. Dated by their arrival, people would
stand where they stood then.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

from housefly.wires.scip.replies import STAMP_PERIOD

CLOCK_DRIFT = 5e-4
"""A scanner's clock may run slower than ours by this share."""
LATE, STEADY = 0.1, 0.02
"""The quickest scan of a while is later than this [s], and as late as that of the while before it:
nothing that waits is so steady. The scanner's clock lost that time.
"""
WHILE = 3.0
"""How long such a while is [s]."""


@dataclass(frozen=True, slots=True)
class ScanStamps:
    """How a scanner counts its time.

    Attributes:
        unit: of its stamps [s].
        period: they begin at 0 again after so many units.
    """

    unit: float
    period: int


SCIP_STAMPS = ScanStamps(1e-3, STAMP_PERIOD)
"""Of SCIP: milliseconds, 24 bits."""
ROS_STAMPS = ScanStamps(1e-9, 2**32 * 1_000_000_000)
"""Of ROS: nanoseconds; seconds have 32 bits."""


class ScanClock:
    """Dates the scans of one connection: the quickest of them tells the offset of the clocks.

    It is not forgotten by itself, as ``ClockOffset`` forgets: what waits in a stream may stay late
    for minutes. But a backlog grows or shrinks; where every scan is late by the same time for two
    whiles, the scanner's clock stood still for that time, and its offset is found anew.

    Args:
        stamps: how the scanner counts.
    """

    def __init__(self, stamps: ScanStamps = SCIP_STAMPS) -> None:
        self._unit, self._period = stamps.unit, stamps.period
        self._stamp, self._unwrapped = -1, 0
        self._offset, self._received_at = inf, 0.0
        self._while_ends, self._quickest, self._quickest_before = -inf, inf, inf

    def taken_at(self, stamp: int, received_at: float) -> float:
        """Return when a scan left the scanner [s], no later than it was received.

        Args:
            stamp: of the scanner's clock [units].
            received_at: by our clock [s].
        """
        step = (stamp - self._stamp) % self._period
        if self._stamp < 0 or step > self._period // 2:  # the first, or its clock was set back
            self._unwrapped, self._offset = stamp, inf
        else:
            self._unwrapped += step
            self._offset += CLOCK_DRIFT * (received_at - self._received_at)
        self._stamp, self._received_at = stamp, received_at
        seconds = self._unwrapped * self._unit
        self._offset = min(self._offset, received_at - seconds)
        self._watch(received_at - seconds - self._offset, received_at)
        return seconds + self._offset

    def _watch(self, late: float, received_at: float) -> None:
        """Find the offset anew where the clock lost time."""
        if received_at >= self._while_ends:
            spread = abs(self._quickest - self._quickest_before)
            if LATE < self._quickest < inf and spread <= STEADY:
                self._offset += self._quickest
                late -= self._quickest
                self._quickest = inf
            self._while_ends = received_at + WHILE
            self._quickest, self._quickest_before = inf, self._quickest
        self._quickest = min(self._quickest, late)
