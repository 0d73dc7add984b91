"""Dijkstra's shortest paths on the grid as in the paper (IV-B): 4 moves of unit cost.

With equal costs Dijkstra's priority queue holds at most two different distances, so its buckets
reduce to one first-in first-out queue: cells leave it in the order of their distance. Ties are
settled by order alone: neighbours are entered forward (+x), left (+y), back (-x), right (-y), so
the same grid gives the same answer on every machine.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled_with_arrays
from housefly.room.grid import CellIndex

CellDistances = NDArray[np.int32]
FreeMask = NDArray[np.bool_]


UNREACHED = -1


@compiled_with_arrays
def _settle(free: Any, start: int, goal: int, distance: Any, queue: Any) -> int:
    """Fill the distances from ``start`` until ``goal`` is settled; goal -1 settles all cells.

    ``free`` and ``distance`` carry a blocked border of one cell, so that no neighbour is off the
    grid. Returns the number of settled cells.
    """
    stride = free.shape[1]
    open_cell = free.ravel()
    moves = (stride, 1, -stride, -1)
    distance[start] = 0
    queue[0] = start
    head, tail = 0, 1
    while head < tail:
        cell = queue[head]
        head += 1
        if cell == goal:
            break
        step = distance[cell] + 1
        for move in moves:
            neighbour = cell + move
            if open_cell[neighbour] and distance[neighbour] < 0:
                distance[neighbour] = step
                queue[tail] = neighbour
                tail += 1
    return head


@compiled_with_arrays
def _walk_back(distance: Any, stride: int, goal: int, out: Any) -> int:
    """Write the cells from ``goal`` to the start into ``out``, as straight as a shortest way is."""
    moves = (stride, 1, -stride, -1)
    cell, heading, count = goal, 0, 0
    out[0] = goal
    while distance[cell] > 0:
        wanted = distance[cell] - 1
        if heading == 0 or distance[cell + heading] != wanted:
            for move in moves:
                if distance[cell + move] == wanted:
                    heading = move
                    break
        cell += heading
        count += 1
        out[count] = cell
    return count + 1


def distances(free: FreeMask, start: CellIndex, goal: CellIndex | None = None) -> CellDistances:
    """Return the number of moves from ``start`` to each cell, UNREACHED without a way.

    Args:
        free: cells that may be entered, shape (nx, ny).
        start: a cell of the grid; it counts as free.
        goal: stop as soon as this one is settled; farther cells then read UNREACHED.
    """
    flat, stride = _search(free, start, goal)
    return np.ascontiguousarray(flat.reshape(-1, stride)[1:-1, 1:-1])


def shortest_path(free: FreeMask, start: CellIndex, goal: CellIndex) -> tuple[CellIndex, ...]:
    """Return the cells of a shortest path, both ends included; empty when there is no way.

    Among paths of equal length it walks back from the goal and turns only where it must.
    """
    flat, stride = _search(free, start, goal)
    target = _flat(goal, stride)
    if not free[goal] or flat[target] == UNREACHED:
        return ()
    out = np.empty(flat[target] + 1, dtype=np.int64)
    _walk_back(flat, stride, target, out)
    return tuple((int(cell) // stride - 1, int(cell) % stride - 1) for cell in out[::-1])


def _search(free: FreeMask, start: CellIndex, goal: CellIndex | None) -> tuple[CellDistances, int]:
    padded = np.zeros((free.shape[0] + 2, free.shape[1] + 2), dtype=np.bool_)
    padded[1:-1, 1:-1] = free
    stride = padded.shape[1]
    distance = np.full(padded.size, UNREACHED, dtype=np.int32)
    queue = np.empty(padded.size, dtype=np.int32)
    _settle(
        padded, _flat(start, stride), -1 if goal is None else _flat(goal, stride), distance, queue
    )
    return distance, stride


def _flat(cell: CellIndex, stride: int) -> int:
    return (cell[0] + 1) * stride + cell[1] + 1
