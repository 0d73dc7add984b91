"""One row of ROS-TMS's database (``tms_msg_db/Tmsdb``, as mongoexport writes it), checked; its
numbers for things and sensors.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from datetime import datetime, timedelta, timezone
from math import isfinite
from typing import Any

from housefly.geometry import Vec3
from housefly.hub.things.thing import Kind
from housefly.messages import Facts

JAPAN = 9 * 3600.0
"""ROS-TMS writes the wall clock of its room, without saying so [s east of UTC]."""
NEVER = "0000-00-00 00:00:00.000000"
"""The time of a row that no sensor wrote: what the catalogue says."""
BANDS: dict[int, Kind] = {
    1: Kind.PERSON, 2: Kind.ROBOT, 3: Kind.SENSOR, 4: Kind.STRUCTURE, 5: Kind.SPACE, 6: Kind.FURNITURE, 7: Kind.OBJECT,
}  # fmt: skip
"""What an id's thousands mean; from 8000 on there are tasks and states, which are no things."""
SOURCES: dict[int, str] = {
    3001: "vicon", 3002: "ics", 3003: "odometry", 3018: "irs", 3020: "bed", 3021: "whs1", 3501: "kalman_filter",
}  # fmt: skip
TEXTS = ("joint", "rfid", "extfile", "task", "note", "announce")
NUMBERS = ("offset_x", "offset_y", "offset_z", "weight", "probability")
NEEDED = ("id", "name", "x", "y", "z", "rr", "rp", "ry")


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


def parse_row(line: str, utc_offset: float = JAPAN) -> TmsRow:
    """Return the row of one line; raises ValueError in words."""
    try:
        tree = json.loads(line)
    except ValueError as error:
        raise ValueError(f"is no JSON ({error})") from error
    if not isinstance(tree, dict):
        raise ValueError("is no JSON object")
    missing = [name for name in NEEDED if name not in tree]
    if missing:
        raise ValueError(f"has no {', '.join(missing)}")
    texts: Facts = tuple((name, _text(tree, name)) for name in TEXTS)
    numbers: Facts = tuple((name, _number(tree, name)) for name in NUMBERS)
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


def line_of(row: TmsRow, utc_offset: float = JAPAN) -> str:
    """Return a row as a line of JSON with all fields of ROS-TMS."""
    extras = dict(row.extras)
    numbers = {name: extras.get(name, 0) for name in NUMBERS}
    texts = {name: extras.get(name, "") for name in TEXTS}
    when = (
        NEVER
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


def kind_of(number: int, type_: str = "") -> Kind:
    """Return what sort of thing a row is about: by its type, else by its number."""
    return Kind(type_) if type_ in Kind._value2member_map_ else BANDS[number // 1000]


def source_of(sensor: int) -> str:
    """Return the name of the source that a sensor's number means."""
    return SOURCES.get(sensor, f"tms-{sensor}")


def _zone(utc_offset: float) -> timezone:
    return timezone(timedelta(seconds=utc_offset))


def _time(text: str, utc_offset: float) -> float | None:
    if not text or text.startswith("0000"):
        return None
    try:
        return datetime.fromisoformat(text).replace(tzinfo=_zone(utc_offset)).timestamp()
    except ValueError as error:
        raise ValueError(
            f"time is {text!r}; allowed: {NEVER!r}, or like '2018-02-26T14:31:02.936504'"
        ) from error


def _id(tree: dict[str, Any]) -> int:
    number = _whole(tree, "id")
    if number // 1000 not in BANDS:
        raise ValueError(
            f"id is {number}: no thing (things have ids from {min(BANDS)}000 to {max(BANDS)}999)"
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
