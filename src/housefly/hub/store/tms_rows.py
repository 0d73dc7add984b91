"""One checked row of ROS-TMS's database (``tms_msg_db/Tmsdb``), and its numbers for things."""

from __future__ import annotations

import json
from dataclasses import dataclass
from datetime import datetime, timedelta, timezone
from math import isfinite
from typing import Any

from housefly.geometry import Vec3
from housefly.hub.things.thing import ThingKind
from housefly.messages import Facts

JAPAN_UTC_OFFSET = 9 * 3600.0
"""ROS-TMS writes the local time of its room without a time zone [s east of UTC]."""
_NEVER = "0000-00-00 00:00:00.000000"
"""The time of a row that no sensor wrote: a row of the catalogue."""
KIND_BY_THOUSANDS: dict[int, ThingKind] = {
    1: ThingKind.PERSON,
    2: ThingKind.ROBOT,
    3: ThingKind.SENSOR,
    4: ThingKind.STRUCTURE,
    5: ThingKind.SPACE,
    6: ThingKind.FURNITURE,
    7: ThingKind.OBJECT,
}
"""Kind of thing by the thousands of its id; from 8000 on there are tasks and states."""
SENSOR_NAMES: dict[int, str] = {
    3001: "vicon", 3002: "ics", 3003: "odometry", 3018: "irs", 3020: "bed", 3021: "whs1",
    3501: "kalman_filter",
}  # fmt: skip
TEXT_FIELDS = ("joint", "rfid", "extfile", "task", "note", "announce")
NUMBER_FIELDS = ("offset_x", "offset_y", "offset_z", "weight", "probability")
_NEEDED = ("id", "name", "x", "y", "z", "rr", "rp", "ry")


@dataclass(frozen=True, slots=True)
class TmsRow:
    """One row.

    Attributes:
        time: when it was written [s, Unix time]; None for a row of the catalogue.
        id: number of the thing.
        name: of the thing.
        type: "person", "furniture" ...; often empty.
        position: [m].
        euler: rr, rp, ry [rad].
        place: number of the thing that contains it; 0 for none.
        sensor: number of the sensor that wrote it; 0 for none.
        state: 0 not there, 1 real, 2 simulated.
        etcdata: poses from which robots reach it.
        tag: spoken names, separated by ";".
        extras: other fields that are not empty, by their names there.
    """

    time: float | None
    id: int
    name: str
    type: str
    position: Vec3
    euler: Vec3
    place: int
    sensor: int
    state: int
    etcdata: str
    tag: str
    extras: Facts


def parse_row(line: str, utc_offset: float = JAPAN_UTC_OFFSET) -> TmsRow:
    """Parse one line; raises ValueError in words."""
    try:
        tree = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise ValueError(f"is no JSON ({error})") from error
    if not isinstance(tree, dict):
        raise ValueError("is no JSON object")
    missing = [name for name in _NEEDED if name not in tree]
    if missing:
        raise ValueError(f"has no {', '.join(missing)}")
    texts: Facts = tuple((name, _text(tree, name)) for name in TEXT_FIELDS)
    numbers: Facts = tuple((name, _number(tree, name)) for name in NUMBER_FIELDS)
    return TmsRow(
        time=_time(_text(tree, "time"), utc_offset),
        id=_id(tree),
        name=_text(tree, "name"),
        type=_text(tree, "type"),
        position=(_number(tree, "x"), _number(tree, "y"), _number(tree, "z")),
        euler=(_number(tree, "rr"), _number(tree, "rp"), _number(tree, "ry")),
        place=_whole(tree, "place"),
        sensor=_whole(tree, "sensor"),
        state=_whole(tree, "state"),
        etcdata=_text(tree, "etcdata"),
        tag=_text(tree, "tag"),
        extras=tuple((name, value) for name, value in (*texts, *numbers) if value),
    )


def line_of(row: TmsRow, utc_offset: float = JAPAN_UTC_OFFSET) -> str:
    """Return a row as a line of JSON with all fields of ROS-TMS."""
    extras = dict(row.extras)
    numbers = {name: extras.get(name, 0) for name in NUMBER_FIELDS}
    texts = {name: extras.get(name, "") for name in TEXT_FIELDS}
    when = (
        _NEVER
        if row.time is None
        else datetime.fromtimestamp(row.time, _zone(utc_offset)).strftime("%Y-%m-%dT%H:%M:%S.%f")
    )
    pose = dict(zip(("x", "y", "z", "rr", "rp", "ry"), (*row.position, *row.euler), strict=True))
    tree = {"time": when, "id": row.id, "name": row.name, "type": row.type} | pose | numbers | texts
    rest = {
        "etcdata": row.etcdata,
        "place": row.place,
        "sensor": row.sensor,
        "state": row.state,
        "tag": row.tag,
    }
    return json.dumps(tree | rest, ensure_ascii=False)


def tms_kind(number: int, type_: str = "") -> ThingKind:
    """Return the kind of a row's thing: by its type, else by its number."""
    return (
        ThingKind(type_)
        if type_ in ThingKind._value2member_map_
        else KIND_BY_THOUSANDS[number // 1000]
    )


def source_of(sensor: int) -> str:
    """Return the source name of a sensor's number."""
    return SENSOR_NAMES.get(sensor, f"tms-{sensor}")


def _zone(utc_offset: float) -> timezone:
    return timezone(timedelta(seconds=utc_offset))


def _time(text: str, utc_offset: float) -> float | None:
    if not text or text.startswith("0000"):
        return None
    try:
        return datetime.fromisoformat(text).replace(tzinfo=_zone(utc_offset)).timestamp()
    except ValueError as error:
        raise ValueError(
            f"time is {text!r}; allowed: {_NEVER!r}, or like '2018-02-26T14:31:02.936504'"
        ) from error


def _id(tree: dict[str, Any]) -> int:
    number = _whole(tree, "id")
    if number // 1000 not in KIND_BY_THOUSANDS:
        raise ValueError(
            f"id is {number}: no thing (things have ids from {min(KIND_BY_THOUSANDS)}000"
            f" to {max(KIND_BY_THOUSANDS)}999)"
        )
    return number


def _text(tree: dict[str, Any], name: str) -> str:
    value = tree.get(name, "")
    if not isinstance(value, str):
        raise ValueError(f"{name} is {value!r}; allowed: a text")
    return value


def _whole(tree: dict[str, Any], name: str) -> int:
    value = _number(tree, name)
    if value != int(value):
        raise ValueError(f"{name} is {value!r}; allowed: a whole number")
    return int(value)


def _number(tree: dict[str, Any], name: str) -> float:
    value = tree.get(name, 0.0)
    if isinstance(value, dict) and len(value) == 1:  # mongoexport's {"$numberLong": "7001"}
        value = next(iter(value.values()))
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(f"{name} is {value!r}; allowed: a number") from error
    if not isfinite(number):
        raise ValueError(f"{name} is {value!r}; allowed: a finite number")
    return number
