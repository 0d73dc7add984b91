"""A 3-D scan as a draft: columns where points are, unexplored where nobody looked."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from housefly.errors import RoomError
from housefly.messages.words import Words, figure
from housefly.numeric import FloatArray
from housefly.room.draft.imports.cells import (
    boxes_of_cells,
    refuse_too_many,
    without_holes,
)
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.point_cloud import read_point_cloud
from housefly.room.draft.model import DraftBox, SiteDraft
from housefly.room.reach import Mask
from housefly.room.ros_map import unexplored_note

EDGES = (0.05, 0.1, 0.2)
"""Of a cell [m]: the smallest in which there are enough points is taken."""
_POINTS_A_CELL = 2.5
"""So many points are enough, in each cube of that edge that holds any."""
LEVELS = (0.08, 0.45, 0.85, 1.35, 2.0)
"""Heights between which points are told apart [m]; the usual flight height lies between the third
and fourth.
"""
_POINTS_MIN, _NOISE_SHARE = 2, 0.1
"""Fewer points in a cell, or a smaller share of what cells usually hold, are noise."""
_CELLS_MAX = 4_000_000
_CEILING_SHARE = 0.15
"""A ceiling covers more of the floor that no wall stands on."""


def scan(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the room of a scan.

    Raises:
        RoomError: it cannot be read, its points are too far apart, or it holds no floor.
        MissingPartError: its reader is not installed.
    """
    cloud = read_point_cloud(path, hints)
    inside = cloud.points[cloud.points[:, 2] > -0.3]
    edge, edge_note = _edge(inside, path.name)
    low, high = np.percentile(inside[:, :2], (0.05, 99.95), axis=0)
    origin = np.floor((low - 2 * edge) / edge) * edge
    nx, ny = (int(n) for n in np.ceil((high + 2 * edge - origin) / edge))
    if nx * ny > _CELLS_MAX:
        raise RoomError(
            Words(
                "{name} covers {a} m^2; cut out the part to fly in",
                name=path.name,
                a=figure(nx * ny * edge**2, ".0f"),
            )
        )
    cells = _Cells(inside, origin, (nx, ny), edge)
    layers = [cells.occupied(below, above) for below, above in pairwise(LEVELS)]
    seen = without_holes(cells.occupied(-0.3, LEVELS[-1]))
    ceiling = _ceiling(cells, seen & ~(layers[2] & layers[3]))
    top = draft.height if ceiling is None else round(ceiling, 2)
    boxes = tuple(_boxes(layers, seen, top, edge))
    refuse_too_many(boxes, path.name)
    length, width = round(nx * edge, 4), round(ny * edge, 4)
    x, y = origin
    notes = (
        *cloud.notes,
        *edge_note,
        Words(
            "{name}: {a} m x {b} m, {n} boxes from {m} points; {ceiling}",
            name=path.name,
            a=figure(length, ".2f"),
            b=figure(width, ".2f"),
            n=figure(len(boxes)),
            m=figure(len(inside)),
            ceiling=_ceiling_words(ceiling, top),
        ),
        unexplored_note(seen | np.logical_or.reduce(layers), edge),
        Words(
            "the room begins at (0, 0), which the scan calls ({x}, {y}) m",
            x=figure(x, ".2f"),
            y=figure(y, ".2f"),
        ),
    )
    found = replace(draft, bounds=(0.0, 0.0, length, width), scanned=boxes, height=top)
    return Imported(found, notes)


def _ceiling_words(found: float | None, top: float) -> Words:
    """Return where the ceiling is [m], and whether the scan shows it."""
    if found is None:
        return Words("ceiling {c} m (not in the scan: as usual)", c=figure(top, ".2f"))
    return Words("ceiling {c} m", c=figure(top, ".2f"))


