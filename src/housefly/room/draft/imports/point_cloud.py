"""The points of a scan in metres, z up; surfaces of a mesh become points 2 cm apart."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np

from housefly.errors import HouseflyError, RoomError
from housefly.messages.words import Words, figure, literal
from housefly.numeric import FloatArray
from housefly.room.draft.imports.contracts import USUAL_UNITS, ImportHints
from housefly.room.draft.imports.mesh_file import read_mesh
from housefly.room.draft.imports.point_file import read_e57, read_las, read_pcd
from housefly.room.draft.imports.scan_part import (
    ScanFile,
    ScanPart,
    without_broken_points,
)
from housefly.room.draft.imports.units import likely_units

SPACING = 0.02
_COARSE_POINTS = 50_000
"""So many points of all surfaces tell axis and unit."""
_POINTS_MAX = 4_000_000
_SAMPLES_MAX = 8_000_000
"""Most points on all surfaces together."""
_POINTS_MIN = 500
_SIDES = (1.5, 60.0)
"""A room is at least and at most so long [m]."""
_HEIGHTS = (1.0, 20.0)
_FLOOR_BIN = 0.02
_UP = {".glb": "y", ".gltf": "y", ".las": "z", ".laz": "z", ".e57": "z"}
"""The format says so."""

_READERS: dict[str, Callable[[Path], ScanFile]] = {
    ".ply": read_mesh,
    ".obj": read_mesh,
    ".glb": read_mesh,
    ".gltf": read_mesh,
    ".stl": read_mesh,
    ".pcd": read_pcd,
    ".las": read_las,
    ".laz": read_las,
    ".e57": read_e57,
}
SCAN_SUFFIXES = tuple(_READERS)
"""Ends of the names of files that are read."""


@dataclass(frozen=True, slots=True, eq=False)
class PointCloud:
    """Points in metres, z up, floor at 0, shape (n, 3), and what was assumed, in words."""

    points: FloatArray
    notes: tuple[Words, ...]


class SampledSurface(Protocol):
    """What has an area."""

    @property
    def area(self) -> float:
        """In the square of its unit."""
        ...


def read_point_cloud(path: Path, hints: ImportHints) -> PointCloud:
    """Read a scan.

    Raises:
        RoomError: it cannot be read, or its unit cannot be told.
        MissingPartError: its reader is not installed.
    """
    scan = _scan_file(path)
    if not scan.parts:
        raise RoomError(Words("{name} holds neither points nor surfaces", name=path.name))
    parts, left_out = without_broken_points(scan.parts, path.name)
    area = sum(part.area for part in parts)
    coarse = np.vstack([_sampled(part, (area / _COARSE_POINTS) ** 0.5) for part in parts])
    axis, axis_note = _up_axis(coarse, path, hints)
    unit, unit_note = _unit(_turned(coarse, axis), path, hints, scan.unit)
    spacing = fine_spacing(parts, SPACING / unit)
    points = np.vstack([_sampled(part, spacing) for part in parts]) * unit
    points = _turned(points, axis)
    if points.shape[0] < _POINTS_MIN:
        raise RoomError(
            Words(
                "{name} has {n} points; at least {m} are needed, better one on each 2 cm of wall"
                " and floor",
                name=path.name,
                n=figure(points.shape[0]),
                m=figure(_POINTS_MIN),
            )
        )
    floor = _floor(points)
    points[:, 2] -= floor
    floor_note = Words("the floor was taken at {a} m in it", a=figure(floor, ".2f"))
    return PointCloud(points, (*scan.notes, *left_out, axis_note, unit_note, floor_note))


def _scan_file(path: Path) -> ScanFile:
    try:
        return _READERS[path.suffix.lower()](path)
    except HouseflyError:
        raise
    except Exception as error:  # a broken file makes its reader fail in any way
        raise RoomError(
            Words(
                "{name} cannot be read as a scan: {why}; is the file whole?",
                name=path.name,
                why=_reader_words(error),
            )
        ) from error


def _reader_words(error: Exception) -> Words:
    """Return what the reader of a broken file says, or that it says nothing to people."""
    said = str(error).strip().partition("\n")[0]
    if isinstance(error, LookupError | TypeError | AttributeError) or not said:
        said = f"{type(error).__name__} {said}".rstrip()
        return Words("its reader stops with {name}", name=said)
    return literal(said)


def fine_spacing(parts: Iterable[SampledSurface], wanted: float) -> float:
    """Return how far apart points on the surfaces of all parts are, in the unit of the parts.

    Args:
        parts: meshes and clouds.
        wanted: distance unless that makes too many points.
    """
    area = sum(float(part.area) for part in parts)
    return max(wanted, float(np.sqrt(area / _SAMPLES_MAX)))


def _sampled(part: ScanPart, spacing: float) -> FloatArray:
    """Return points on the surfaces of a mesh, or the points of a cloud; shape (n, 3)."""
    if len(part.faces) == 0:
        return _thinned(part.vertices)
    count = int(min(_POINTS_MAX, part.area / spacing**2)) if spacing > 0.0 else 0
    if count < 1:
        return part.vertices
    from trimesh import Trimesh
    from trimesh.sample import sample_surface

    mesh = Trimesh(part.vertices, part.faces, process=False)
    points, _ = sample_surface(mesh, count, seed=1)
    return np.vstack([part.vertices, np.asarray(points, dtype=np.float64)])


def _thinned(points: FloatArray) -> FloatArray:
    step = -(-points.shape[0] // _POINTS_MAX)
    return points[::step]


def _up_axis(points: FloatArray, path: Path, hints: ImportHints) -> tuple[str, Words]:
    if hints.up != "auto":
        return hints.up, Words("{name} points up, as you said", name=hints.up)
    if axis := _UP.get(path.suffix.lower()):
        return axis, Words("{name} points up, as the format has it", name=axis)
    # A floor is the largest level, and a room is rarely higher than it is wide.
    y, z = _floor_likeness(points[:, 1]), _floor_likeness(points[:, 2])
    axis = "y" if y > z else "z"
    return axis, Words("{name} was taken to point up", name=axis)


def _floor_likeness(values: FloatArray) -> float:
    """Return the share of points in the fullest hundredth of an axis' lower part, per its length.

    Args:
        values: of all points along the axis.
    """
    low, high = (float(value) for value in np.percentile(values, (0.1, 99.9)))
    if not high > low:
        return 0.0
    counts, _ = np.histogram(values, bins=100, range=(low, high))
    return float(counts[:40].max()) / values.size / (high - low)


def _turned(points: FloatArray, axis: str) -> FloatArray:
    """Return points with z up."""
    if axis == "z":
        return np.array(points, dtype=np.float64)
    return np.column_stack([points[:, 0], -points[:, 2], points[:, 1]]).astype(np.float64)


def _unit(
    points: FloatArray, path: Path, hints: ImportHints, declared: float | None
) -> tuple[float, Words]:
    low, high = np.percentile(points, (0.1, 99.9), axis=0)
    length, width, height = (float(side) for side in high - low)
    sides = Words(
        "{a} x {b} x {c}",
        a=figure(length, ".4g"),
        b=figure(abs(width), ".4g"),
        c=figure(height, ".4g"),
    )
    if hints.unit is not None:
        return hints.unit, Words("one unit is {a} m, as you said", a=figure(hints.unit, "g"))
    if declared is not None:
        return declared, Words(
            "its numbers ({thing}) are {a} m each, as the file says",
            thing=sides,
            a=figure(declared, ".4g"),
        )
    if not (length > 0.0 and width > 0.0):
        raise RoomError(
            Words(
                "{name} measures {thing}: all its points lie on one line or plane",
                name=path.name,
                thing=sides,
            )
        )
    choices = likely_units(USUAL_UNITS, (length, width), _SIDES, height, _HEIGHTS)
    if choices:
        unit = 1.0 if 1.0 in choices else choices[0]
        return unit, Words(
            "its numbers ({thing}) were taken for {words}", thing=sides, words=USUAL_UNITS[unit]
        )
    raise RoomError(
        Words(
            "{name} measures {thing}: no room in any usual unit; say how many metres one unit is"
            " (0.001 for millimetres), and which axis points up",
            name=path.name,
            thing=sides,
        )
    )


def _floor(points: FloatArray) -> float:
    """Return the height of the fullest level of the lower part [m]."""
    heights = points[:, 2]
    low, high = np.percentile(heights, (0.05, 99.9))
    bins = max(1, int((high - low) / _FLOOR_BIN))
    counts, edges = np.histogram(heights, bins=bins, range=(float(low), float(high)))
    lower = counts[: max(1, int(0.4 * bins))]
    best = int(lower.argmax())
    within = heights[
        (heights >= edges[best] - _FLOOR_BIN) & (heights <= edges[best + 1] + _FLOOR_BIN)
    ]
    return float(np.median(within))
