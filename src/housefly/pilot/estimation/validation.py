"""Which sightings are accepted, and what is said about those that are not."""

from __future__ import annotations

from collections import deque
from enum import Enum, IntEnum
from itertools import pairwise
from math import isfinite

from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Severity
from housefly.messages.sensing import Sighting
from housefly.messages.words import UNSAID, Words, figure, said
from housefly.numeric import compiled

CLOCK_TOLERANCE = 0.005
"""A stamp may lie this far ahead of our clock [s]: clocks are read at different moments."""
SIGHTING_AGE_MAX = 1.0
"""A sighting captured longer ago than this is useless and dropped [s]."""
REJECTION_WARNING_AFTER = 0.5
"""After rejecting everything for this long a person is told [s]."""
REJECTION_REPORT_PERIOD = 2.0
"""The same event is repeated at most this often [s]."""

REJECTION_WINDOW, REJECTION_SERIES_TOLD = 30, 5
"""A person is told, too, when acceptance ended so often within so many sightings. One long series
is told by how long it lasts.
"""


class RejectionReason(Enum):
    """Why a sighting was rejected."""

    NOT_FINITE = "a number is not finite"
    NOT_A_ROTATION = "the orientation is not a unit quaternion"
    FUTURE = "its stamp lies in the future"
    OUT_OF_ORDER = "its stamp is not newer than the last one"
    STALE = "it is too old"
    JUMP = "it is too far from where the drone can be"
    DISAGREES = "it does not agree with the drone's own motion"
    FROZEN = "it stays the same to the last bit while the drone flies"


class StampFault(IntEnum):
    """What may be wrong with the stamp of a sighting."""

    NONE = 0
    FUTURE = 1
    OUT_OF_ORDER = 2
    STALE = 3


STAMP_REJECTIONS = {
    StampFault.FUTURE: RejectionReason.FUTURE,
    StampFault.OUT_OF_ORDER: RejectionReason.OUT_OF_ORDER,
    StampFault.STALE: RejectionReason.STALE,
}


@compiled
def stamp_fault(captured_at: float, now: float, last_capture: float) -> int:
    """Return the ``StampFault`` of a sighting; times in seconds."""
    if captured_at > now + CLOCK_TOLERANCE:
        return StampFault.FUTURE.value
    if captured_at <= last_capture:
        return StampFault.OUT_OF_ORDER.value
    if now - captured_at > SIGHTING_AGE_MAX:
        return StampFault.STALE.value
    return StampFault.NONE.value


def sighting_fault(sighting: Sighting, now: float, last_capture: float) -> RejectionReason | None:
    """Return what is wrong with a sighting by itself and its stamp, or None.

    Args:
        sighting: what the tracking system sent.
        now: time [s].
        last_capture: capture time of the last accepted sighting [s].
    """
    pose = sighting.pose
    if not all(map(isfinite, (*pose.position, *pose.orientation, sighting.captured_at))):
        return RejectionReason.NOT_FINITE
    w, x, y, z = pose.orientation
    if abs(w * w + x * x + y * y + z * z - 1.0) > 0.02:
        return RejectionReason.NOT_A_ROTATION
    return STAMP_REJECTIONS.get(StampFault(stamp_fault(sighting.captured_at, now, last_capture)))


class RejectionLog:
    """Counts rejections and turns those that last into events."""

    def __init__(self) -> None:
        self._counts = dict.fromkeys(RejectionReason, 0)
        self._rejecting_since: float | None = None
        self._reported_at = -REJECTION_REPORT_PERIOD
        self._judged: deque[bool] = deque(maxlen=REJECTION_WINDOW)

    @property
    def counts(self) -> dict[RejectionReason, int]:
        """How often each reason was given since the start."""
        return dict(self._counts)

    @property
    def rejecting_since(self) -> float | None:
        """When the present series of jumps began [s], None while sightings are accepted."""
        return self._rejecting_since

    def accepted(self) -> None:
        """A sighting was accepted: the series ends."""
        self._rejecting_since = None
        self._judged.append(True)

    def reject(
        self, reason: RejectionReason, now: float, words: Words = UNSAID
    ) -> tuple[Event, ...]:
        """Count a rejection; return an event when it is one of many.

        Args:
            reason: why.
            now: time [s].
            words: said in place of the reason's own.
        """
        self._counts[reason] += 1
        if reason is RejectionReason.OUT_OF_ORDER:
            return ()
        self._judged.append(False)
        self._rejecting_since = now if self._rejecting_since is None else self._rejecting_since
        text = self._text(now - self._rejecting_since, words or said(reason))
        if not text or now - self._reported_at < REJECTION_REPORT_PERIOD:
            return ()
        self._reported_at = now
        return (Event(now, Severity.WARNING, EventCode.TRACKING_REFUSED, text),)

    def _text(self, seconds: float, words: Words) -> Words:
        """Return what a person has to know of a series of so many seconds, or nothing."""
        if seconds >= REJECTION_WARNING_AFTER:
            since = figure(seconds, ".1f")
            return Words("tracking is not believed since {n} s: {why}", n=since, why=words)
        series = sum(was and not now_is for was, now_is in pairwise(self._judged))
        if series < REJECTION_SERIES_TOLD:
            return UNSAID
        refused, judged = self._judged.count(False), len(self._judged)
        return Words(
            "tracking is believed in part, {n} of the last {m} poses are not: {why}",
            n=figure(refused),
            m=figure(judged),
            why=words,
        )