def _edge(points: FloatArray, name: str) -> tuple[float, tuple[Words, ...]]:
    """Return the edge of cells that the points are dense enough for, and a word on coarse ones.

    Raises:
        RoomError: they are too far apart for any.
    """
    for edge in EDGES:
        spacing = _spacing(points, edge)
        if spacing is not None:
            is_coarse = edge > EDGES[0]
            note = Words(
                "its points are about {a} cm apart: cells of {b} cm",
                a=figure(100 * spacing, ".0f"),
                b=figure(100 * edge, ".0f"),
            )
            return edge, (note,) if is_coarse else ()
    farthest = EDGES[-1] / 2
    raise RoomError(
        Words(
            "{name} has points more than {a} cm apart, too few to tell walls from gaps: export it"
            " denser, 2 cm between points are best, or as a mesh; or is its unit another one?",
            name=name,
            a=figure(100 * farthest, ".0f"),
        )
    )


def _spacing(points: FloatArray, edge: float) -> float | None:
    """Return how far apart points are [m], None where cubes of this edge hold too few of them."""
    cubes = np.floor(points / edge).astype(np.int64)
    cubes -= cubes.min(axis=0)
    _, height, depth = (int(n) + 1 for n in cubes.max(axis=0))
    count = np.unique((cubes[:, 0] * height + cubes[:, 1]) * depth + cubes[:, 2]).size
    a_cube = points.shape[0] / count
    return edge / a_cube**0.5 if a_cube >= _POINTS_A_CELL else None


class _Cells:
    """The points of a scan by the cell of floor that they stand on."""

    def __init__(
        self, points: FloatArray, origin: FloatArray, shape: tuple[int, int], edge: float
    ) -> None:
        cells = np.floor((points[:, :2] - origin) / edge).astype(np.int64)
        within = ((cells >= 0) & (cells < shape)).all(axis=1)
        self._flat = cells[within, 0] * shape[1] + cells[within, 1]
        self.heights = points[within, 2]
        self._shape = shape

    def occupied(self, low: float, high: float) -> Mask:
        """Return which cells hold enough points between two heights [m]."""
        counts = self._counts(low, high)
        usual = float(np.median(counts[counts > 0])) if counts.any() else 0.0
        return np.asarray(counts >= max(_POINTS_MIN, _NOISE_SHARE * usual)).reshape(self._shape)

    def touched(self, low: float, high: float) -> Mask:
        """Return which cells hold any point between two heights [m]."""
        return np.asarray(self._counts(low, high) > 0).reshape(self._shape)

    def _counts(self, low: float, high: float) -> NDArray[np.int64]:
        chosen = self._flat[(self.heights >= low) & (self.heights < high)]
        return np.bincount(chosen, minlength=self._shape[0] * self._shape[1])


def _boxes(layers: list[Mask], seen: Mask, ceiling: float, edge: float) -> Iterator[DraftBox]:
    """Yield columns from the floor up to the highest level that is occupied without a gap above.

    What hangs above the flight height only begins there; under it nothing is taken to be free
    below the flight height, because a scan rarely looks there.
    """
    low, middle, flight, high = layers
    wall = flight & high
    yield from boxes_of_cells(wall, edge, ceiling, "wall")
    yield from boxes_of_cells(flight & ~high, edge, LEVELS[3], "tall thing")
    yield from boxes_of_cells(middle & ~flight, edge, LEVELS[2], "thing")
    yield from boxes_of_cells(low & ~middle & ~flight, edge, LEVELS[1], "low thing")
    yield from boxes_of_cells(
        high & ~flight, edge, min(LEVELS[4], ceiling), "hanging thing", bottom=LEVELS[3]
    )
    unknown = ~(seen | low | middle | flight | high)
    yield from boxes_of_cells(unknown, edge, ceiling, "unexplored")


def _ceiling(cells: _Cells, floor: Mask) -> float | None:
    """Return the height of a level above 1.9 m that lies above much of the floor, None without.

    The upper rows of a wall's points are level, too, but lie above the wall.
    """
    above = cells.heights[(cells.heights > 1.9) & (cells.heights < 20.0)]
    if above.size == 0:
        return None
    counts, edges = np.histogram(above, bins=np.arange(1.9, float(above.max()) + 0.1, 0.05))
    for best in np.argsort(-counts, kind="stable")[:3]:
        covered = cells.touched(float(edges[best]) - 0.05, float(edges[best]) + 0.1) & floor
        if covered.sum() > _CEILING_SHARE * floor.sum():
            return float(edges[best] + 0.025)
    return None
