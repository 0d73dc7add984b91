"""Imports a dump of ROS-TMS's database (mongoexport, one JSON row a line) as things and samples.

A row without a sensor is the catalogue; the others are the last report of each sensor. A row that
cannot be read is reported by its line and skipped; nothing else is lost. ROS-TMS writes an unknown
position as exactly (0, 0, 0), or (-1, -1, -1) if absent. Fields that Housefly has no place for
become facts that begin with ``tms_``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from io import StringIO
from pathlib import Path

from housefly.config.text import read_file
from housefly.errors import StoreError, ThingError
from housefly.geometry import Quaternion, Vec3, quaternion_from_euler
from housefly.hub.store.tms_rows import (
    JAPAN_UTC_OFFSET,
    KIND_BY_THOUSANDS,
    TmsRow,
    parse_row,
    source_of,
    tms_kind,
)
from housefly.hub.things.thing import NamedPose, Thing, ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Facts, Observation

_MAX_DUMP_SIZE = 64 * 2**20
"""Largest dump that is read [bytes]."""
_UNKNOWN_POSITIONS = ((0.0, 0.0, 0.0), (-1.0, -1.0, -1.0))
TMS_PREFIX = "tms_"


@dataclass(frozen=True, slots=True)
class TmsDump:
    """The content of a dump.

    Attributes:
        things: the catalogue; things that only samples mention are named by their name or number.
        samples: the last report of each sensor on each thing.
        remarks: what was wrong, by line number.
        skipped: how many rows were skipped.
    """

    things: tuple[Thing, ...]
    samples: tuple[Observation, ...]
    remarks: tuple[str, ...]
    skipped: int


def read_tms(path: Path, utc_offset: float = JAPAN_UTC_OFFSET) -> TmsDump:
    """Read a dump from a file; raises StoreError if the file cannot be read at all."""
    try:
        text = read_file(path, _MAX_DUMP_SIZE).decode("utf-8", "replace")
    except OSError as error:
        raise StoreError(f"{path} cannot be read ({error.strerror})") from error
    return parse_tms(StringIO(text, newline=None), utc_offset)


def parse_tms(lines: Iterable[str], utc_offset: float = JAPAN_UTC_OFFSET) -> TmsDump:
    """Read the lines of a dump.

    Args:
        lines: one row of JSON each.
        utc_offset: of the wall clock in the room that wrote it [s east of UTC].
    """
    reader = _Reader()
    for number, line in enumerate(lines, 1):
        if line.strip():
            try:
                reader.rows.append((number, parse_row(line, utc_offset)))
            except ValueError as error:
                reader.skip(number, str(error))
    return reader.read()


class _Reader:
    """Collects the rows of one dump and converts them to things and samples."""

    def __init__(self) -> None:
        self.rows: list[tuple[int, TmsRow]] = []
        self._remarks: list[str] = []
        self._skipped = 0
        self._ids: dict[int, str] = {}
        self._things: dict[str, Thing] = {}
        self._catalogued: set[str] = set()
        self._samples: list[Observation] = []
        self._world = WorldModel()

    def skip(self, number: int, why: str) -> None:
        self._skipped += 1
        self._remarks.append(f"row {number}: skipped: {why}")

    def read(self) -> TmsDump:
        for _, row in self.rows:
            self._name(row)
        for number, row in self.rows:
            if _is_catalogue(row):
                self._catalogue(number, row)
        for number, row in self.rows:
            self._call(number, row)
            if not _is_catalogue(row):
                self._sample(number, row)
        return TmsDump(
            tuple(self._things.values()), tuple(self._samples), tuple(self._remarks), self._skipped
        )

    def _name(self, row: TmsRow) -> None:
        """Assign an id to a number: the name as a slug, with the number if the name is taken."""
        if row.id not in self._ids:
            self._put(row.id, row.name, tms_kind(row.id, row.type))

    def _put(self, number: int, given: str, kind: ThingKind) -> None:
        name = given if slug(given) else f"{kind.value} {number}"
        id_ = slug(name) if slug(name) not in self._things else f"{slug(name)}-{number}"
        self._ids[number] = id_
        self._things[id_] = Thing(id_, name, kind, facts=((f"{TMS_PREFIX}id", float(number)),))

    def _catalogue(self, number: int, row: TmsRow) -> None:
        known = self._things[self._ids[row.id]]
        if known.id in self._catalogued:
            self.skip(number, f"{row.name} is in the catalogue twice; the first row counts")
            return
        self._catalogued.add(known.id)
        position = _position(row)
        marks = (
            ("sensor", float(row.sensor)),
            ("state", float(row.state)),
            ("time", row.time or 0.0),
        )
        extras = (*row.extras, *((name, value) for name, value in marks if value))
        thing = replace(
            known,
            kind=tms_kind(row.id, row.type or known.kind.value),
            position=position,
            orientation=_orientation(row, position),
            inside=self._container(number, row),
            facts=(*known.facts, *_prefixed(extras)),
        )
        try:
            self._world.add_thing(thing)
        except ThingError as error:
            self._remarks.append(f"row {number}: place {row.place} is ignored: {error}")
            thing = replace(thing, inside="")
            self._world.add_thing(thing)
        self._things[thing.id] = thing

    def _call(self, number: int, row: TmsRow) -> None:
        """Add a row's aliases and viewpoints of a thing, whoever wrote the row."""
        known = self._things[self._ids[row.id]]
        names = (*known.aliases, *(name.strip() for name in row.tag.split(";") if name.strip()))
        views = known.viewpoints
        try:
            views += viewpoints_of(row.etcdata)
        except ValueError as error:
            self._remarks.append(f"row {number}: etcdata is ignored: {error}")
        self._things[known.id] = replace(
            known, aliases=tuple(dict.fromkeys(names)), viewpoints=tuple(dict.fromkeys(views))
        )

    def _sample(self, number: int, row: TmsRow) -> None:
        position = _position(row)
        extras = (*row.extras, *((("state", float(row.state)),) if row.state > 1 else ()))
        at = row.time or 0.0
        sample = Observation(
            thing=self._ids[row.id],
            source=source_of(row.sensor),
            captured_at=at,
            received_at=at,
            position=position,
            orientation=_orientation(row, position),
            inside=self._container(number, row),
            valid=row.state != 0,
            facts=_prefixed(extras),
        )
        try:
            self._world.observe(sample)
        except ThingError as error:
            self._remarks.append(f"row {number}: place {row.place} is ignored: {error}")
            sample = replace(sample, inside="")
        self._samples.append(sample)

    def _container(self, number: int, row: TmsRow) -> str:
        if row.place == 0:
            return ""
        if row.place not in self._ids:
            if row.place // 1000 not in KIND_BY_THOUSANDS:
                self._remarks.append(
                    f"row {number}: place is {row.place}, which is no thing: it is ignored"
                )
                return ""
            self._put(row.place, "", tms_kind(row.place))
        return self._ids[row.place]


