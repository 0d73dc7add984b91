"""The last seconds of the camera, in memory only."""

from __future__ import annotations

from collections import deque

from housefly.evidence.privacy_mask import FrameToMask

RING_BYTES_MAX = 32 * 2**20
"""Twice what the fastest stream that we accept brings in five seconds [bytes]."""


class RingBuffer:
    """The newest pictures, from a key frame on; the oldest group goes first.

    Args:
        seconds: how far back it reaches, if the pictures take no more than ``bytes_max``.
        bytes_max: what they may take [bytes].
    """

    def __init__(self, seconds: float, bytes_max: int = RING_BYTES_MAX) -> None:
        self._seconds, self._bytes_max = seconds, bytes_max
        self._groups: deque[list[FrameToMask]] = deque()
        self._bytes = 0

    @property
    def size(self) -> int:
        """What the pictures take now [bytes]."""
        return self._bytes

    def add(self, filmed: FrameToMask) -> None:
        """Keep a picture; one that nothing can be decoded from is not kept."""
        newest = self._newest()
        if newest is not None and filmed.frame.received_at < newest.frame.received_at:
            self.clear()  # another clock
        if filmed.frame.keyframe:
            self._groups.append([])
        if not self._groups:
            return
        self._groups[-1].append(filmed)
        self._bytes += len(filmed.frame.data)
        self._forget_old(filmed.frame.received_at)

    def newest_frames(self, seconds: float) -> tuple[FrameToMask, ...]:
        """Return the newest pictures, at least so many seconds if there are, from a key frame on.

        Args:
            seconds: how far back from the newest picture [s].
        """
        newest = self._newest()
        if newest is None:
            return ()
        start = newest.frame.received_at - seconds
        groups = list(self._groups)
        while len(groups) > 1 and groups[1][0].frame.received_at <= start:
            del groups[0]
        return tuple(filmed for group in groups for filmed in group)

    def frames_until(self, at: float) -> tuple[FrameToMask, ...]:
        """Return the pictures of one group up to a time [s], from its key frame on, or none."""
        for group in reversed(self._groups):
            if group and group[0].frame.received_at <= at:
                return tuple(one for one in group if one.frame.received_at <= at)
        return ()

    def clear(self) -> None:
        """Forget everything at once."""
        self._groups.clear()
        self._bytes = 0

    def _newest(self) -> FrameToMask | None:
        return self._groups[-1][-1] if self._groups and self._groups[-1] else None

    def _forget_old(self, now: float) -> None:
        start = now - self._seconds
        while len(self._groups) > 1 and (
            self._groups[1][0].frame.received_at <= start or self._bytes > self._bytes_max
        ):
            self._bytes -= sum(len(filmed.frame.data) for filmed in self._groups.popleft())
        if self._bytes > self._bytes_max:  # one group alone is too long: no key frame comes
            self.clear()
