"""Health of tracking and drone, from the pilot's steps."""

from __future__ import annotations

import threading
from math import inf

from housefly.clock import Clock
from housefly.config.drone import DRONE_NAME
from housefly.messages import PilotStep, Sighting
from housefly.messages.words import UNSAID, Words
from housefly.sensors.contracts import SensorHealth
from housefly.sensors.message_rate import MessageRate

_NO_PILOT = Words("the pilot is not heard")
_SILENT_AFTER = 1.0
"""A source silent for longer is a problem [s]."""


class PilotHealth:
    """Measures rates and ages from tracking's frames and the pilot's steps; thread-safe.

    Args:
        tracking: id of the tracking system; "" where there is none.
        clock: the monotonic clock of the pilot's stamps.
        drone: id of the drone; "" where there is no pilot with its drone.
    """

    def __init__(self, tracking: str, clock: Clock, drone: str = DRONE_NAME) -> None:
        self._tracking, self._clock, self._drone = tracking, clock, drone
        self._lock = threading.Lock()
        self._steps, self._frames, self._reports = MessageRate(), MessageRate(), MessageRate()
        self._telemetry_at = -inf

    def update(self, step: PilotStep) -> None:
        """Add one step."""
        telemetry = step.inputs.telemetry
        with self._lock:
            self._steps.add(self._clock.now())
            if telemetry is not None and telemetry.received_at > self._telemetry_at:
                self._telemetry_at = telemetry.received_at
                self._reports.add(telemetry.received_at)

    def update_frame(self, sightings: tuple[Sighting, ...]) -> None:
        """Add a frame of tracking; it may show no body."""
        with self._lock:
            self._frames.add(max((one.received_at for one in sightings), default=self._clock.now()))

    def health(self) -> tuple[SensorHealth, ...]:
        """Return the health of tracking and drone, as far as there are any."""
        now = self._clock.now()
        with self._lock:
            pilot = self._steps.age(now)
            rows = (
                (
                    self._tracking,
                    "mocap",
                    "motion capture",
                    self._frames,
                    Words("no body is seen; is the tracking system live?"),
                ),
                (
                    self._drone,
                    "drone",
                    "the drone's own report",
                    self._reports,
                    Words("the drone is silent; is it switched on?"),
                ),
            )
            return tuple(
                _health(
                    name,
                    kind,
                    title,
                    rate,
                    now,
                    words if pilot < _SILENT_AFTER or not self._drone else _NO_PILOT,
                )
                for name, kind, title, rate, words in rows
                if name
            )


def _health(
    name: str, kind: str, title: str, rate: MessageRate, now: float, words: Words
) -> SensorHealth:
    age = rate.age(now)
    well = age < _SILENT_AFTER
    return SensorHealth(name, kind, title, well, rate.rate_hz(now), age, UNSAID if well else words)