def _is_catalogue(row: TmsRow) -> bool:
    """Return whether a row was written by no sensor."""
    return row.time is None or (row.sensor == 0 and row.state == 0)


def viewpoints_of(etcdata: str) -> tuple[NamedPose, ...]:
    """Return the poses in "smartpal5_2;10.3,3.7,-1.57;wheelchair;9.8,1.55,1.57".

    Raises:
        ValueError: in words.
    """
    parts = [part.strip() for part in etcdata.strip().strip(";").split(";")]
    if parts == [""]:
        return ()
    if len(parts) % 2:
        raise ValueError(f"{etcdata!r} is not made of pairs robot;x,y,yaw")
    return tuple(
        _viewpoint(robot, pose) for robot, pose in zip(parts[::2], parts[1::2], strict=True)
    )


def slug(name: str) -> str:
    """Return a name as an id: "Cup (red)" is "cup-red"."""
    return re.sub(r"[^a-z0-9_]+", "-", name.casefold()).strip("-")


def _viewpoint(robot: str, pose: str) -> NamedPose:
    try:
        x, y, yaw = (float(number) for number in pose.split(","))
    except ValueError as error:
        raise ValueError(f"the pose of {robot!r} is {pose!r}; allowed: x,y,yaw") from error
    return NamedPose(f"for {robot}", (x, y, 0.0), yaw, robot=robot)


def _position(row: TmsRow) -> Vec3 | None:
    unknown = _UNKNOWN_POSITIONS if row.state == 0 else _UNKNOWN_POSITIONS[:1]
    return None if row.position in unknown else row.position


def _orientation(row: TmsRow, position: Vec3 | None) -> Quaternion | None:
    return None if position is None and not any(row.euler) else quaternion_from_euler(*row.euler)


def _prefixed(extras: Facts) -> Facts:
    return tuple((TMS_PREFIX + name, value) for name, value in extras)
