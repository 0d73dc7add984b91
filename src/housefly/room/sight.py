"""Straight lines of sight through the room, exact for boxes and upright cylinders, compiled.

What hides is one row (kind, x, y, z, half length, half width, half height, cos yaw, sin yaw): kind
0 is a box, 1 an upright cylinder whose radius is the half length. Lengths in metres.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, inf, sin, sqrt
from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled
from housefly.room.model import Shape, Solid
from housefly.room.reach import Mask

_CLEAR = 0.5
"""What is less opaque than this, glass, hides nothing."""
_TOUCH = 0.03
"""What a line meets so near to its end belongs to what is looked at, unless told [m]."""


def hiding_rows(solids: Iterable[Solid], *, glass: bool = False) -> FloatArray:
    """Return the rows of the solids that hide what is behind them, shape (n, 9).

    ``glass`` True lets glass hide, too: what flashes infrared light sees itself in it.
    """
    rows = [
        (
            float(solid.shape is Shape.CYLINDER),
            *solid.position,
            *(extent / 2 for extent in solid.size),
            cos(solid.yaw),
            sin(solid.yaw),
        )
        for solid in solids
        if solid.collides and (glass or solid.colour[3] >= _CLEAR)
    ]
    return np.array(rows, dtype=np.float64).reshape(-1, 9)


def upright_row(x: float, y: float, radius: float, bottom: float, top: float) -> FloatArray:
    """Return the row of an upright cylinder, a person or an unknown obstacle, shape (1, 9) [m]."""
    middle, half = (bottom + top) / 2, (top - bottom) / 2
    return np.array([[1.0, x, y, middle, radius, radius, half, 1.0, 0.0]])


@compiled
def _slab(start: float, ray: float, half: float) -> tuple[float, float]:
    """Return between which shares of a ray it lies between -half and half; (1, 0) for never."""
    if abs(ray) < 1e-12:
        return (-inf, inf) if abs(start) < half else (1.0, 0.0)
    first, second = (-half - start) / ray, (half - start) / ray
    return min(first, second), max(first, second)


@compiled
def _disc(u: float, v: float, du: float, dv: float, radius: float) -> tuple[float, float]:
    """Return between which shares of a ray it lies in a disc; (1, 0) for never."""
    a, b, c = du * du + dv * dv, u * du + v * dv, u * u + v * v - radius * radius
    if a < 1e-12:
        return (-inf, inf) if c < 0.0 else (1.0, 0.0)
    square = b * b - a * c
    if square <= 0.0:
        return 1.0, 0.0
    root = sqrt(square)
    return (-b - root) / a, (-b + root) / a


@compiled
def _hides(row: Any, eye: Any, ray: Any, end: float) -> bool:
    """Return whether a solid lies on a ray before the share ``end`` of it."""
    x, y, z = eye[0] - row[1], eye[1] - row[2], eye[2] - row[3]
    low, high = _slab(z, ray[2], row[6])
    if low >= high or low >= end or high <= 0.0:
        return False
    u, v = x * row[7] + y * row[8], y * row[7] - x * row[8]
    du, dv = ray[0] * row[7] + ray[1] * row[8], ray[1] * row[7] - ray[0] * row[8]
    if row[0] == 1.0:
        enter, leave = _disc(u, v, du, dv, row[4])
    else:
        enter, leave = _slab(u, du, row[4])
        second, third = _slab(v, dv, row[5])
        enter, leave = max(enter, second), min(leave, third)
    enter, leave = max(enter, low), min(leave, high)
    return bool(enter < leave and leave > 0.0 and enter < end)


@compiled
def _look(rows: Any, reaches: Any, eyes: Any, targets: Any, touch: float, out: Any) -> None:
    for i in range(eyes.shape[0]):
        for j in range(targets.shape[0]):
            ray = (
                targets[j, 0] - eyes[i, 0],
                targets[j, 1] - eyes[i, 1],
                targets[j, 2] - eyes[i, 2],
            )
            flat = ray[0] * ray[0] + ray[1] * ray[1]
            length = sqrt(flat + ray[2] * ray[2])
            end = 1.0 - touch / max(length, touch)
            out[i, j] = True
            for k in range(rows.shape[0]):
                x, y = rows[k, 1] - eyes[i, 0], rows[k, 2] - eyes[i, 1]
                along = x * ray[0] + y * ray[1]
                reach = reaches[k]
                if along < -reach * length or along > flat + reach * length:
                    continue
                across = x * ray[1] - y * ray[0]
                if across * across > reach * reach * flat:
                    continue
                if _hides(rows[k], eyes[i], ray, end):
                    out[i, j] = False
                    break


def in_sight(
    rows: FloatArray, eyes: FloatArray, targets: FloatArray, touch: float = _TOUCH
) -> Mask:
    """Return from which eyes which targets are in sight.

    Args:
        rows: what hides, from ``hiding_rows``.
        eyes: world [m], shape (m, 3).
        targets: world [m], shape (n, 3).
        touch: what a line meets so near to its end belongs to the target [m].

    Returns:
        shape (m, n).
    """
    out = np.empty((len(eyes), len(targets)), dtype=np.bool_)
    reaches = np.where(rows[:, 0] == 1.0, rows[:, 4], np.hypot(rows[:, 4], rows[:, 5]))
    _look(
        rows,
        reaches,
        np.ascontiguousarray(eyes, dtype=np.float64),
        np.ascontiguousarray(targets, dtype=np.float64),
        touch,
        out,
    )
    return out
