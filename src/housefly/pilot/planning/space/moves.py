"""Moves between neighbouring cells of a grid, in the plane or in space.

A move is legal where every cell of the box around it is free: no corner is cut.
"""

from __future__ import annotations

from functools import cache
from itertools import product
from math import sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray


class Moves(NamedTuple):
    """The moves out of a cell of a padded grid whose cells are numbered in one row.

    Attributes:
        steps: change of the index along x, y and z, shape (m, 3).
        offsets: change of the number, shape (m,).
        lengths: [cell edges], shape (m,).
        needs: bits of the moves whose targets must be free, shape (m,).
    """

    steps: NDArray[np.int64]
    offsets: NDArray[np.int64]
    lengths: NDArray[np.float64]
    needs: NDArray[np.int64]


@cache
def moves_of(shape: tuple[int, ...]) -> Moves:
    """Return the 26 moves of a padded grid of a shape; the 8 in the plane when its depth is 1."""
    reach: tuple[int, ...] = (-1, 0, 1)
    deep = reach if shape[2] > 1 else (0,)
    steps = [step for step in product(reach, reach, deep) if any(step)]
    steps.sort(key=lambda step: (sum(map(abs, step)), step))
    number: dict[tuple[int, ...], int] = {step: bit for bit, step in enumerate(steps)}
    needs = [sum(1 << number[part] for part in _box_of(step)) for step in steps]
    offsets = [(di * shape[1] + dj) * shape[2] + dk for di, dj, dk in steps]
    return Moves(
        np.array(steps, dtype=np.int64),
        np.array(offsets, dtype=np.int64),
        np.array([sqrt(sum(map(abs, step))) for step in steps]),
        np.array(needs, dtype=np.int64),
    )


def _box_of(step: tuple[int, ...]) -> list[tuple[int, ...]]:
    """Return the steps into the cells of the box around a step, but for the one it begins in."""
    parts: tuple[tuple[int, ...], ...] = tuple((0, value) if value else (0,) for value in step)
    return [part for part in product(*parts) if any(part)]


def padded(free: Any) -> NDArray[np.bool_]:
    """Return a mask with a blocked border, so that no neighbour is off the grid.

    A grid in the plane, shape (nx, ny) or (nx, ny, 1), gets none above and below.
    """
    solid = free[:, :, None] if free.ndim == 2 else free
    deep = 0 if solid.shape[2] == 1 else 1
    return np.pad(np.asarray(solid, dtype=np.bool_), ((1, 1), (1, 1), (deep, deep)))
