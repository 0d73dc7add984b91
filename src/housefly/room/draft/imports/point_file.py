"""Files of points alone, PCD, LAS and E57: their headers are checked, then they are read."""

from __future__ import annotations

import struct
from importlib.util import find_spec
from pathlib import Path
from typing import BinaryIO

import numpy as np

from housefly.errors import MissingPartError, RoomError
from housefly.messages.words import Words, figure
from housefly.room.draft.imports.point_child import read_apart
from housefly.room.draft.imports.scan_part import ScanFile, cloud_part, refuse_too_many_points

_INSTALL = "pip install 'housefly[import]'"
_HEADER_MAX = 4096
"""Longest header of a PCD [bytes]."""
_FIELDS_MAX = 10_000
_RECORD_MAX = 2000
"""Longest point of a LAS [bytes]; usual ones have up to 70."""


def read_pcd(path: Path) -> ScanFile:
    """Return the points of a PCD; raises RoomError, or what a broken file raises in pypcd4."""
    if not find_spec("pypcd4"):
        raise MissingPartError(
            Words("the reader of {kind} ({name})", kind="PCD", name="pypcd4"), _INSTALL
        )
    from pypcd4.pypcd4 import MetaData, PointCloud

    with path.open("rb") as file:
        try:
            header = MetaData.parse_header(_pcd_header(file))
        except ValueError as error:
            raise RoomError(
                Words("{name} has no good header of a PCD: {why}", name=path.name, why=str(error))
            ) from error
        refuse_too_many_points(header.points, path.name)
        if sum(header.count) > _FIELDS_MAX:
            raise RoomError(
                Words(
                    "{name} has more than {n} numbers a point",
                    name=path.name,
                    n=figure(_FIELDS_MAX),
                )
            )
        whole = header.points * header.build_dtype().itemsize
        there = path.stat().st_size - file.tell()
        if header.data.value == "binary" and there < whole:
            raise _cut_off(path, there, whole)
        if header.data.value.startswith("binary") and header.data.value != "binary":
            packed, unpacked = struct.unpack("<II", file.read(8))
            if unpacked != whole or there - 8 < packed:
                raise RoomError(
                    Words(
                        "{name} is damaged: its points are not as long as it says", name=path.name
                    )
                )
    cloud = PointCloud.from_path(path)
    missing = [axis for axis in "xyz" if axis not in cloud.fields]
    if missing:
        raise RoomError(
            Words(
                "{name} has no field {thing}; it has: {place}",
                name=path.name,
                thing=repr(missing[0]),
                place=", ".join(cloud.fields),
            )
        )
    points = cloud.numpy(("x", "y", "z")).astype(np.float64)
    lost = header.points - points.shape[0]
    note = Words("the file ends in the middle: {n} points are missing", n=figure(lost))
    return ScanFile((cloud_part(points),), None, (note,) if lost > 0 else ())


def _cut_off(path: Path, there: int, whole: int) -> RoomError:
    return RoomError(
        Words(
            "{name} ends in the middle: {a} of {b} bytes are there",
            name=path.name,
            a=figure(there),
            b=figure(whole),
        )
    )


def read_las(path: Path) -> ScanFile:
    """Return the points of a LAS or LAZ; raises RoomError."""
    if not (find_spec("laspy") and find_spec("lazrs")):
        raise MissingPartError(
            Words("the reader of {kind} ({name})", kind="LAS and LAZ", name="laspy, lazrs"),
            _INSTALL,
        )
    with path.open("rb") as file:
        head = file.read(247).ljust(247, b"\0")
    start, records, _, length = struct.unpack_from("<IIBH", head, 96)
    extended = struct.unpack_from("<I", head, 243)[0] if head[25] >= 4 else 0
    whole = max(start, 54 * records, 60 * extended)
    if head[:4] != b"LASF" or whole > path.stat().st_size or length > _RECORD_MAX:
        raise RoomError(
            Words("{name} has no good header of a LAS; is the file whole?", name=path.name)
        )
    return read_apart("las", path)


def read_e57(path: Path) -> ScanFile:
    """Return the points of all scans of an E57 together; raises RoomError."""
    if not find_spec("pye57"):
        raise MissingPartError(
            Words("the reader of {kind} ({name})", kind="E57", name="pye57"), _INSTALL
        )
    with path.open("rb") as file:
        head = file.read(24).ljust(24, b"\0")
    whole, there = struct.unpack_from("<Q", head, 16)[0], path.stat().st_size
    if head[:8] != b"ASTM-E57":
        raise RoomError(
            Words("{name} has no good header of an E57; is the file whole?", name=path.name)
        )
    if whole != there:
        raise _cut_off(path, there, whole)
    return read_apart("e57", path)


def _pcd_header(file: BinaryIO) -> list[str]:
    lines = list[str]()
    while file.tell() < _HEADER_MAX and (raw := file.readline(_HEADER_MAX)):
        line = raw.decode("ascii", errors="replace").strip()
        if line and not line.startswith("#"):
            lines.append(line)
        if line.startswith("DATA"):
            break
    return lines
