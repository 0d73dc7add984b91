"""Health of the scanners and depth cameras that another process reads."""

from __future__ import annotations

import threading
from math import inf

from housefly.clock import Clock
from housefly.config.site import Site
from housefly.messages import SensorReport
from housefly.messages.words import Words
from housefly.sensors.contracts import SensorHealth

REPORT_TIMEOUT = 5.0
"""Reports come every second; after this time the reporting process counts as gone [s]."""
NO_REPORT = Words("nobody listens to it; is the perception process running?")


class SensorStatus:
    """Keeps the newest report of each sensor of a site; thread-safe.

    Args:
        site: its sensors; reports of others are ignored.
        clock: when reports arrive.
    """

    def __init__(self, site: Site, clock: Clock) -> None:
        kinds = [
            *((laser.name, "laser scanner") for laser in site.lasers),
            *((camera.name, "depth camera") for camera in site.depth_cameras),
        ]
        self._clock = clock
        self._lock = threading.Lock()
        self._newest = {
            name: (SensorReport(name, kind, False, 0.0, inf, NO_REPORT), clock.now())
            for name, kind in kinds
        }

    def update(self, report: SensorReport) -> None:
        """Store a report."""
        with self._lock:
            if report.id in self._newest:
                self._newest[report.id] = report, self._clock.now()

    def health(self) -> tuple[SensorHealth, ...]:
        """Return the health of each sensor."""
        now = self._clock.now()
        with self._lock:
            return tuple(_health(report, now - at) for report, at in self._newest.values())


def _health(report: SensorReport, elapsed: float) -> SensorHealth:
    title, age = f"{report.kind.capitalize()} {report.id}", report.age + elapsed
    if elapsed > REPORT_TIMEOUT:
        return SensorHealth(report.id, report.kind, title, False, 0.0, age, NO_REPORT)
    return SensorHealth(
        report.id, report.kind, title, report.connected, report.rate_hz, age, report.problem
    )
