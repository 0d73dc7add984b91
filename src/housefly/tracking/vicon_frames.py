"""Converts Vicon frames to poses in metres; holds the state that spans frames."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite

from housefly.errors import WireError
from housefly.messages import Pose, Sighting
from housefly.tracking.capture_clock import CaptureClock
from housefly.tracking.counts import FrameCounts
from housefly.wires.vicon import (
    ROOT_SEGMENT,
    TICKS_PER_SECOND,
    ApplicationInfo,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    SegmentPose,
    StreamInfo,
    SubjectInfo,
    ViconObject,
    quaternion_from_matrix,
)

_POSITION_MAX_MM = 1e6
"""Positions beyond this on any axis [mm] are refused: no tracked room is a kilometre long."""
_LATENCY_MAX = 5.0
_PERIOD_MAX = 10.0
_RESTART_GAP = 1.0
"""A frame number this far back [s] means that the server restarted; less is an old frame."""


class ViconFrames:
    """Converts the packets of one connection to sightings.

    Args:
        latency: from exposure to arrival [s], where the server does not say it.
        counts: kept up to date.
    """

    def __init__(self, latency: float, counts: FrameCounts) -> None:
        self.y_up = False
        self._latency = latency
        self._counts = counts
        self._clock = CaptureClock()
        self._period = 0.0
        self._number: int | None = None
        self._subjects: dict[int, tuple[str, int]] = {}

    def read(self, items: Iterable[ViconObject], received_at: float) -> tuple[Sighting, ...] | None:
        """Return the bodies seen in a packet, or None when the packet holds no new frame."""
        number: int | None = None
        latency = self._latency
        subjects: dict[int, tuple[str, int]] = {}
        seen: list[GlobalSegments] = []
        for item in items:
            match item:
                case StreamInfo(ticks):
                    self._use_period(ticks / TICKS_PER_SECOND)
                case ApplicationInfo(y_up):
                    self.y_up = y_up
                case SubjectInfo(identity, name):
                    root = _root_of(item)
                    if root is not None:
                        subjects[identity] = (name, root)
                case FrameInfo(found):
                    number = found
                case LatencyInfo(samples):
                    total = sum(duration for _, duration in samples)
                    latency = total if samples and 0 <= total < _LATENCY_MAX else self._latency
                case GlobalSegments():
                    seen.append(item)
        # Static objects are left out of a frame when they did not change.
        self._subjects = subjects or self._subjects
        if number is None or not self._is_new(number):
            return None
        self._counts.frames += 1
        captured_at = self._clock.captured_at(number, self._period, latency, received_at)
        return () if self.y_up else tuple(self._sightings(seen, captured_at, received_at))

    def _use_period(self, period: float) -> None:
        sane = period if 0 < period < _PERIOD_MAX else 0.0
        if sane != self._period:
            self._period = sane
            self._clock.reset()

    def _is_new(self, number: int) -> bool:
        last, self._number = self._number, number
        if last is None or number > last:
            return True
        if (last - number) * (self._period or 0.01) >= _RESTART_GAP:
            self._clock.reset()
            return True
        self._number = last
        if number == last:
            self._counts.repeated += 1
        else:
            self._counts.backward += 1
        return False

    def _sightings(
        self, seen: list[GlobalSegments], captured_at: float, received_at: float
    ) -> Iterable[Sighting]:
        for body in seen:
            name, root = self._subjects.get(body.subject, ("", ROOT_SEGMENT))
            for segment in body.segments:
                if name and segment.identity == root:
                    try:
                        yield Sighting(name, _pose(segment), captured_at, received_at)
                    except WireError:
                        self._counts.refused += 1


def _root_of(subject: SubjectInfo) -> int | None:
    roots = (each.identity for each in subject.segments if each.parent == ROOT_SEGMENT)
    return next(roots, None)


def _pose(segment: SegmentPose) -> Pose:
    """Return the pose in metres; raises WireError for one that cannot be."""
    x, y, z = segment.translation_mm
    if not all(isfinite(value) and abs(value) <= _POSITION_MAX_MM for value in (x, y, z)):
        raise WireError(f"Vicon position {segment.translation_mm} mm is not within a kilometre")
    return Pose((x / 1000.0, y / 1000.0, z / 1000.0), quaternion_from_matrix(segment.rotation))
