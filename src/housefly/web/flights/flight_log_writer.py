"""Keeps a log of each flight while it is flown; nothing waits for the disk."""

from __future__ import annotations

import logging
import queue
import threading
import time
from collections.abc import Callable
from datetime import UTC, datetime
from math import hypot, isfinite
from pathlib import Path
from typing import Protocol

from housefly.config.durable import SyncPace, append_lines
from housefly.geometry import wrap_angle
from housefly.messages import DroneStatus, Estimate, PilotStep, Severity
from housefly.messages.words import literal
from housefly.web.flights.flight_log import (
    DURATION_MAX,
    METRES_MAX,
    NAME_MAX,
    POINTS_MAX,
    SAMPLE_PERIOD,
    TEXT_MAX,
    FlightEnd,
    FlightHead,
    FlightNote,
    FlightPath,
    Line,
    LoggedPose,
    LoggedStage,
    line_text,
)
from housefly.web.messages.server_messages import PathMessage

_LOG = logging.getLogger(__name__)
_SETTLING = 2.0
"""A flight is over when the drone has been on the ground for so long [s]."""
_WAITING = 4000
"""Lines that may wait for the disk; more are lost."""
_FLIGHTS_KEPT, _BYTES_KEPT = 300, 200 * 2**20
_GROUNDED = (DroneStatus.UNKNOWN, DroneStatus.LANDED, DroneStatus.EMERGENCY)
_SEVERITIES = tuple(Severity)


class FlightListener(Protocol):
    """Hears each step of the pilot; must return at once."""

    def hear(self, step: PilotStep, number: int, path: Callable[[], PathMessage]) -> None:
        """Take in a step, the number of the path in use, and what returns it."""
        ...


class FlightLogWriter:
    """Writes ``<id>.jsonl`` for each flight into a folder, and forgets the oldest.

    Args:
        folder: made when the first flight begins, mode 0700.
        site: name of the site.
        wall: the time now [Unix time, s].
    """

    def __init__(self, folder: Path, site: str, wall: Callable[[], float] = time.time) -> None:
        self._folder, self._site, self._wall = folder, site[:NAME_MAX], wall
        self._started: float | None = None
        self._grounded_at: float | None = None
        self._sampled_at = self._heard_at = 0.0
        self._path = -1
        self._stage: tuple[object, ...] = ()
        self._goal = ""
        self._worst = Severity.INFO
        self._waiting: queue.Queue[tuple[str, Line] | None] = queue.Queue(_WAITING)
        self._id = ""
        self._pace = SyncPace()
        self._thread = threading.Thread(target=self._run, name="flight-log", daemon=True)
        self._thread.start()

    def hear(self, step: PilotStep, number: int, path: Callable[[], PathMessage]) -> None:
        """Take in a step of the pilot; never waits."""
        telemetry = step.inputs.telemetry
        flies = telemetry is not None and telemetry.status not in _GROUNDED
        if self._started is None:
            if not flies:
                return
            self._begin(step.now)
        self._keep(step, number, path)
        self._grounded_at = None if flies else self._grounded_at or step.now
        is_down = self._grounded_at is not None and step.now - self._grounded_at >= _SETTLING
        if is_down or self._heard_at >= DURATION_MAX:
            self._end()

    def close(self) -> None:
        """Write what waits, for at most a second."""
        if self._started is not None:
            self._end()
        self._waiting.put(None)
        self._thread.join(timeout=1.0)

    def _begin(self, now: float) -> None:
        wall = self._wall()
        date = datetime.fromtimestamp(wall, UTC)
        self._id = f"{date:%Y%m%dT%H%M%S}{date.microsecond // 1000:03d}Z"
        self._started, self._grounded_at = now, None
        self._sampled_at, self._heard_at = -SAMPLE_PERIOD, 0.0
        self._path, self._stage, self._goal, self._worst = -1, (), "", Severity.INFO
        self._put(FlightHead(1, self._site, round(wall, 3)))

    def _end(self) -> None:
        self._put(FlightEnd(self._heard_at, self._goal, self._worst))
        self._started = None

    def _keep(self, step: PilotStep, number: int, path: Callable[[], PathMessage]) -> None:
        # A pilot that was started anew may have a clock that stands a little behind.
        t = round(step.now - (self._started or 0.0), 3)
        t = min(DURATION_MAX, max(self._heard_at, t))
        self._heard_at, out = t, step.outputs
        stage = (out.phase, out.safety, out.goal_name[:NAME_MAX])
        if stage != self._stage:
            self._stage = stage
            self._goal = self._goal or stage[2]
            self._put(LoggedStage(t, *stage))
        if number != self._path:
            self._path = number
            self._put(_path(t, path()))
        for event in out.events:
            self._worst = max(self._worst, event.severity, key=_SEVERITIES.index)
            text = event.text if len(event.text) <= TEXT_MAX else literal(event.text[:TEXT_MAX])
            self._put(FlightNote(t, event.severity, event.code, text))
        if t - self._sampled_at >= SAMPLE_PERIOD - 1e-3:
            self._sampled_at = t
            self._put(_sample(t, step))

    def _put(self, line: Line) -> None:
        try:
            self._waiting.put_nowait((self._id, line))
        except queue.Full:
            _LOG.error("the disk is too slow: the log of a flight lacks lines")

    def _run(self) -> None:
        while (one := self._waiting.get()) is not None:
            try:
                self._write(*one)
            except OSError as error:
                _LOG.error("%s cannot be written to: %s", self._folder, error.strerror)

    def _write(self, name: str, line: Line) -> None:
        if isinstance(line, FlightHead):
            self._folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            self._forget()
        is_edge = isinstance(line, FlightHead | FlightEnd)
        file = self._folder / f"{name}.jsonl"
        append_lines(file, [line_text(line).rstrip("\n")], sync=is_edge or self._pace.is_due())

    def _forget(self) -> None:
        """Remove the oldest logs beyond what is kept."""
        kept = 0
        for number, file in enumerate(sorted(self._folder.glob("*Z.jsonl"), reverse=True)):
            kept += file.stat().st_size
            if number >= _FLIGHTS_KEPT or kept > _BYTES_KEPT:
                file.unlink(missing_ok=True)


def _sample(t: float, step: PilotStep) -> LoggedPose:
    estimate, telemetry = step.outputs.estimate, step.inputs.telemetry
    battery = min(1.0, max(0.0, telemetry.battery)) if telemetry else 0.0
    if estimate is None or not _can_be_kept(estimate):
        return LoggedPose(t, None, 0.0, 0.0, round(battery, 3))
    x, y, z = (round(value, 3) for value in estimate.position)
    speed = min(100.0, hypot(*estimate.velocity))
    return LoggedPose(
        t, (x, y, z), round(wrap_angle(estimate.yaw), 3), round(speed, 3), round(battery, 3)
    )


def _can_be_kept(estimate: Estimate) -> bool:
    numbers = (*estimate.position, *estimate.velocity, estimate.yaw)
    return all(isfinite(number) and abs(number) <= METRES_MAX for number in numbers)


def _path(t: float, told: PathMessage) -> FlightPath:
    def short(values: tuple[float, ...]) -> tuple[float, ...]:
        return tuple(round(value, 3) for value in values[:POINTS_MAX])

    places = tuple((round(x, 3), round(y, 3)) for x, y in told.waypoints[:POINTS_MAX])
    return FlightPath(t, places, short(told.heights), short(told.times), short(told.speeds))
