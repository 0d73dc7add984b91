"""How the sensors do that another process listens to: the scanners and depth cameras of the site."""

from __future__ import annotations

import threading
from math import inf

from housefly.clock import Clock
from housefly.config.site import Site
from housefly.messages import SensorReport
from housefly.sensors.contracts import SensorHealth

SILENT = 5.0
"""Reports come every second; after this the process that listens is taken to be gone [s]."""
UNHEARD = "nobody listens to it; is the looker running?"


class SensorBoard:
    """Keeps the newest report of each sensor of a site; safe from any thread.

    Args:
        site: which sensors there are; of others nothing is kept.
        clock: when reports come.
    """

    def __init__(self, site: Site, clock: Clock) -> None:
        kinds = [
            *((laser.name, "laser scanner") for laser in site.lasers),
            *((camera.name, "depth camera") for camera in site.depth_cameras),
        ]
        self._clock = clock
        self._lock = threading.Lock()
        self._newest = {
            name: (SensorReport(name, kind, False, 0.0, inf, UNHEARD), clock.now())
            for name, kind in kinds
        }

    def heard(self, report: SensorReport) -> None:
        """Take a report."""
        with self._lock:
            if report.id in self._newest:
                self._newest[report.id] = report, self._clock.now()

    def health(self) -> tuple[SensorHealth, ...]:
        """Return how each sensor does."""
        now = self._clock.now()
        with self._lock:
            return tuple(_health(report, now - at) for report, at in self._newest.values())


def _health(report: SensorReport, elapsed: float) -> SensorHealth:
    title, age = f"{report.kind.capitalize()} {report.id}", report.age + elapsed
    if elapsed > SILENT:
        return SensorHealth(report.id, report.kind, title, False, 0.0, age, UNHEARD)
    return SensorHealth(
        report.id, report.kind, title, report.connected, report.rate_hz, age, report.problem
    )
