"""CSV of a Crazyflie's log variables, as the makers' client and scripts write it."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping, Sequence
from math import isfinite, radians
from pathlib import Path

from housefly.errors import RecordingError
from housefly.record.flight_log import FlightLog, LogSamples, Quantity, on_one_time

_KIND = "Crazyflie CSV"
_TIMES: Mapping[str, float] = {
    "timestamp": 1e-3, "time_ms": 1e-3, "tick": 1e-3, "time": 1.0, "t": 1.0, "time_s": 1.0,
}  # fmt: skip
"""Names of the column of the time, and what one of its units is [s]."""
_Row = Callable[..., tuple[float, ...]]


def is_crazyflie_csv(head: str) -> bool:
    """Return whether a first line names the time and a Crazyflie's log variables."""
    names = _names(head.split(","))
    return _time_column(names) is not None and any(
        column in names for _, columns, _ in _SOURCES for column in columns
    )


def read_crazyflie_csv(path: Path) -> FlightLog:
    """Return a table of log variables as a log; names are the firmware's: ``stateEstimate.x``.

    Times are milliseconds where the column is called timestamp or tick, seconds where it is called
    time or t. A row that is cut or is no number is counted and left out.

    Raises:
        RecordingError: it cannot be read, or holds no pose.
    """
    try:
        with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
            table = list(csv.reader(file, skipinitialspace=True))
    except (OSError, csv.Error) as error:
        raise RecordingError(f"{path} cannot be read as {_KIND}: {error}") from error
    names = _names(table[0]) if table else []
    clock = _time_column(names)
    if clock is None:
        raise RecordingError(
            f"{path}: no column of the time; one of {', '.join(_TIMES)} is looked for"
        )
    column, unit = clock
    samples: dict[Quantity, tuple[LogSamples, str]] = {}
    left_out = 0
    for row in table[1:]:
        at = _number(row, column)
        if at is None:
            left_out += 1
            continue
        for quantity, columns, read in _SOURCES:
            if not all(one in names for one in columns):
                continue
            known = samples.setdefault(quantity, (LogSamples(quantity), ", ".join(columns)))
            if known[1] != ", ".join(columns):
                continue
            values = [_number(row, names.index(one)) for one in columns]
            if None not in values:
                known[0].add(at * unit, *read(*values))
    problems = []
    if left_out:
        problems.append(f"{left_out} of {len(table) - 1} rows hold no time and are left out")
    return on_one_time(
        _KIND,
        [one for one, _ in samples.values()],
        sources={quantity: columns for quantity, (_, columns) in samples.items()},
        problems=problems,
    )


def _names(cells: Sequence[str]) -> list[str]:
    return [cell.strip().strip('"').lower() for cell in cells]


def _time_column(names: Sequence[str]) -> tuple[int, float] | None:
    for name, unit in _TIMES.items():
        if name in names:
            return names.index(name), unit
    return None


def _number(row: Sequence[str], column: int) -> float | None:
    try:
        value = float(row[column])
    except (ValueError, IndexError):
        return None
    return value if isfinite(value) else None


def _as_it_is(*values: float) -> tuple[float, ...]:
    return values


def _attitude(roll: float, pitch: float, yaw: float) -> tuple[float, ...]:
    """Return degrees as radians; the firmware's pitch is positive with the nose up."""
    return radians(roll), -radians(pitch), radians(yaw)


def _place_and_yaw(x: float, y: float, z: float, yaw: float) -> tuple[float, ...]:
    return x, y, z, radians(yaw)


def _share(percent: float) -> tuple[float, ...]:
    return (percent / 100.0,)


_SOURCES: Sequence[tuple[Quantity, tuple[str, ...], _Row]] = (
    (
        Quantity.POSITION,
        ("stateestimate.x", "stateestimate.y", "stateestimate.z"),
        _as_it_is,
    ),
    (Quantity.POSITION, ("kalman.statex", "kalman.statey", "kalman.statez"), _as_it_is),
    (
        Quantity.VELOCITY,
        ("stateestimate.vx", "stateestimate.vy", "stateestimate.vz"),
        _as_it_is,
    ),
    (
        Quantity.ATTITUDE,
        ("stateestimate.roll", "stateestimate.pitch", "stateestimate.yaw"),
        _attitude,
    ),
    (Quantity.ATTITUDE, ("stabilizer.roll", "stabilizer.pitch", "stabilizer.yaw"), _attitude),
    (
        Quantity.WANTED,
        ("ctrltarget.x", "ctrltarget.y", "ctrltarget.z", "ctrltarget.yaw"),
        _place_and_yaw,
    ),
    (Quantity.BATTERY, ("pm.batterylevel",), _share),
)
"""Which columns tell a quantity; of one quantity the first that are there count."""
