"""PX4's ulog, read with ``pyulog``: local position, attitude, setpoints, battery, messages."""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from contextlib import redirect_stdout
from io import StringIO
from math import isfinite
from pathlib import Path
from typing import Any

from housefly.errors import MissingPartError, RecordingError
from housefly.geometry import euler_from_quaternion, normalized
from housefly.messages import Severity
from housefly.record.flight_log import FlightLog, LogEvent, LogSamples, Quantity, on_one_time
from housefly.wires.mavlink.frames import across_heading, across_orientation, across_world

ULOG_MAGIC = b"ULog\x01\x12\x35"
_KIND = "PX4 ulog"
_HEADER = 16
_MESSAGE_HEAD = struct.Struct("<HB")
_FAULT, _WARNING = ord("3"), ord("4")
"""Levels of the kernel's log: 3 is an error, 4 a warning."""

_Row = Callable[[dict[str, Any], int], tuple[float, ...]]


def read_ulog(path: Path) -> FlightLog:
    """Return a ulog as a log; a cut one gives what is there, and says so.

    Raises:
        RecordingError: it is no ulog, is damaged, or holds no pose.
        MissingPartError: without ``pyulog``.
    """
    try:
        from pyulog import ULog
    except ModuleNotFoundError as error:
        raise MissingPartError("pyulog (PX4 ulog)", "pip install 'housefly[logs]'") from error
    data = path.read_bytes()
    try:
        with redirect_stdout(StringIO()):  # the library prints what it thinks of a damaged file
            log = ULog(str(path), sorted({name for _, name, _ in _SOURCES}))
    except Exception as error:  # whatever a damaged file makes the library raise
        raise RecordingError(f"{path} cannot be read as {_KIND}: {error}") from error
    samples, sources = [], {}
    for quantity, name, row in _SOURCES:
        if quantity in sources:
            continue
        read = _samples(log, quantity, name, row)
        if read.times:
            samples.append(read)
            sources[quantity] = name
    events = [
        LogEvent(one.timestamp / 1e6, _severity(one.log_level), one.message)
        for one in log.logged_messages
    ]
    return on_one_time(
        _KIND, samples, events=events, sources=sources, problems=_problems(data, log)
    )


def _samples(log: Any, quantity: Quantity, name: str, row: _Row) -> LogSamples:
    samples = LogSamples(quantity)
    found: dict[str, Any] = next((one.data for one in log.data_list if one.name == name), {})
    try:
        for number, stamp in enumerate(found.get("timestamp", ())):
            values = row(found, number)
            if all(map(isfinite, values)):
                samples.add(float(stamp) / 1e6, *values)
    except KeyError:  # an older version of the message
        return LogSamples(quantity)
    return samples


def _of(*names: str) -> Callable[[dict[str, Any], int], tuple[float, ...]]:
    def read(data: dict[str, Any], number: int) -> tuple[float, ...]:
        return tuple(float(data[name][number]) for name in names)

    return read


def _world(*names: str) -> _Row:
    read = _of(*names)

    def row(data: dict[str, Any], number: int) -> tuple[float, ...]:
        x, y, z = read(data, number)
        return across_world((x, y, z))

    return row


def _wanted(*names: str) -> _Row:
    read = _of(*names)

    def row(data: dict[str, Any], number: int) -> tuple[float, ...]:
        x, y, z, yaw = read(data, number)
        return (*across_world((x, y, z)), across_heading(yaw))

    return row


def _attitude(data: dict[str, Any], number: int) -> tuple[float, ...]:
    w, x, y, z = _of("q[0]", "q[1]", "q[2]", "q[3]")(data, number)
    return euler_from_quaternion(across_orientation(normalized((w, x, y, z))))


_SOURCES: Sequence[tuple[Quantity, str, _Row]] = (
    (Quantity.POSITION, "vehicle_local_position", _world("x", "y", "z")),
    (Quantity.VELOCITY, "vehicle_local_position", _world("vx", "vy", "vz")),
    (Quantity.ATTITUDE, "vehicle_attitude", _attitude),
    (
        Quantity.WANTED,
        "trajectory_setpoint",
        _wanted("position[0]", "position[1]", "position[2]", "yaw"),
    ),
    (Quantity.WANTED, "vehicle_local_position_setpoint", _wanted("x", "y", "z", "yaw")),
    (Quantity.BATTERY, "battery_status", _of("remaining")),
)
"""Which message tells a quantity; of one quantity the first that is there counts."""


def _severity(level: int) -> Severity:
    if level <= _FAULT:
        return Severity.FAULT
    return Severity.WARNING if level == _WARNING else Severity.INFO


def _problems(data: bytes, log: Any) -> list[str]:
    """Return what is wrong with the file: where it is cut, what the logger could not keep."""
    problems = []
    end = _whole_until(data)
    if end < len(data):
        problems.append(
            f"cut off or damaged after {end} of {len(data)} bytes: what comes later is not here"
        )
    lost = sum(one.duration for one in log.dropouts) / 1e3
    if lost:
        problems.append(f"the logger itself lost {lost:.3g} s in {len(log.dropouts)} gaps")
    return problems


def _whole_until(data: bytes) -> int:
    """Return where the last whole message ends [bytes]."""
    at = _HEADER
    while at + _MESSAGE_HEAD.size <= len(data):
        size, _ = _MESSAGE_HEAD.unpack_from(data, at)
        if at + _MESSAGE_HEAD.size + size > len(data):
            break
        at += _MESSAGE_HEAD.size + size
    return at
