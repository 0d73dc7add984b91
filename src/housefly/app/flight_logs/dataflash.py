"""ArduPilot's dataflash log, read with ``pymavlink``: EKF, attitude, battery, messages."""

from __future__ import annotations

import contextlib
import io
from collections.abc import Callable, Sequence
from math import isfinite, radians
from pathlib import Path
from typing import Any

from housefly.errors import MissingPartError, RecordingError
from housefly.messages import Severity
from housefly.record.flight_log import FlightLog, LogEvent, LogSamples, Quantity, on_one_time
from housefly.wires.mavlink.frames import across_attitude, across_world

DATAFLASH_MAGIC = b"\xa3\x95\x80"
_KIND = "ArduPilot dataflash log"

_Row = Callable[[Any], tuple[float, ...]]


def read_dataflash(path: Path) -> FlightLog:
    """Return a dataflash log; a cut one gives what is there, and says so.

    Raises:
        RecordingError: it is damaged, or holds no pose.
        MissingPartError: without ``pymavlink``.
    """
    try:
        from pymavlink.DFReader import DFReader_binary
    except ModuleNotFoundError as error:
        raise MissingPartError("pymavlink (dataflash)", "pip install 'housefly[logs]'") from error
    size = path.stat().st_size
    samples = [LogSamples(quantity) for quantity, _, _ in _SOURCES]
    modes: list[LogEvent] = []
    read, end = 0, 0
    said = io.StringIO()
    try:
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            log = DFReader_binary(str(path))
            while (message := log.recv_msg()) is not None:
                read, end = read + 1, int(log.offset)
                _take(message, samples, modes)
    except Exception as error:  # whatever a damaged file makes the library raise
        if not read:
            raise RecordingError(f"{path} cannot be read as {_KIND}: {error}") from error
    problems = []
    if end < size:
        problems.append(
            f"cut off or damaged after {read} messages, {end} of {size} bytes: what comes later is"
            " not here"
        )
    used, sources = _first_of_each(samples)
    return on_one_time(_KIND, used, events=modes, sources=sources, problems=problems)


def _take(message: Any, samples: list[LogSamples], events: list[LogEvent]) -> None:
    kind = message.get_type()
    at = getattr(message, "TimeUS", None)
    if at is None:
        return
    seconds = float(at) / 1e6
    if kind == "MSG":
        events.append(LogEvent(seconds, Severity.INFO, str(message.Message)))
    elif kind == "ERR":
        words = f"error of subsystem {message.Subsys}: code {message.ECode}"
        events.append(LogEvent(seconds, Severity.FAULT, words))
    for into, (_, name, row) in zip(samples, _SOURCES, strict=True):
        if name == kind and getattr(message, "C", 0) == 0:
            with contextlib.suppress(AttributeError):
                values = row(message)
                if all(map(isfinite, values)):
                    into.add(seconds, *values)


def _first_of_each(
    samples: Sequence[LogSamples],
) -> tuple[list[LogSamples], dict[Quantity, str]]:
    """Return the samples of the first message that tells each quantity."""
    used: dict[Quantity, LogSamples] = {}
    sources: dict[Quantity, str] = {}
    for one, (quantity, name, _) in zip(samples, _SOURCES, strict=True):
        if one.times and quantity not in used:
            used[quantity], sources[quantity] = one, name
    return list(used.values()), sources


def _place(one: Any) -> tuple[float, ...]:
    return across_world((one.PN, one.PE, one.PD))


def _velocity(one: Any) -> tuple[float, ...]:
    return across_world((one.VN, one.VE, one.VD))


def _attitude(one: Any) -> tuple[float, ...]:
    return across_attitude((radians(one.Roll), radians(one.Pitch), radians(one.Yaw)))


_SOURCES: Sequence[tuple[Quantity, str, _Row]] = (
    (Quantity.POSITION, "XKF1", _place),
    (Quantity.POSITION, "NKF1", _place),
    (Quantity.VELOCITY, "XKF1", _velocity),
    (Quantity.VELOCITY, "NKF1", _velocity),
    (Quantity.ATTITUDE, "ATT", _attitude),
    (Quantity.ATTITUDE, "XKF1", _attitude),
    (Quantity.BATTERY, "BAT", lambda one: (one.RemPct / 100.0,)),
)
"""Which message tells a quantity; of one quantity the first that is there counts."""
