"""What tracking and drone said lately, as the frame check looks at it."""

from __future__ import annotations

from collections import deque
from math import inf, isfinite

from housefly.lab.frames.samples import CarryTrack, OnboardPoint, TrackedPoint
from housefly.messages import Sighting, Telemetry

_KEPT_TIME = 90.0
"""Older words say nothing about a step [s]."""
_BODIES_MAX = 40
"""More bodies than this are not looked at."""


class FrameLog:
    """Keeps what was said for a minute and a half.

    Attributes:
        heard_at: when the last frame arrived [s].
    """

    def __init__(self) -> None:
        self._bodies: dict[str, deque[TrackedPoint]] = {}
        self._onboard: deque[OnboardPoint] = deque()
        self.heard_at = -inf

    def see(self, sightings: tuple[Sighting, ...], now: float) -> None:
        """Take in one frame of the tracking system, which arrives now [s]."""
        self.heard_at = now
        for seen in sightings:
            if seen.body not in self._bodies and len(self._bodies) >= _BODIES_MAX:
                continue
            points = self._bodies.setdefault(seen.body, deque())
            if points and seen.captured_at <= points[-1].at:
                continue
            points.append(TrackedPoint(seen.captured_at, seen.pose.position, seen.pose.yaw))
            while points[0].at < seen.captured_at - _KEPT_TIME:
                points.popleft()

    def hear(self, report: Telemetry | None) -> None:
        """Take in the drone's newest report; one that was heard before counts once."""
        if report is None or not (isfinite(report.psi) and isfinite(report.height)):
            return
        points = self._onboard
        if points and report.received_at <= points[-1].at:
            return
        points.append(OnboardPoint(report.received_at, report.psi, report.height))
        while points[0].at < report.received_at - _KEPT_TIME:
            points.popleft()

    def newest(self, body: str) -> TrackedPoint | None:
        """Return where a body was seen last, None when it never was."""
        points = self._bodies.get(body)
        return points[-1] if points else None

    @property
    def newest_onboard(self) -> OnboardPoint | None:
        """The drone's last report, None before the first."""
        return self._onboard[-1] if self._onboard else None

    def names(self, since: float) -> tuple[str, ...]:
        """Return the bodies that were seen since a time [s]."""
        return tuple(
            sorted(name for name, points in self._bodies.items() if points[-1].at >= since)
        )

    def track(self, began: float) -> CarryTrack:
        """Return what was said since a time [s]."""
        return CarryTrack(
            {
                name: tuple(point for point in points if point.at >= began)
                for name, points in self._bodies.items()
            },
            tuple(point for point in self._onboard if point.at >= began),
            self.heard_at,
        )
