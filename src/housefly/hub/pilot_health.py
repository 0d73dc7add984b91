"""How tracking and drone do, as the pilot's steps show it: rates and ages beside those of the
room's other sensors.
"""

from __future__ import annotations

import threading
from math import inf

from housefly.clock import Clock
from housefly.messages import PilotStep
from housefly.sensors.contracts import SensorHealth
from housefly.sensors.pulse import Pulse

SILENT = 1.0
"""Nothing heard for so long is a problem [s]."""


class PilotHealth:
    """Watches steps go by; safe from any thread.

    Args:
        tracking: id of the tracking system.
        clock: the monotonic clock that the pilot stamps with.
    """

    def __init__(self, tracking: str, clock: Clock) -> None:
        self._tracking, self._clock = tracking, clock
        self._lock = threading.Lock()
        self._steps, self._frames, self._reports = Pulse(), Pulse(), Pulse()
        self._captured = self._received = -inf
        self._told_at = -inf

    def heard(self, step: PilotStep) -> None:
        """Note one step."""
        telemetry = step.inputs.telemetry
        with self._lock:
            self._steps.beat(self._clock.now())
            for sighting in step.inputs.sightings:
                if sighting.captured_at > self._captured:
                    self._captured, self._received = sighting.captured_at, sighting.received_at
                    self._frames.beat(sighting.received_at)
            if telemetry is not None and telemetry.received_at > self._told_at:
                self._told_at = telemetry.received_at
                self._reports.beat(telemetry.received_at)

    def health(self) -> tuple[SensorHealth, ...]:
        """Return how tracking and drone do."""
        now = self._clock.now()
        with self._lock:
            pilot = self._steps.age(now)
            rows = (
                (
                    self._tracking,
                    "mocap",
                    "motion capture",
                    self._frames,
                    "no body is seen; is the tracking system live?",
                ),
                (
                    "drone",
                    "drone",
                    "the drone's own report",
                    self._reports,
                    "the drone is silent; is it switched on?",
                ),
            )
            return tuple(
                _health(
                    name,
                    kind,
                    title,
                    pulse,
                    now,
                    words if pilot < SILENT else "the pilot is not heard",
                )
                for name, kind, title, pulse, words in rows
            )


def _health(name: str, kind: str, title: str, pulse: Pulse, now: float, words: str) -> SensorHealth:
    age = pulse.age(now)
    well = age < SILENT
    return SensorHealth(name, kind, title, well, pulse.rate_hz(now), age, "" if well else words)
