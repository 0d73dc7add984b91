"""ArduPilot's dataflash log: EKF, attitude, battery, messages."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isfinite, radians
from pathlib import Path

from housefly.app.flight_logs.dataflash_messages import DataflashMessage, dataflash_messages
from housefly.errors import RecordingError
from housefly.messages import Severity
from housefly.record.flight_log import FlightLog, LogEvent, LogSamples, Quantity, on_one_time
from housefly.wires.mavlink.frames import across_attitude, across_world

_KIND = "ArduPilot dataflash log"
_EVENTS_KEPT = 2000

_Row = Callable[[Mapping[str, float]], tuple[float, ...]]


def read_dataflash(path: Path) -> FlightLog:
    """Return a dataflash log; a cut one gives what is there, and says so.

    Raises:
        RecordingError: it cannot be read, or holds no pose.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise RecordingError(f"{path} cannot be read: {error.strerror}") from error
    samples = [LogSamples(quantity) for quantity, _, _ in _SOURCES]
    events: list[LogEvent] = []
    count = end = skipped = 0
    for message in dataflash_messages(data):
        count, end = count + 1, message.end
        skipped += message.skipped
        _take(message, samples, events)
    problems = []
    if skipped:
        problems.append(f"damaged: {skipped} of {len(data)} bytes could not be read")
    if end < len(data):
        problems.append(
            f"cut off or damaged after {count} messages, {end} of {len(data)} bytes: what comes"
            " later is not here"
        )
    used, sources = _first_of_each(samples)
    return on_one_time(_KIND, used, events=events, sources=sources, problems=problems)


def _take(message: DataflashMessage, samples: list[LogSamples], events: list[LogEvent]) -> None:
    stamp = message.fields.get("TimeUS")
    if not isinstance(stamp, int | float) or not isfinite(stamp):
        return
    at = stamp / 1e6
    if (event := _event(at, message)) is not None and len(events) < _EVENTS_KEPT:
        events.append(event)
    numbers = {key: one for key, one in message.fields.items() if not isinstance(one, str)}
    for into, (_, name, row) in zip(samples, _SOURCES, strict=True):
        if name == message.name and not numbers.get("C"):
            try:
                values = row(numbers)
            except KeyError:  # an older version of the message
                continue
            if all(map(isfinite, values)):
                into.add(at, *values)


def _event(at: float, message: DataflashMessage) -> LogEvent | None:
    fields = message.fields
    if message.name == "MSG":
        return LogEvent(at, Severity.INFO, str(fields.get("Message", "")))
    if message.name == "ERR":
        words = f"error of subsystem {fields.get('Subsys')}: code {fields.get('ECode')}"
        return LogEvent(at, Severity.FAULT, words)
    return None


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


def _place(one: Mapping[str, float]) -> tuple[float, ...]:
    return across_world((one["PN"], one["PE"], one["PD"]))


def _velocity(one: Mapping[str, float]) -> tuple[float, ...]:
    return across_world((one["VN"], one["VE"], one["VD"]))


def _attitude(one: Mapping[str, float]) -> tuple[float, ...]:
    return across_attitude((radians(one["Roll"]), radians(one["Pitch"]), radians(one["Yaw"])))


def _battery(one: Mapping[str, float]) -> tuple[float, ...]:
    return (one["RemPct"] / 100.0,)


_SOURCES: Sequence[tuple[Quantity, str, _Row]] = (
    (Quantity.POSITION, "XKF1", _place),
    (Quantity.POSITION, "NKF1", _place),
    (Quantity.VELOCITY, "XKF1", _velocity),
    (Quantity.VELOCITY, "NKF1", _velocity),
    (Quantity.ATTITUDE, "ATT", _attitude),
    (Quantity.ATTITUDE, "XKF1", _attitude),
    (Quantity.BATTERY, "BAT", _battery),
)
"""Which message tells a quantity; of one quantity the first that is there counts."""
