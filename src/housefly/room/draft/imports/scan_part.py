"""A scan as its file has it: points and surfaces in the file's own unit and axes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from housefly.errors import RoomError
from housefly.messages.words import Words, figure
from housefly.numeric import FloatArray

VERTICES_MAX = 30_000_000
"""Most points of a file, those of a part counted as often as it stands in the scene."""
_FAR = 30.0
"""Points so many times as far away as most others are from each other are no part of a scan."""


@dataclass(frozen=True, eq=False)
class ScanPart:
    """Points, and the triangles between them if it is a surface.

    Attributes:
        vertices: shape (n, 3).
        faces: indices of three vertices each, shape (m, 3).
    """

    vertices: FloatArray
    faces: NDArray[np.int64]

    @cached_property
    def area(self) -> float:
        """Of all triangles."""
        a, b, c = (self.vertices[self.faces[:, n]] for n in range(3))
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2.0


@dataclass(frozen=True, slots=True, eq=False)
class ScanFile:
    """The parts of a file.

    Attributes:
        parts: one and more.
        unit: metres per unit as the file says them, None where it does not.
        notes: what was left out, a sentence each.
    """

    parts: tuple[ScanPart, ...]
    unit: float | None = None
    notes: tuple[Words, ...] = ()


def cloud_part(points: FloatArray) -> ScanPart:
    """Return points without surfaces, shape (n, 3)."""
    return ScanPart(np.asarray(points, dtype=np.float64), np.empty((0, 3), dtype=np.int64))


def refuse_too_many_points(count: int, name: str) -> None:
    """Raise RoomError for more points than this machine's memory should hold."""
    if count > VERTICES_MAX:
        raise RoomError(
            Words(
                "{name} holds {n} points, at most {m} are read: thin the scan out, 2 cm between"
                " points are enough",
                name=name,
                n=figure(count),
                m=figure(VERTICES_MAX),
            )
        )


def without_broken_points(
    parts: Iterable[ScanPart], name: str
) -> tuple[tuple[ScanPart, ...], tuple[Words, ...]]:
    """Return the parts without points that are not finite or far away, and how many these were.

    Raises:
        RoomError: no points are left.
    """
    parts = tuple(parts)
    finite = [np.isfinite(part.vertices).all(axis=1) for part in parts]
    found = [part.vertices[ok] for part, ok in zip(parts, finite, strict=True)]
    corners = np.vstack([np.empty((0, 3)), *found])
    if corners.shape[0] == 0:
        raise RoomError(Words("{name} holds no points, or none that is finite", name=name))
    low, middle, high = np.percentile(corners, (10.0, 50.0, 90.0), axis=0)
    reach = _FAR * float((high - low).max())
    near = [
        _near(part.vertices, middle, reach) & ok for part, ok in zip(parts, finite, strict=True)
    ]
    everything = sum(len(part.vertices) for part in parts)
    broken = everything - corners.shape[0]
    far = corners.shape[0] - sum(int(ok.sum()) for ok in near)
    notes = (
        Words(
            "left out: {n} of {m} points ({words})",
            n=figure(count),
            m=figure(everything),
            words=why,
        )
        for count, why in (
            (broken, Words("no numbers")),
            (far, Words("far away from all the rest")),
        )
        if count
    )
    kept = tuple(_kept(part, ok) for part, ok in zip(parts, near, strict=True))
    return kept, tuple(notes)


def _near(vertices: FloatArray, middle: FloatArray, reach: float) -> NDArray[np.bool_]:
    with np.errstate(invalid="ignore"):
        return np.asarray((np.abs(vertices - middle) <= reach).all(axis=1), dtype=np.bool_)


def _kept(part: ScanPart, kept: NDArray[np.bool_]) -> ScanPart:
    """Return the part with these vertices, and the triangles between them."""
    if kept.all():
        return part
    numbers = np.cumsum(kept) - 1
    faces = part.faces[kept[part.faces].all(axis=1)]
    return ScanPart(part.vertices[kept], numbers[faces].reshape(-1, 3))
