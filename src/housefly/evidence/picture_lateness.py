"""By how much a picture comes later than others, by the drone's own clock."""

from __future__ import annotations

from housefly.clock import ClockOffset
from housefly.messages import VideoFrame

_WINDOW = 30.0
"""The quickest picture of so long is the one to compare with [s]: clocks drift apart slowly."""


class PictureLateness:
    """Compares each picture's stamp with its arrival; the quickest of the last 30 s is not late.

    What delays pictures from the first one on is not seen: their stamps say nothing of our clock.
    """

    def __init__(self) -> None:
        self._newest: VideoFrame | None = None
        self._quickest = ClockOffset(_WINDOW)

    def of(self, frame: VideoFrame) -> float:
        """Return how late a picture is [s]; 0 when the drone does not stamp its pictures."""
        if not frame.drone_time:
            return 0.0
        if self._newest is not None and self._has_another_clock(self._newest, frame):
            self._quickest.reset()
        self._newest = frame
        delay = frame.received_at - frame.drone_time
        return delay - self._quickest.least(delay, frame.received_at)

    @staticmethod
    def _has_another_clock(before: VideoFrame, frame: VideoFrame) -> bool:
        return frame.drone_time < before.drone_time or frame.received_at < before.received_at
