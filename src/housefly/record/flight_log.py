"""A flight that others recorded, as arrays on one time: pose, velocity, attitude, what was wanted.

Axes are ours: the world's z is up, a heading is counter-clockwise from x, pitch is positive with
the nose down.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum

import numpy as np

from housefly.errors import RecordingError
from housefly.messages import Severity
from housefly.numeric import FloatArray


class Quantity(Enum):
    """What a log may hold: its words, number of columns, and how long a value is believed [s]."""

    POSITION = ("position", 3, 0.5)
    VELOCITY = ("velocity", 3, 0.5)
    ATTITUDE = ("attitude (roll, pitch, yaw)", 3, 0.5)
    WANTED = ("position setpoints", 4, 30.0)
    WANTED_VELOCITY = ("velocity setpoints", 4, 1.0)
    BATTERY = ("battery", 1, 60.0)

    @property
    def words(self) -> str:
        """What it is called."""
        return str(self.value[0])

    @property
    def columns(self) -> int:
        """How many numbers a sample has."""
        return int(self.value[1])

    @property
    def held(self) -> float:
        """How long a sample counts as the newest [s]."""
        return float(self.value[2])


@dataclass(slots=True)
class LogSamples:
    """Samples of one quantity as they come: times [s], and their numbers."""

    quantity: Quantity
    times: list[float] = field(default_factory=list)
    values: list[tuple[float, ...]] = field(default_factory=list)

    def add(self, at: float, *values: float) -> None:
        """Add one sample."""
        self.times.append(at)
        self.values.append(values)


@dataclass(frozen=True, slots=True)
class LogEvent:
    """What a log says in words, at a time on the log's own clock [s]."""

    at: float
    severity: Severity
    text: str


@dataclass(frozen=True, slots=True, eq=False)
class FlightLog:
    """One log; what is not known at a time is nan.

    Attributes:
        kind: of the file, in words.
        time: of each row since the first [s], shape (n,).
        position: x, y, z [m], shape (n, 3).
        velocity: in the world [m/s], shape (n, 3).
        attitude: roll, pitch, yaw [rad], shape (n, 3).
        wanted: x, y, z [m] and yaw [rad] that were asked for, shape (n, 4).
        wanted_velocity: x, y, z [m/s] and yaw rate [rad/s], shape (n, 4).
        battery: charge 0 to 1, shape (n,).
        events: on the time of the rows.
        started_at: Unix time of the first row [s]; None where the log does not say.
        sources: which topic or message each quantity is from.
        lacks: quantities that the file does not hold, in words.
        problems: what is wrong with the file, in words.
    """

    kind: str
    time: FloatArray
    position: FloatArray
    velocity: FloatArray
    attitude: FloatArray
    wanted: FloatArray
    wanted_velocity: FloatArray
    battery: FloatArray
    events: tuple[LogEvent, ...]
    started_at: float | None
    sources: Mapping[str, str]
    lacks: tuple[str, ...]
    problems: tuple[str, ...]


def on_one_time(
    kind: str,
    samples: Sequence[LogSamples],
    *,
    events: Sequence[LogEvent] = (),
    started_at: float | None = None,
    sources: Mapping[Quantity, str] | None = None,
    problems: Sequence[str] = (),
) -> FlightLog:
    """Return samples as a log, a row at each time of its positions.

    Args:
        kind: of the file, in words.
        samples: each quantity once, in any order of time.
        events: on the same clock.
        started_at: Unix time at which that clock was zero [s].
        sources: where each quantity is from.
        problems: what is wrong with the file.

    Raises:
        RecordingError: there is no position and no attitude.
    """
    known = {one.quantity: _sorted(one) for one in samples if one.times}
    base = known.get(Quantity.POSITION) or known.get(Quantity.ATTITUDE)
    if base is None:
        raise RecordingError(f"this {kind} holds neither positions nor attitudes")
    times = np.unique(base[0])
    start = float(times[0])
    columns = {one: _held(known.get(one), one, times) for one in Quantity}
    return FlightLog(
        kind=kind,
        time=times - start,
        position=columns[Quantity.POSITION],
        velocity=columns[Quantity.VELOCITY],
        attitude=columns[Quantity.ATTITUDE],
        wanted=columns[Quantity.WANTED],
        wanted_velocity=columns[Quantity.WANTED_VELOCITY],
        battery=columns[Quantity.BATTERY][:, 0],
        events=tuple(
            LogEvent(one.at - start, one.severity, one.text)
            for one in sorted(events, key=lambda one: one.at)
        ),
        started_at=None if started_at is None else started_at + start,
        sources={one.words: named for one, named in (sources or {}).items() if one in known},
        lacks=tuple(one.words for one in Quantity if one not in known),
        problems=tuple(problems),
    )


def _sorted(samples: LogSamples) -> tuple[FloatArray, FloatArray]:
    times = np.array(samples.times, dtype=np.float64)
    values = np.array(samples.values, dtype=np.float64).reshape(-1, samples.quantity.columns)
    order = np.argsort(times, kind="stable")
    return times[order], values[order]


def _held(
    samples: tuple[FloatArray, FloatArray] | None, quantity: Quantity, at: FloatArray
) -> FloatArray:
    """Return the newest sample at each time, or nan before the first and where it is too old."""
    told = np.full((at.size, quantity.columns), np.nan)
    if samples is None:
        return told
    times, values = samples
    newest = np.searchsorted(times, at, side="right") - 1
    is_known = (newest >= 0) & (at - times[np.maximum(newest, 0)] <= quantity.held)
    told[is_known] = values[newest[is_known]]
    return told
