"""The door of the filter: which sightings may come in, and what is said about those that may not."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from math import isfinite

from housefly.messages import Event, Severity, Sighting
from housefly.numeric import compiled

FUTURE_TOLERANCE = 0.005
"""A stamp may lie this far ahead of our clock [s]: clocks are read at different moments."""
OLDEST = 1.0
"""A sighting captured longer ago than this is useless and dropped [s]."""
REFUSED_TOO_LONG = 0.5
"""After refusing everything for this long a person is told [s]."""
REPORT_PERIOD = 2.0
"""The same complaint is repeated at most this often [s]."""


class Refusal(Enum):
    """Why a sighting was not believed."""

    NOT_FINITE = "a number is not finite"
    NOT_A_ROTATION = "the orientation is not a unit quaternion"
    FUTURE = "its stamp lies in the future"
    OUT_OF_ORDER = "its stamp is not newer than the last one"
    STALE = "it is too old"
    JUMP = "it is too far from where the drone can be"
    FROZEN = "it stays the same to the last bit while the drone flies"


@dataclass(frozen=True, slots=True)
class Refused:
    """How often each reason was given since the start."""

    counts: tuple[tuple[Refusal, int], ...]

    def of(self, refusal: Refusal) -> int:
        """Return how often this reason was given."""
        return dict(self.counts)[refusal]


FUTURE, OUT_OF_ORDER, STALE = 1, 2, 3
"""What ``stamp_fault`` finds."""
STAMP_FAULTS = {FUTURE: Refusal.FUTURE, OUT_OF_ORDER: Refusal.OUT_OF_ORDER, STALE: Refusal.STALE}


@compiled
def stamp_fault(captured_at: float, now: float, last_capture: float) -> int:
    """Return what is wrong with a stamp, 0 when nothing is; times in seconds."""
    if captured_at > now + FUTURE_TOLERANCE:
        return FUTURE
    if captured_at <= last_capture:
        return OUT_OF_ORDER
    return STALE if now - captured_at > OLDEST else 0


def fault_of(sighting: Sighting, now: float, last_capture: float) -> Refusal | None:
    """Return what is wrong with a sighting by itself and its stamp, or None.

    Args:
        sighting: what the tracking system sent.
        now: time [s].
        last_capture: capture time of the last believed sighting [s].
    """
    pose = sighting.pose
    if not all(
        isfinite(number) for number in (*pose.position, *pose.orientation, sighting.captured_at)
    ):
        return Refusal.NOT_FINITE
    if abs(sum(number * number for number in pose.orientation) - 1.0) > 0.02:
        return Refusal.NOT_A_ROTATION
    return STAMP_FAULTS.get(stamp_fault(sighting.captured_at, now, last_capture))


class Complaints:
    """Counts refusals and turns those that last into events."""

    def __init__(self) -> None:
        self._counts = dict.fromkeys(Refusal, 0)
        self._refused_since: float | None = None
        self._reported_at = -REPORT_PERIOD

    @property
    def refused(self) -> Refused:
        """How often each reason was given."""
        return Refused(tuple(self._counts.items()))

    @property
    def refused_since(self) -> float | None:
        """When the present series of jumps began [s], None while sightings are believed."""
        return self._refused_since

    def believed(self) -> None:
        """A sighting was taken in: the series ends."""
        self._refused_since = None

    def refuse(self, refusal: Refusal, now: float) -> tuple[Event, ...]:
        """Count a refusal; return an event when nothing has been believed for too long."""
        self._counts[refusal] += 1
        if refusal is Refusal.OUT_OF_ORDER:
            return ()
        self._refused_since = now if self._refused_since is None else self._refused_since
        if now - self._refused_since < REFUSED_TOO_LONG or now - self._reported_at < REPORT_PERIOD:
            return ()
        self._reported_at = now
        text = f"tracking is not believed since {now - self._refused_since:.1f} s: {refusal.value}"
        return (Event(now, Severity.WARNING, "tracking_refused", text),)
