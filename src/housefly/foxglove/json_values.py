"""What is told as JSON: plain numbers for plots, tasks and happenings for tables.

Times are Unix time [s]. What is not known is not in a message; Foxglove draws a gap there.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, fields
from enum import Enum
from math import isfinite
from types import UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints

_PLAIN: dict[type, str] = {bool: "boolean", int: "integer", float: "number", str: "string"}


@dataclass(frozen=True, slots=True)
class DroneNumbers:
    """One step of a pilot for plots and state transitions.

    Attributes:
        at: of the step.
        phase, behavior, safety: who is in charge, and of what.
        goal, reason: where it flies, why something holds it back.
        status, battery: of the drone; charge 0 to 1.
        x, y, z, yaw: estimate [m, rad].
        speed, vertical_speed: [m/s].
        wanted_x, wanted_y, wanted_z, wanted_yaw: reference [m, rad].
        position_std: one sigma in x and y [m].
        pose_age, telemetry_age: [s].
        late: how much later than planned the step ran [s].
    """

    at: float
    phase: str
    behavior: str
    safety: str
    goal: str
    reason: str
    late: float
    status: str | None = None
    battery: float | None = None
    x: float | None = None
    y: float | None = None
    z: float | None = None
    yaw: float | None = None
    speed: float | None = None
    vertical_speed: float | None = None
    wanted_x: float | None = None
    wanted_y: float | None = None
    wanted_z: float | None = None
    wanted_yaw: float | None = None
    position_std: float | None = None
    pose_age: float | None = None
    telemetry_age: float | None = None


@dataclass(frozen=True, slots=True)
class LinkNumbers:
    """Health of a pilot's wires and loop: rates [Hz], times [s], as in ``LinkStatus``."""

    at: float
    tracking_connected: bool
    drone_connected: bool
    video_connected: bool
    tracking_rate_hz: float
    telemetry_rate_hz: float
    video_rate_hz: float
    loop_p50_s: float
    loop_p99_s: float
    loop_max_s: float
    missed_ticks: int
    tracking_latency_s: float
    command_delay_s: float
    nis: float
    push: float
    load: float
    notes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TaskRow:
    """One task: what it does, how far it is and why, who wanted it."""

    id: int
    title: str
    service: str
    state: str
    words: str
    asked_by: str
    asked_at: float
    drone: str
    question: str | None = None


@dataclass(frozen=True, slots=True)
class HouseTasks:
    """The board of the tasks: open ones in the order in which they fly, ended ones newest first."""

    at: float
    mode: str
    records: bool
    tasks: tuple[TaskRow, ...]
    ended: tuple[TaskRow, ...]


@dataclass(frozen=True, slots=True)
class RoomHappening:
    """Something that happened in the room; confidence 0 to 1."""

    at: float
    kind: str
    thing: str
    cause: str
    source: str
    confidence: float
    words: str


@dataclass(frozen=True, slots=True)
class SituationRow:
    """An active situation: since when, confidence 0 to 1."""

    kind: str
    thing: str
    since: float
    confidence: float
    words: str


@dataclass(frozen=True, slots=True)
class RoomSituations:
    """What holds in the room now."""

    at: float
    situations: tuple[SituationRow, ...]


def to_json(value: Any) -> bytes:
    """Return one of these values as JSON, without what is not known."""
    return json.dumps(_known(asdict(value)), ensure_ascii=False, allow_nan=False).encode()


def json_schema(kind: type) -> dict[str, Any]:
    """Return the JSON schema of one of these types: one object, nothing referenced."""
    hints = get_type_hints(kind)
    required = [
        field.name
        for field in fields(kind)
        if not _is_optional(hints[field.name]) and hints[field.name] is not float
    ]
    return {
        "type": "object",
        "title": kind.__name__,
        "properties": {name: _schema(hint) for name, hint in hints.items()},
        "required": required,
    }


def _schema(hint: Any) -> dict[str, Any]:
    if _is_optional(hint):
        hint = next(part for part in get_args(hint) if part is not type(None))
    if get_origin(hint) is tuple:
        return {"type": "array", "items": _schema(get_args(hint)[0])}
    return {"type": _PLAIN[hint]} if hint in _PLAIN else json_schema(hint)


def _is_optional(hint: Any) -> bool:
    return get_origin(hint) in (Union, UnionType) and type(None) in get_args(hint)


def _known(value: Any) -> Any:
    """Return a value without ``None`` and numbers that JSON does not have; enums as their value."""
    if isinstance(value, dict):
        return {key: _known(one) for key, one in value.items() if _is_known(one)}
    if isinstance(value, tuple | list):
        return [_known(one) for one in value if _is_known(one)]
    return value.value if isinstance(value, Enum) else value


def _is_known(value: Any) -> bool:
    return value is not None and (not isinstance(value, float) or isfinite(value))
