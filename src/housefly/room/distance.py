"""Exact distances from points of the floor plan to the footprints of solids, compiled.

A footprint is one row (kind, x, y, half length, half width, cos yaw, sin yaw): kind 0 is a
rectangle, 1 a disc whose radius is the half length. Lengths in metres.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, hypot, sin, sqrt
from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled, compiled_with_arrays
from housefly.room.model import Shape, Solid


def footprints(solids: Iterable[Solid], bottom: float, top: float) -> FloatArray:
    """Return the footprints of the solids that collide between two heights [m], shape (n, 7)."""
    rows = [
        (
            float(solid.shape is Shape.CYLINDER),
            solid.position[0],
            solid.position[1],
            solid.size[0] / 2,
            solid.size[1] / 2,
            cos(solid.yaw),
            sin(solid.yaw),
        )
        for solid in solids
        if solid.collides
        and solid.position[2] - solid.size[2] / 2 < top
        and solid.position[2] + solid.size[2] / 2 > bottom
    ]
    return np.array(rows, dtype=np.float64).reshape(-1, 7)


@compiled
def _distance(row: Any, x: float, y: float) -> float:
    dx, dy = x - row[1], y - row[2]
    if row[0] == 1.0:
        gap: float = sqrt(dx * dx + dy * dy) - row[3]
        return max(gap, 0.0)
    u = max(abs(dx * row[5] + dy * row[6]) - row[3], 0.0)
    v = max(abs(dy * row[5] - dx * row[6]) - row[4], 0.0)
    return sqrt(u * u + v * v)


@compiled
def _nearest(rows: Any, reaches: Any, xs: Any, ys: Any, cap: float, out: Any) -> None:
    for i in range(xs.size):
        for j in range(ys.size):
            best = cap
            for k in range(rows.shape[0]):
                dx, dy = xs[i] - rows[k, 1], ys[j] - rows[k, 2]
                limit = best + reaches[k]
                if abs(dx) < limit and abs(dy) < limit:
                    best = min(best, _distance(rows[k], xs[i], ys[j]))
            out[i, j] = best


@compiled_with_arrays
def _shares(
    rows: Any, xs: Any, ys: Any, edge: float, samples: int, clearance: Any, out: Any
) -> None:
    near = edge * 0.7072
    for i in range(xs.size):
        for j in range(ys.size):
            if clearance[i, j] > near:
                continue
            close = [k for k in range(rows.shape[0]) if _distance(rows[k], xs[i], ys[j]) <= near]
            hits = 0
            for a in range(samples):
                for b in range(samples):
                    x = xs[i] + ((a + 0.5) / samples - 0.5) * edge
                    y = ys[j] + ((b + 0.5) / samples - 0.5) * edge
                    for k in close:
                        if _distance(rows[k], x, y) == 0.0:
                            hits += 1
                            break
            out[i, j] = hits / (samples * samples)


def clearance_field(rows: FloatArray, xs: FloatArray, ys: FloatArray, cap: float) -> FloatArray:
    """Return the distance [m] from each point (xs[i], ys[j]) to the nearest footprint.

    At most ``cap``; shape (nx, ny).
    """
    out = np.empty((xs.size, ys.size))
    _nearest(rows, np.hypot(rows[:, 3], rows[:, 4]), xs, ys, cap, out)
    return out


def covered_shares(
    rows: FloatArray,
    xs: FloatArray,
    ys: FloatArray,
    edge: float,
    clearance: FloatArray,
    samples: int = 8,
) -> FloatArray:
    """Return the share of a square around each point that lies under a footprint, 0 to 1.

    ``edge`` is the square's side [m]; shape (nx, ny).
    """
    out = np.zeros((xs.size, ys.size))
    _shares(rows, xs, ys, edge, samples, clearance, out)
    return out


def half_diagonal(length: float, width: float) -> float:
    """Return the radius [m] of the circle around a rectangle."""
    return hypot(length, width) / 2
