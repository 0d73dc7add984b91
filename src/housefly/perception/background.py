"""Expected range of each beam of a scanner in the modelled room, computed once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import cos, inf, sin
from typing import Any

import numpy as np

from housefly.config.laser import LaserConfig
from housefly.numeric import FloatArray, compiled
from housefly.room.distance import footprints
from housefly.room.model import Solid

HALF_THICKNESS = 0.02
"""Solids within this of the scanner's plane stop its beams [m]: beams widen, walls tilt."""


@compiled
def _entry(row: Any, x: float, y: float, dx: float, dy: float) -> float:
    """Return the distance along a ray to a footprint; infinite if it misses."""
    ox, oy = x - row[1], y - row[2]
    if row[0] == 1.0:
        along = -(ox * dx + oy * dy)
        off = ox * ox + oy * oy - along * along
        inside = row[3] * row[3] - off
        if inside < 0.0:
            return np.inf
        half = np.sqrt(inside)
        if along - half > 0.0:
            return float(along - half)
        return float(along + half) if along + half > 0.0 else np.inf
    u, v = ox * row[5] + oy * row[6], oy * row[5] - ox * row[6]
    du, dv = dx * row[5] + dy * row[6], dy * row[5] - dx * row[6]
    near, far = -np.inf, np.inf
    for at, way, half in ((u, du, row[3]), (v, dv, row[4])):
        if abs(way) < 1e-12:
            if abs(at) > half:
                return np.inf
            continue
        a, b = (-half - at) / way, (half - at) / way
        near, far = max(near, min(a, b)), min(far, max(a, b))
    if far < near or far <= 0.0:
        return np.inf
    return float(near) if near > 0.0 else float(far)


@compiled
def _cast(rows: Any, x: float, y: float, angles: Any, out: Any) -> None:
    for n in range(angles.size):
        dx, dy = cos(angles[n]), sin(angles[n])
        best = np.inf
        for k in range(rows.shape[0]):
            best = min(best, _entry(rows[k], x, y, dx, dy))
        out[n] = best


def expected_ranges(
    solids: Iterable[Solid], laser: LaserConfig, first_angle: float, step: float, beams: int
) -> FloatArray:
    """Return the distance [m] at which each beam hits the room; infinite if it hits nothing.

    Args:
        solids: of the room; those that the drone cannot touch stop beams as well.
        laser: where the scanner is.
        first_angle: of the first beam from the scanner's front [rad].
        step: from beam to beam [rad].
        beams: how many.
    """
    cut = [replace(solid, collides=True) for solid in solids]
    rows = footprints(cut, laser.z - HALF_THICKNESS, laser.z + HALF_THICKNESS)
    angles = laser.yaw + first_angle + np.arange(beams) * step
    out = np.full(beams, inf)
    _cast(rows, laser.x, laser.y, angles, out)
    return out
