"""A 3-D scan as a draft: columns where points are, unexplored where nobody looked."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from housefly.errors import RoomError
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

EDGE = 0.05
"""Of a cell [m]."""
LEVELS = (0.08, 0.45, 0.85, 1.35, 2.0)
"""Heights between which points are told apart [m]; the usual flight height lies between the third
and fourth.
"""
_POINTS_MIN, _NOISE_SHARE = 2, 0.1
"""Fewer points in a cell, or a smaller share of what cells usually hold, are noise."""
_CELLS_MAX = 4_000_000


def scan(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the room of a scan (PLY, OBJ, glTF, STL).

    Raises:
        RoomError: it cannot be read, or holds no floor.
        MissingPartError: trimesh is not installed.
    """
    cloud = read_point_cloud(path, hints)
    inside = cloud.points[cloud.points[:, 2] > -0.3]
    low, high = np.percentile(inside[:, :2], (0.05, 99.95), axis=0)
    origin = np.floor((low - 2 * EDGE) / EDGE) * EDGE
    nx, ny = (int(n) for n in np.ceil((high + 2 * EDGE - origin) / EDGE))
    if nx * ny > _CELLS_MAX:
        raise RoomError(
            f"{path.name} covers {nx * ny * EDGE**2:.0f} m^2; cut out the part to fly in"
        )
    layers, seen = _layers(inside, origin, (nx, ny))
    ceiling = _ceiling(inside)
    top = draft.height if ceiling is None else round(ceiling, 2)
    boxes = tuple(_boxes(layers, seen, top))
    refuse_too_many(boxes, path.name)
    length, width = round(nx * EDGE, 4), round(ny * EDGE, 4)
    x, y = origin
    notes = (
        *cloud.notes,
        f"{path.name}: {length:.2f} m x {width:.2f} m, {len(boxes)} boxes from {len(inside)}"
        f" points; ceiling {top:.2f} m"
        + ("" if ceiling is not None else " (not in the scan: as usual)"),
        "floor that no point was measured on is unexplored, and not flown over",
        f"the room begins at (0, 0), which the scan calls ({x:.2f}, {y:.2f}) m",
    )
    found = replace(draft, bounds=(0.0, 0.0, length, width), scanned=boxes, height=top)
    return Imported(found, notes)


def _layers(
    points: FloatArray, origin: FloatArray, shape: tuple[int, int]
) -> tuple[list[Mask], Mask]:
    """Return which cells are occupied between each two levels, and which were seen at all."""
    cells = np.floor((points[:, :2] - origin) / EDGE).astype(np.int64)
    within = ((cells >= 0) & (cells < shape)).all(axis=1)
    cells, heights = cells[within], points[within, 2]
    flat = cells[:, 0] * shape[1] + cells[:, 1]

    def counted(low: float, high: float) -> Mask:
        chosen = flat[(heights >= low) & (heights < high)]
        counts = np.bincount(chosen, minlength=shape[0] * shape[1])
        usual = float(np.median(counts[counts > 0])) if chosen.size else 0.0
        return np.asarray(counts >= max(_POINTS_MIN, _NOISE_SHARE * usual)).reshape(shape)

    layers = [counted(low, high) for low, high in pairwise(LEVELS)]
    return layers, without_holes(counted(-0.3, LEVELS[-1]))


def _boxes(layers: list[Mask], seen: Mask, ceiling: float) -> Iterator[DraftBox]:
    """Yield columns from the floor up to the highest level that is occupied without a gap above.

    What hangs above the flight height only begins there; under it nothing is taken to be free
    below the flight height, because a scan rarely looks there.
    """
    low, middle, flight, high = layers
    wall = flight & high
    yield from boxes_of_cells(wall, EDGE, ceiling, "wall")
    yield from boxes_of_cells(flight & ~high, EDGE, LEVELS[3], "tall thing")
    yield from boxes_of_cells(middle & ~flight, EDGE, LEVELS[2], "thing")
    yield from boxes_of_cells(low & ~middle & ~flight, EDGE, LEVELS[1], "low thing")
    yield from boxes_of_cells(
        high & ~flight, EDGE, min(LEVELS[4], ceiling), "hanging thing", bottom=LEVELS[3]
    )
    unknown = ~(seen | low | middle | flight | high)
    yield from boxes_of_cells(unknown, EDGE, ceiling, "unexplored")


def _ceiling(points: FloatArray) -> float | None:
    """Return the height of a level that holds many points above 1.9 m, None when none does."""
    heights = points[:, 2]
    above = heights[(heights > 1.9) & (heights < 20.0)]
    if above.size == 0:
        return None
    counts, edges = np.histogram(above, bins=np.arange(1.9, float(above.max()) + 0.1, 0.05))
    best = int(counts.argmax()) if counts.size else 0
    if counts.size == 0 or counts[best] < 0.02 * heights.size:
        return None
    return float(edges[best] + 0.025)
