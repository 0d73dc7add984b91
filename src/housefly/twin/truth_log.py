"""The true course of a flight, written to a file: where the drone was, what it touched.

One JSON object a line: samples at 50 Hz, and each contact when it begins and again at the end. It
is for the summary of a flight, never for the pilot, and nothing waits for it or ends with it: on a
full disk it ends, and says so.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from math import isfinite
from pathlib import Path
from typing import Protocol, TextIO

from housefly.config.process_log import log_line
from housefly.twin.clearance import Clearance
from housefly.twin.contact_log import Contact
from housefly.twin.contracts import GroundTruth, OnboardState

TRUTH_RATE_HZ = 50.0
_FLUSH_EVERY = 25
"""Samples between two flushes: a killed process loses at most half a second."""


class ScoredDrone(Protocol):
    """What is known for certain of a drone of the simulated room."""

    @property
    def now(self) -> float:
        """World time [s]."""
        ...

    @property
    def contact_log(self) -> tuple[Contact, ...]:
        """What it touched so far, in order of time."""
        ...

    def truth(self) -> GroundTruth:
        """Return the true state now."""
        ...

    def onboard(self) -> OnboardState:
        """Return what the firmware believes now."""
        ...

    def clearance(self) -> Clearance:
        """Return how far the hull is from what it can touch."""
        ...


class TruthLog:
    """Writes the true course of one drone; ``close`` writes the end of it.

    Args:
        drone: whose course.
        path: of the file; what an earlier process wrote is kept.
        clock: stamps the samples, as the pilot's steps are stamped [s].
        report: takes a line when the file can be written no longer.
    """

    def __init__(
        self,
        drone: ScoredDrone,
        path: Path,
        clock: Callable[[], float],
        report: Callable[[str], None] = log_line,
    ) -> None:
        self._drone, self._clock = drone, clock
        self._path, self._report = path, report
        self._file: TextIO | None = None
        with self._ending():
            self._file = path.open("a", encoding="utf-8")
        self._due = 0.0
        self._samples = 0
        self._told = 0

    def sample(self) -> None:
        """Write a sample when it is due, and the contacts that are new."""
        now = self._drone.now
        if now < self._due or self._file is None:
            return
        self._due = now + 1.0 / TRUTH_RATE_HZ - 1e-6
        at = self._clock()
        truth, clearance = self._drone.truth(), self._drone.clearance()
        self._write(
            {
                "at": round(at, 6),
                "position": [round(value, 5) for value in truth.pose.position],
                "airborne": self._drone.onboard().flight.airborne,
                "solid": _finite(clearance.solid),
                "person": _finite(clearance.person),
                "drone": _finite(clearance.drone),
                "leds": truth.leds,
            }
        )
        for contact in self._drone.contact_log[self._told :]:
            self._write(_line(contact, at - now))
            self._told += 1
        self._samples += 1
        if self._samples % _FLUSH_EVERY == 0:
            with self._ending():
                self._file.flush()

    def close(self) -> None:
        """Write how long each contact lasted, and close the file."""
        if self._file is None:
            return
        offset = self._clock() - self._drone.now
        for contact in self._drone.contact_log:
            self._write(_line(contact, offset))
        file, self._file = self._file, None
        with self._ending():
            file.close()

    def _write(self, values: dict[str, object]) -> None:
        with self._ending():
            if self._file is not None:
                self._file.write(json.dumps(values, allow_nan=False) + "\n")

    @contextmanager
    def _ending(self) -> Iterator[None]:
        """Write no more, and say why, where the disk refuses."""
        try:
            yield
        except OSError as error:
            file, self._file = self._file, None
            with suppress(OSError):
                if file is not None:
                    file.close()
            self._report(
                f"twin: the true course of this flight is not written any further: {self._path}:"
                f" {error.strerror}"
            )


def _line(contact: Contact, offset: float) -> dict[str, object]:
    return {
        "contact": contact.name,
        "kind": contact.kind.value,
        "began": contact.began_at,
        "at": round(contact.began_at + offset, 3),
        "duration": round(contact.ended_at - contact.began_at, 3),
        "speed": round(contact.speed, 3),
        "height": round(contact.height, 3),
        "motors": contact.motors_turned,
    }


def _finite(value: float) -> float | None:
    return round(value, 5) if isfinite(value) else None
