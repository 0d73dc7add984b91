"""Writes things and samples as rows of ROS-TMS's database, for mongoimport or ``import_tms``.

Each thing becomes a row of the catalogue, each sample a row of its sensor. A thing that did not
come from ROS-TMS gets a free number of its kind, an unknown source one from 3900 on.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import count

from housefly.geometry import Quaternion, Vec3, euler_from_quaternion
from housefly.hub.store.import_tms import TMS_PREFIX
from housefly.hub.store.tms_rows import (
    JAPAN_UTC_OFFSET,
    KIND_BY_THOUSANDS,
    NUMBER_FIELDS,
    SENSOR_NAMES,
    TEXT_FIELDS,
    TmsRow,
    line_of,
)
from housefly.hub.things.thing import NamedPose, Thing, ThingKind
from housefly.messages import Facts, Observation

_FIRST_FREE_SENSOR = 3900
_THOUSANDS = {kind: band for band, kind in KIND_BY_THOUSANDS.items()} | {ThingKind.PLACE: 5}
_SENSOR_NUMBERS = {name: number for number, name in SENSOR_NAMES.items()}


def tms_lines(
    things: Iterable[Thing], samples: Iterable[Observation], utc_offset: float = JAPAN_UTC_OFFSET
) -> Iterator[str]:
    """Yield the rows, the catalogue first.

    Args:
        things: the catalogue; samples of other things are left out.
        samples: observations.
        utc_offset: of the wall clock in the room that will read it [s east of UTC].
    """
    known = {thing.id: thing for thing in things}
    numbers = _numbered(known.values())
    sensors: dict[str, int] = {}
    free = count(_FIRST_FREE_SENSOR)
    for thing in known.values():
        yield line_of(_catalogue_row(thing, numbers), utc_offset)
    for sample in samples:
        if sample.thing in known:
            if sample.source not in sensors:
                sensors[sample.source] = _sensor(sample.source, free)
            yield line_of(
                _sample_row(sample, known[sample.thing], numbers, sensors[sample.source]),
                utc_offset,
            )


def _numbered(things: Iterable[Thing]) -> dict[str, int]:
    """Return the number of each thing: the one from ROS-TMS, else the next free one of its kind."""
    every = tuple(things)
    numbers = {
        thing.id: int(float(number))
        for thing in every
        if (number := dict(thing.facts).get(f"{TMS_PREFIX}id")) is not None
    }
    taken = set(numbers.values())
    for thing in every:
        if thing.id not in numbers:
            numbers[thing.id] = next(
                n for n in count(_THOUSANDS[thing.kind] * 1000 + 1) if n not in taken
            )
            taken.add(numbers[thing.id])
    return numbers


def _sensor(source: str, free: Iterator[int]) -> int:
    numbered = re.fullmatch(r"tms-(\d+)", source)
    return int(numbered[1]) if numbered else _SENSOR_NUMBERS.get(source) or next(free)


def _catalogue_row(thing: Thing, numbers: dict[str, int]) -> TmsRow:
    facts = dict(thing.facts)
    written_at = facts.get(f"{TMS_PREFIX}time")
    return TmsRow(
        time=float(written_at) if written_at else None,
        id=numbers[thing.id],
        name=thing.name,
        type=thing.kind.value,
        position=thing.position or (0.0, 0.0, 0.0),
        euler=_euler(thing.orientation),
        place=numbers.get(thing.inside, 0),
        sensor=int(float(facts.get(f"{TMS_PREFIX}sensor", 0))),
        state=int(float(facts.get(f"{TMS_PREFIX}state", 0))),
        etcdata=";".join(map(_approach, thing.viewpoints)),
        tag=";".join(thing.aliases),
        extras=_extras(thing.facts),
    )


def _sample_row(sample: Observation, thing: Thing, numbers: dict[str, int], sensor: int) -> TmsRow:
    state = int(float(dict(sample.facts).get(f"{TMS_PREFIX}state", 1))) if sample.valid else 0
    return TmsRow(
        time=sample.captured_at,
        id=numbers[thing.id],
        name=thing.name,
        type=thing.kind.value,
        position=sample.position or (0.0, 0.0, 0.0),
        euler=_euler(sample.orientation),
        place=numbers.get(sample.inside, 0),
        sensor=sensor,
        state=state,
        etcdata="",
        tag="",
        extras=_extras(sample.facts),
    )


def _euler(orientation: Quaternion | None) -> Vec3:
    return (0.0, 0.0, 0.0) if orientation is None else euler_from_quaternion(orientation)


def _approach(view: NamedPose) -> str:
    x, y, _ = view.position
    return f"{view.robot or 'any'};{x!r},{y!r},{view.yaw!r}"


def _extras(facts: Facts) -> Facts:
    fields = {TMS_PREFIX + name: name for name in (*TEXT_FIELDS, *NUMBER_FIELDS)}
    return tuple((fields[name], value) for name, value in facts if name in fields)
