"""The heading through narrow places: one for each, the one that leaves the most air, held."""

from __future__ import annotations

from math import atan2, ceil, cos, pi, sin

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import wrap_angle
from housefly.numeric import FloatArray, elementwise
from housefly.pilot.planning.space.oriented_hull import OrientedHull, oriented_clearances
from housefly.pilot.planning.space.voxels import CLEARANCE_CAP

_HEADINGS = 60
"""So many headings of half a circle are looked at: the hull is the same backwards."""
_PLACES = 25
"""At so many places of a narrow stretch."""
_TOGETHER = 25
"""Stretches with fewer rows between them are one."""


def door_headings(
    motion: FloatArray,
    is_tight: NDArray[np.bool_],
    rows: FloatArray,
    hull: OrientedHull,
    yaw: float,
    step: float,
) -> tuple[FloatArray, int] | None:
    """Return the heading at each row of a motion, and how many rows to stand before the first.

    None when there is no time to turn between two narrow stretches.

    Args:
        motion: rows of a trajectory, shape (n, 9).
        is_tight: where the heading matters, shape (n,).
        rows: everything in the room, shape (m, 11).
        hull: of the drone.
        yaw: heading at the start [rad].
        step: largest change of the heading from one row to the next [rad].

    Returns:
        Headings [rad], shape (k + n,), and k.
    """
    parts: list[FloatArray] = []
    heading, at, waited = yaw, 0, 0
    for first, last in _stretches(is_tight):
        wanted = _best_heading(motion[first : last + 1], rows, hull)
        turn = wrap_angle(wanted - heading)
        missing = ceil(abs(turn) / step) - (first - at)
        if missing > 0 and parts:
            return None
        waited = max(missing, 0) if not parts else waited
        ticks = np.arange(first - at + max(missing, 0))
        turned = heading + np.clip(ticks * np.sign(turn) * step, -abs(turn), abs(turn))
        parts += [turned, np.full(last + 1 - first, heading + turn)]
        heading, at = heading + turn, last + 1
    parts.append(np.full(len(motion) - at, heading))
    return np.concatenate(parts), waited


def _stretches(is_tight: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first and last rows of stretches where the heading matters."""
    found: list[tuple[int, int]] = []
    for n in np.nonzero(is_tight)[0].tolist():
        if found and n - found[-1][1] <= _TOGETHER:
            found[-1] = (found[-1][0], n)
        else:
            found.append((n, n))
    return found


def _best_heading(motion: FloatArray, rows: FloatArray, hull: OrientedHull) -> float:
    """Return the heading with the most air all along, the one nearer to that of the motion."""
    picks = np.unique(np.linspace(0, len(motion) - 1, _PLACES).astype(np.int64))
    yaws = np.arange(_HEADINGS) * pi / _HEADINGS
    poses = np.empty((len(yaws), len(picks), 4))
    poses[:, :, :3], poses[:, :, 3] = motion[picks, :3], yaws[:, None]
    clear = oriented_clearances(rows, poses.reshape(-1, 4), hull, CLEARANCE_CAP)
    nearest = clear.reshape(len(yaws), -1).min(axis=1)
    # Of equals the middle: the air is the same on both sides of it.
    good = 2.0 * yaws[nearest >= nearest.max() - 1e-3]
    best = 0.5 * atan2(elementwise(sin, good).sum(), elementwise(cos, good).sum())
    moved = motion[-1, :2] - motion[0, :2]
    ahead = atan2(moved[1], moved[0])
    return best if abs(wrap_angle(best - ahead)) <= pi / 2 else wrap_angle(best + pi)
