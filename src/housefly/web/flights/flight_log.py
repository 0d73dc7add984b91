"""What is kept of a flight so that anybody can look at it again: one JSON object a line.

The first line is the head, the last the end; between them stand samples, changes of what the drone
was doing, paths and the lines of the log, each with its time since the start of the flight [s].
Pictures are not in it, and neither is anybody but the drone.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from housefly.errors import RecordingError
from housefly.messages import Phase, SafetyMode, Severity
from housefly.messages.words import Words

FLIGHT_ID = re.compile(r"\d{8}T\d{9}Z")
"""Date and time of the start in UTC, to the millisecond."""
SAMPLE_PERIOD = 0.1
"""Time between two samples [s]."""
DURATION_MAX = 2400.0
"""A log is not longer [s]; no battery is."""
METRES_MAX = 1e4
"""No room is larger [m]."""
LINES_MAX, LINE_SIZE_MAX = 40_000, 200_000
"""More lines, or longer ones [bytes], are no flight's."""
TEXT_MAX, NAME_MAX, POINTS_MAX = 1000, 120, 2000
"""Characters of a line of the log and of a goal's name; points of a path."""

_LINE = re.compile(r'\{"(\w+)":(\{.*\})\}\s*', re.DOTALL)
_STRICT = ConfigDict(extra="forbid", allow_inf_nan=False)
_Elapsed = Annotated[float, Field(ge=0.0, le=DURATION_MAX + 60.0)]
_Metres = Annotated[float, Field(ge=-METRES_MAX, le=METRES_MAX)]
_Place = tuple[_Metres, _Metres, _Metres]


@dataclass(frozen=True, slots=True)
class FlightHead:
    """Whose flight it was, and when it began [Unix time, s]."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    version: Annotated[int, Field(ge=1, le=1)]
    site: Annotated[str, Field(max_length=NAME_MAX)]
    started_at: Annotated[float, Field(ge=0.0, le=1e11)]


@dataclass(frozen=True, slots=True)
class LoggedPose:
    """Where the drone was: place [m], heading [rad], speed [m/s]; None where nobody saw it.

    Attributes:
        t: time since the start [s].
        battery: charge, 0 to 1.
    """

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    t: _Elapsed
    place: _Place | None
    yaw: Annotated[float, Field(ge=-10.0, le=10.0)]
    speed: Annotated[float, Field(ge=0.0, le=100.0)]
    battery: Annotated[float, Field(ge=0.0, le=1.0)]


@dataclass(frozen=True, slots=True)
class LoggedStage:
    """What the drone is doing from a time [s] on."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    t: _Elapsed
    phase: Phase
    safety: SafetyMode
    goal: Annotated[str, Field(max_length=NAME_MAX)]


@dataclass(frozen=True, slots=True)
class FlightPath:
    """The path in use from a time [s] on; empty when there is none.

    Attributes:
        waypoints: [m].
        heights, times, speeds: planned there [m, s, m/s]; empty of a path in the plane.
    """

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    t: _Elapsed
    waypoints: Annotated[tuple[tuple[_Metres, _Metres], ...], Field(max_length=POINTS_MAX)]
    heights: Annotated[tuple[_Metres, ...], Field(max_length=POINTS_MAX)]
    times: Annotated[tuple[float, ...], Field(max_length=POINTS_MAX)]
    speeds: Annotated[tuple[float, ...], Field(max_length=POINTS_MAX)]


@dataclass(frozen=True, slots=True)
class FlightNote:
    """A line of the log."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    t: _Elapsed
    severity: Severity
    code: Annotated[str, Field(max_length=NAME_MAX)]
    text: Annotated[Words, Field(max_length=TEXT_MAX)]


@dataclass(frozen=True, slots=True)
class FlightEnd:
    """How it ended: when [s], where it was sent first, and the worst that the log says."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    t: _Elapsed
    goal: Annotated[str, Field(max_length=NAME_MAX)]
    worst: Severity


Line = FlightHead | LoggedPose | LoggedStage | FlightPath | FlightNote | FlightEnd

_KINDS: dict[str, type[Any]] = {
    "flight": FlightHead,
    "sample": LoggedPose,
    "stage": LoggedStage,
    "path": FlightPath,
    "note": FlightNote,
    "end": FlightEnd,
}
_ADAPTERS = {name: TypeAdapter(kind) for name, kind in _KINDS.items()}
_NAMES = {kind: name for name, kind in _KINDS.items()}


def line_text(line: Line) -> str:
    """Return a line of a log as it is kept."""
    name = _NAMES[type(line)]
    body = _ADAPTERS[name].dump_json(line).decode()
    return f'{{"{name}":{body}}}\n'


def parsed_line(text: str) -> Line:
    """Return what a kept line says; raises RecordingError for anything else."""
    told = _LINE.fullmatch(text)
    adapter = _ADAPTERS.get(told[1]) if told else None
    try:
        if told is not None and adapter is not None:
            line: Line = adapter.validate_json(told[2], strict=True)
            return line
    except ValidationError as error:
        raise RecordingError(f"not a line of a flight's log: {text[:60]!r}") from error
    raise RecordingError(f"not a line of a flight's log: {text[:60]!r}")
