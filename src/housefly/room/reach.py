"""Which floor belongs to the room: a flood fill from the home pad that no wall lets through."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2
from housefly.numeric import FloatArray, compiled_with_arrays

Mask = NDArray[np.bool_]


@compiled_with_arrays
def flood(open_cells: Any, i: int, j: int) -> Any:
    """Return the open cells 4-connected to the cell (i, j); none when that one is closed."""
    nx, ny = open_cells.shape
    seen = np.zeros((nx, ny), dtype=np.bool_)
    if not open_cells[i, j]:
        return seen
    queue = np.empty(nx * ny, dtype=np.int64)
    queue[0], head, tail = i * ny + j, 0, 1
    seen[i, j] = True
    while head < tail:
        x, y = queue[head] // ny, queue[head] % ny
        head += 1
        for dx, dy in ((1, 0), (0, 1), (-1, 0), (0, -1)):
            u, v = x + dx, y + dy
            if 0 <= u < nx and 0 <= v < ny and open_cells[u, v] and not seen[u, v]:
                seen[u, v] = True
                queue[tail] = u * ny + v
                tail += 1
    return seen


def reachable(
    clearance: FloatArray, xs: FloatArray, ys: FloatArray, edge: float, home: Vec2
) -> Mask:
    """Return the cells from whose middle a point can move to the home pad; shape (nx, ny).

    Only cells with more than half their diagonal of clearance conduct: of two neighbours on
    opposite sides of a wall at least one is closer than that, so even a line of no thickness is
    tight. Cells that touch a conducting one belong to the floor as well.

    Args:
        clearance: distance from each middle to the nearest footprint [m], shape (nx, ny).
        xs: x of the middles [m].
        ys: y of the middles [m].
        edge: cell edge [m].
        home: position of the home pad [m].
    """
    open_cells = clearance > 0.7072 * edge
    i, j = int(np.abs(xs - home[0]).argmin()), int(np.abs(ys - home[1]).argmin())
    mask = np.pad(np.asarray(flood(open_cells, i, j), dtype=np.bool_), 1)
    grown = np.zeros(clearance.shape, dtype=np.bool_)
    nx, ny = clearance.shape
    for dx in range(3):
        for dy in range(3):
            grown |= mask[dx : dx + nx, dy : dy + ny]
    return grown & (clearance > 0.0)
