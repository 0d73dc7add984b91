"""The points of a scan, read by trimesh; surfaces of a mesh become points 2 cm apart."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from housefly.errors import MissingPartError, RoomError
from housefly.numeric import FloatArray
from housefly.room.draft.imports.contracts import USUAL_UNITS, ImportHints

SPACING = 0.02
_COARSE_POINTS = 50_000
"""So many points of all surfaces tell axis and unit."""
_POINTS_MAX = 4_000_000
_SAMPLES_MAX = 8_000_000
"""Most points on all surfaces together."""
_VERTICES_MAX = 30_000_000
"""Most points of a file, those of a part counted as often as it stands in the scene."""
_POINTS_MIN = 500
_SIDES = (1.5, 60.0)
"""A room is at least and at most so long [m]."""
_HEIGHTS = (1.0, 20.0)
_FLOOR_BIN = 0.02
_Y_UP_SUFFIXES = (".glb", ".gltf")
"""The format says so."""


@dataclass(frozen=True, slots=True, eq=False)
class PointCloud:
    """Points in metres, z up, floor at 0, shape (n, 3), and what was assumed, in words."""

    points: FloatArray
    notes: tuple[str, ...]


def read_point_cloud(path: Path, hints: ImportHints) -> PointCloud:
    """Read a scan.

    Raises:
        RoomError: it cannot be read, or its unit cannot be told.
        MissingPartError: trimesh is not installed.
    """
    parts = _parts(path)
    corners = np.vstack([part.vertices for part in parts])
    if corners.shape[0] < 3 or not np.isfinite(corners).all():
        raise RoomError(f"{path.name} holds no points, or some that are not finite")
    area = sum(float(part.area) for part in parts if _has_faces(part))
    coarse = np.vstack([_sampled(part, (area / _COARSE_POINTS) ** 0.5) for part in parts])
    axis, axis_note = _up_axis(coarse, path, hints)
    unit, unit_note = _unit(_turned(coarse, axis), path, hints)
    spacing = fine_spacing(parts, SPACING / unit)
    points = np.vstack([_sampled(part, spacing) for part in parts]) * unit
    points = _turned(points, axis)
    if points.shape[0] < _POINTS_MIN:
        raise RoomError(
            f"{path.name} has {points.shape[0]} points; at least {_POINTS_MIN} are needed, better"
            " one on each 2 cm of wall and floor"
        )
    floor = _floor(points)
    points[:, 2] -= floor
    return PointCloud(points, (axis_note, unit_note, f"the floor was taken at {floor:.2f} m in it"))


def _parts(path: Path) -> list[Any]:
    try:
        import trimesh
    except ImportError as error:
        raise MissingPartError(
            "the reader of scans (trimesh)", "pip install 'housefly[import]'"
        ) from error
    try:
        # Only files beside it may be named inside it, and nothing is fetched.
        with np.errstate(all="ignore"):
            scene = trimesh.load_scene(path, allow_remote=False)
        _refuse_too_many(scene, path.name)
        found = [part for part in scene.dump() if getattr(part, "vertices", None) is not None]
    except RoomError:
        raise
    except Exception as error:  # a broken file makes its reader fail in any way
        raise RoomError(f"{path.name} cannot be read as a scan: {error}") from error
    if not found:
        raise RoomError(f"{path.name} holds neither points nor surfaces")
    return found


def _refuse_too_many(scene: Any, name: str) -> None:
    """Raise RoomError for what a few lines of a file would make of this machine's memory."""
    parts = (scene.geometry[scene.graph[node][1]] for node in scene.graph.nodes_geometry)
    count = sum(len(part.vertices) for part in parts if hasattr(part, "vertices"))
    if count > _VERTICES_MAX:
        raise RoomError(
            f"{name} holds {count} points, at most {_VERTICES_MAX} are read: thin the scan out,"
            " 2 cm between points are enough"
        )


def fine_spacing(parts: list[Any], wanted: float) -> float:
    """Return how far apart points on the surfaces of all parts are, in the unit of the parts.

    Args:
        parts: meshes and clouds.
        wanted: distance unless that makes too many points.
    """
    area = sum(float(part.area) for part in parts if _has_faces(part))
    return max(wanted, float(np.sqrt(area / _SAMPLES_MAX)))


def _sampled(part: Any, spacing: float) -> FloatArray:
    """Return points on the surfaces of a mesh, or the points of a cloud; shape (n, 3)."""
    vertices = np.asarray(part.vertices, dtype=np.float64)
    if not _has_faces(part):
        return _thinned(vertices)
    count = int(min(_POINTS_MAX, float(part.area) / spacing**2)) if spacing > 0.0 else 0
    if count < 1:
        return vertices
    from trimesh.sample import sample_surface

    points, _ = sample_surface(part, count, seed=1)
    return np.vstack([vertices, np.asarray(points, dtype=np.float64)])


def _has_faces(part: Any) -> bool:
    faces = getattr(part, "faces", None)
    return faces is not None and len(faces) > 0


def _thinned(points: FloatArray) -> FloatArray:
    step = -(-points.shape[0] // _POINTS_MAX)
    return points[::step]


def _up_axis(points: FloatArray, path: Path, hints: ImportHints) -> tuple[str, str]:
    if hints.up != "auto":
        return hints.up, f"{hints.up} points up, as you said"
    if path.suffix.lower() in _Y_UP_SUFFIXES:
        return "y", "y points up, as glTF has it"
    # A floor is the largest level, and a room is rarely higher than it is wide.
    y, z = _floor_likeness(points[:, 1]), _floor_likeness(points[:, 2])
    axis = "y" if y > z else "z"
    return axis, f"{axis} was taken to point up"


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


def _unit(points: FloatArray, path: Path, hints: ImportHints) -> tuple[float, str]:
    low, high = np.percentile(points, (0.1, 99.9), axis=0)
    length, width, height = (float(side) for side in high - low)
    sides = f"{length:.4g} x {width:.4g} x {height:.4g}"
    if hints.unit is not None:
        return hints.unit, f"one unit is {hints.unit:g} m, as you said"
    for unit, name in USUAL_UNITS.items():
        fits = [_SIDES[0] <= unit * side <= _SIDES[1] for side in (length, width)]
        if all(fits) and _HEIGHTS[0] <= unit * height <= _HEIGHTS[1]:
            return unit, f"its numbers ({sides}) were taken for {name}"
    raise RoomError(
        f"{path.name} measures {sides}: no room in any usual unit; say how many metres one unit is"
        " (0.001 for millimetres), and which axis points up"
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
