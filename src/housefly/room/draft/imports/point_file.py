"""Point clouds: PCD read by pypcd4, LAS and LAZ by laspy, E57 by pye57."""

from __future__ import annotations

import re
import struct
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from housefly.errors import MissingPartError, RoomError
from housefly.numeric import FloatArray
from housefly.room.draft.imports.scan_part import ScanFile, cloud_part, refuse_too_many_points

_INSTALL = "pip install 'housefly[import]'"
_HEADER_MAX = 4096
"""Longest header of a PCD [bytes]."""
_CHUNK = 1_000_000
_NOISE = (7, 18)
"""Classes of LAS for low and high noise."""
_GEO_UNIT = 3076
"""GeoTIFF key of the linear unit."""
_GEO_UNITS = {9001: 1.0, 9002: 0.3048, 9003: 0.304800609601219}
_WKT_UNIT = re.compile(
    r'(?:LENGTH)?UNIT\["(?:[^"]*(?:metre|meter|foot|feet)[^"]*)",\s*([\d.eE+-]+)', re.I
)


def read_pcd(path: Path) -> ScanFile:
    """Return the points of a PCD; raises RoomError, or what a broken file raises in pypcd4."""
    try:
        from pypcd4 import MetaData, PointCloud
    except ImportError as error:
        raise MissingPartError("the reader of PCD (pypcd4)", _INSTALL) from error
    with path.open("rb") as file:
        try:
            header = MetaData.parse_header(_pcd_header(file))
        except ValueError as error:
            raise RoomError(f"{path.name} has no good header of a PCD: {error}") from error
        refuse_too_many_points(header.points, path.name)
        whole = header.points * header.build_dtype().itemsize
        there = path.stat().st_size - file.tell()
        if header.data.value == "binary" and there < whole:
            raise RoomError(f"{path.name} ends in the middle: {there} of {whole} bytes are there")
        if header.data.value.startswith("binary") and header.data.value != "binary":
            packed, unpacked = struct.unpack("<II", file.read(8))
            if unpacked != whole or there - 8 < packed:
                raise RoomError(f"{path.name} is damaged: its points are not as long as it says")
    cloud = PointCloud.from_path(path)
    missing = [axis for axis in "xyz" if axis not in cloud.fields]
    if missing:
        raise RoomError(
            f"{path.name} has no field {missing[0]!r}; it has: {', '.join(cloud.fields)}"
        )
    points = cloud.numpy(("x", "y", "z")).astype(np.float64)
    lost = header.points - points.shape[0]
    notes = (f"the file ends in the middle: {lost} points are missing",) if lost > 0 else ()
    return ScanFile((cloud_part(points),), None, notes)


def _pcd_header(file: BinaryIO) -> list[str]:
    lines = list[str]()
    while file.tell() < _HEADER_MAX and (raw := file.readline(_HEADER_MAX)):
        line = raw.decode("ascii", errors="replace").strip()
        if line and not line.startswith("#"):
            lines.append(line)
        if line.startswith("DATA"):
            break
    return lines


def read_las(path: Path) -> ScanFile:
    """Return the points of a LAS or LAZ; raises RoomError, or what broken ones raise in laspy."""
    try:
        import laspy
        import lazrs  # noqa: F401
    except ImportError as error:
        raise MissingPartError("the reader of LAS and LAZ (laspy, lazrs)", _INSTALL) from error
    parts, noise = list[FloatArray](), 0
    with laspy.open(path) as reader:
        header = reader.header
        refuse_too_many_points(header.point_count, path.name)
        for chunk in reader.chunk_iterator(_CHUNK):
            points = np.column_stack([chunk.x, chunk.y, chunk.z]).astype(np.float64)
            is_noise = np.isin(np.asarray(chunk.classification), _NOISE)
            noise += int(is_noise.sum())
            parts.append(points[~is_noise])
    points = np.vstack([np.empty((0, 3)), *parts])
    notes = (f"left out: {noise} points that it calls noise",) if noise else ()
    return ScanFile((cloud_part(points),), _las_unit(header), notes)


def _las_unit(header: Any) -> float | None:
    """Return metres per unit where a LAS says them."""
    for record in (*header.vlrs, *(header.evlrs or ())):
        keys = getattr(record, "geo_keys", ())
        for key in keys:
            if key.id == _GEO_UNIT and key.value_offset in _GEO_UNITS:
                return _GEO_UNITS[key.value_offset]
        found = _WKT_UNIT.findall(getattr(record, "string", ""))
        if found:
            return float(found[0])
    return None


def read_e57(path: Path) -> ScanFile:
    """Return the points of all scans of an E57 together.

    Raises RoomError, or what a broken file raises in pye57.
    """
    try:
        import pye57
    except ImportError as error:
        raise MissingPartError("the reader of E57 (pye57)", _INSTALL) from error
    document = pye57.E57(str(path))
    try:
        numbers = range(document.scan_count)
        count = sum(document.get_header(number).point_count for number in numbers)
        refuse_too_many_points(count, path.name)
        scans = [document.read_scan(number, ignore_missing_fields=True) for number in numbers]
    finally:
        document.close()
    axes = ("cartesianX", "cartesianY", "cartesianZ")
    parts = tuple(cloud_part(np.column_stack([scan[axis] for axis in axes])) for scan in scans)
    return ScanFile(parts, 1.0)
