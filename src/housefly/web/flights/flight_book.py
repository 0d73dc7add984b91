"""The logs of flights that are kept: which there are, and one of them to look at again."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from housefly.errors import RecordingError
from housefly.messages import Severity
from housefly.web.flights.flight_log import (
    FLIGHT_ID,
    LINE_SIZE_MAX,
    LINES_MAX,
    FlightEnd,
    FlightHead,
    FlightNote,
    FlightPath,
    Line,
    LoggedPose,
    LoggedStage,
    parsed_line,
)

_LISTED = 300
_TAIL = 4096
"""The last line of a log is not longer [bytes]."""


@dataclass(frozen=True, slots=True)
class FlightView:
    """A flight that can be looked at again.

    Attributes:
        id: of its log.
        started_at: [Unix time, s].
        duration: [s].
        goal: where it was sent first, in words, or "".
        worst: the worst that its log says.
        complete: whether its end is in the log.
    """

    id: str
    started_at: float
    duration: float
    goal: str
    worst: Severity
    complete: bool


@dataclass(frozen=True, slots=True)
class FlightsView:
    """The flights that can be looked at again, newest first; now is the server's [Unix time, s]."""

    now: float
    flights: tuple[FlightView, ...]


@dataclass(frozen=True, slots=True)
class FlightReplay:
    """A flight to look at again.

    Attributes:
        flight: which.
        t: time of each sample since the start [s]; the following have one value for each.
        x, y, z: place [m]; None where nobody saw the drone.
        yaw: heading [rad].
        speed: [m/s].
        battery: charge, 0 to 1.
        stages, paths, notes: in order of their times.
    """

    flight: FlightView
    t: tuple[float, ...]
    x: tuple[float | None, ...]
    y: tuple[float | None, ...]
    z: tuple[float | None, ...]
    yaw: tuple[float, ...]
    speed: tuple[float, ...]
    battery: tuple[float, ...]
    stages: tuple[LoggedStage, ...]
    paths: tuple[FlightPath, ...]
    notes: tuple[FlightNote, ...]


class FlightBook:
    """Reads the logs of a folder; what was not written as a log is refused in words.

    Args:
        folder: of the logs; need not exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def flights(self) -> tuple[FlightView, ...]:
        """Return which there are, newest first; a damaged one is left out."""
        names = sorted((one.stem for one in self._folder.glob("*.jsonl")), reverse=True)
        found = (self._view(name) for name in names[:_LISTED] if FLIGHT_ID.fullmatch(name))
        return tuple(one for one in found if one is not None)

    def replay(self, name: str) -> FlightReplay:
        """Return one; raises RecordingError when there is none of that name, or it is damaged."""
        lines = list(self._lines(name))
        if not lines or not isinstance(lines[0], FlightHead):
            raise RecordingError(f"the log of flight {name} has no beginning")
        samples = [line for line in lines if isinstance(line, LoggedPose)]
        ends = [line for line in lines if isinstance(line, FlightEnd)]
        times = [line.t for line in lines[1:] if not isinstance(line, FlightHead)]
        if times != sorted(times):
            raise RecordingError(f"the log of flight {name} is damaged: its times go back")
        notes = tuple(line for line in lines if isinstance(line, FlightNote))
        stages = tuple(line for line in lines if isinstance(line, LoggedStage))
        places = [one.place or (None, None, None) for one in samples]
        end = ends[-1] if ends else None
        view = FlightView(
            name,
            lines[0].started_at,
            times[-1] if times else 0.0,
            end.goal if end else next((one.goal for one in stages if one.goal), ""),
            end.worst if end else _worst(notes),
            end is not None,
        )
        return FlightReplay(
            flight=view,
            t=tuple(one.t for one in samples),
            x=tuple(place[0] for place in places),
            y=tuple(place[1] for place in places),
            z=tuple(place[2] for place in places),
            yaw=tuple(one.yaw for one in samples),
            speed=tuple(one.speed for one in samples),
            battery=tuple(one.battery for one in samples),
            stages=stages,
            paths=tuple(line for line in lines if isinstance(line, FlightPath)),
            notes=notes,
        )

    def _lines(self, name: str) -> Iterator[Line]:
        """Yield the lines of a log; one that was cut off at the end counts for nothing."""
        if not FLIGHT_ID.fullmatch(name):
            raise RecordingError(f"there is no flight {name[:40]!r}")
        try:
            flags = os.O_RDONLY | os.O_NOFOLLOW
            file = os.fdopen(os.open(self._folder / f"{name}.jsonl", flags), "rb")
        except OSError as error:
            raise RecordingError(f"there is no flight {name!r}: {error.strerror}") from error
        with file:
            rows = iter(lambda: file.readline(LINE_SIZE_MAX + 1), b"")
            for number, row in enumerate(islice(rows, LINES_MAX + 1), 1):
                if number > LINES_MAX or len(row) > LINE_SIZE_MAX:
                    raise RecordingError(f"the log of flight {name} is too long: no flight's is")
                if not row.endswith(b"\n"):
                    return
                try:
                    yield parsed_line(row.decode())
                except (RecordingError, UnicodeDecodeError) as error:
                    words = f"the log of flight {name} is damaged in line {number}"
                    raise RecordingError(words) from error

    def _view(self, name: str) -> FlightView | None:
        """Return what is listed of a log, by its first and its last line."""
        try:
            flags = os.O_RDONLY | os.O_NOFOLLOW
            descriptor = os.open(self._folder / f"{name}.jsonl", flags)
            with os.fdopen(descriptor, "rb") as file:
                head = parsed_line(file.readline(_TAIL).decode())
                file.seek(max(0, os.fstat(file.fileno()).st_size - _TAIL))
                last = [row for row in file.read(_TAIL).split(b"\n")[:-1] if row][-1]
            end = parsed_line(last.decode())
        except (OSError, RecordingError, UnicodeDecodeError, IndexError):
            return None
        if not isinstance(head, FlightHead) or isinstance(end, FlightHead):
            return None
        if isinstance(end, FlightEnd):
            return FlightView(name, head.started_at, end.t, end.goal, end.worst, True)
        return FlightView(name, head.started_at, end.t, "", Severity.INFO, False)


def _worst(notes: tuple[FlightNote, ...]) -> Severity:
    order = tuple(Severity)
    return max((one.severity for one in notes), key=order.index, default=Severity.INFO)
