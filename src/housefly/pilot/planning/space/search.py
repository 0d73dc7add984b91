"""Shortest ways on one grid, asked for again and again: by A*, in the plane or in space."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import ceil, inf, log2
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import FloatArray
from housefly.pilot.planning.space.astar import (
    BUCKET,
    CELL_MARK,
    SQRT3,
    shortest_length,
    walked_back,
)
from housefly.pilot.planning.space.moves import Moves, moves_of, padded
from housefly.pilot.planning.space.voxels import VoxelIndex


@dataclass(frozen=True, slots=True)
class CellPath:
    """A shortest way through cells.

    Attributes:
        cells: both ends included; empty when there is no way.
        cost: its length [cell edges], weights included; infinite when there is no way.
    """

    cells: tuple[VoxelIndex, ...] = ()
    cost: float = inf


NO_WAY = CellPath()


class SearchScratch:
    """What one search after the other writes into: making it takes as long as a search.

    Attributes:
        stamp: what marks the open cells of the last search.
    """

    def __init__(self) -> None:
        self.stamp = -1
        self._marks: NDArray[Any] = np.zeros(0, CELL_MARK)

    def marks(self, size: int) -> NDArray[Any]:
        """Return room for a grid of so many cells, and count the search."""
        if len(self._marks) != size:
            self.stamp = -1
            self._marks = np.zeros(size, CELL_MARK)
            self._marks["mark"] = -1
        self.stamp += 2
        return self._marks


@dataclass(slots=True, eq=False)
class CellSearch:
    """Shortest ways on one grid; the arrays of the last search serve the next one.

    Args:
        free: cells that may be entered, shape (nx, ny) or (nx, ny, nz).
        weights: a move costs its length times one more than the mean of these at its ends, 0 or
            more; the same shape.
        scratch: to be shared by searches that take turns.
    """

    free: NDArray[np.bool_]
    weights: FloatArray | None = None
    scratch: SearchScratch = field(default_factory=SearchScratch)
    _shape: tuple[int, ...] = field(init=False)
    _moves: Moves = field(init=False)
    _flat: Any = field(init=False)
    _weights: Any = field(init=False)
    _heads: Any = field(init=False)

    def __post_init__(self) -> None:
        grid = padded(self.free)
        self._shape, self._flat = grid.shape, grid.ravel()
        self._moves = moves_of(grid.shape)
        self._weights = np.zeros(0)
        most = 0.0
        if self.weights is not None:
            most = float(self.weights.max())
            raised = np.zeros(grid.shape)
            raised[self._inside()] = self.weights.reshape(self._inner())
            self._weights = raised.ravel()
        buckets = 2 ** ceil(log2(2.0 * SQRT3 * (1.0 + most) / BUCKET + 4.0))
        self._heads = np.empty(buckets, dtype=np.int32)

    def _inner(self) -> tuple[int, ...]:
        return (*self.free.shape, 1)[:3]

    def _inside(self) -> tuple[slice, ...]:
        deep = slice(None) if self._inner()[2] == 1 else slice(1, -1)
        return slice(1, -1), slice(1, -1), deep

    def path(self, start: VoxelIndex, goal: VoxelIndex) -> CellPath:
        """Return a shortest way between two cells; the third index is 0 in a plane.

        There is none from or to a cell that is blocked or off the grid.
        """
        if not (self._holds(start) and self._holds(goal)):
            return NO_WAY
        here, there = self._number(start), self._number(goal)
        if not (self._flat[here] and self._flat[there]):
            return NO_WAY
        if here == there:
            return CellPath((start,), 0.0)
        marks = self.scratch.marks(self._flat.size)
        cost = shortest_length(
            self._flat,
            self._weights,
            here,
            there,
            self._shape,
            self._moves,
            self.scratch.stamp,
            self._heads,
            marks,
        )
        if cost == inf:
            return NO_WAY
        return CellPath(self._cells(marks, there), cost)

    def _holds(self, cell: VoxelIndex) -> bool:
        return all(0 <= n < size for n, size in zip(cell, self._inner(), strict=True))

    def _cells(self, marks: Any, goal: int) -> tuple[VoxelIndex, ...]:
        out = np.empty(self._flat.size, dtype=np.int32)
        count = walked_back(marks, self._moves.offsets, goal, out)
        indices = np.stack(np.unravel_index(out[:count][::-1], self._shape), axis=1)
        indices[:, :2] -= 1
        if self._inner()[2] > 1:
            indices[:, 2] -= 1
        return tuple((i, j, k) for i, j, k in indices.tolist())

    def _number(self, cell: VoxelIndex) -> int:
        deep = 0 if self._inner()[2] == 1 else 1
        index = (cell[0] + 1, cell[1] + 1, cell[2] + deep)
        return int(np.ravel_multi_index(index, self._shape))
