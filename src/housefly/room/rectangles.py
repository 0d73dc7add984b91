"""Covers a mask with few rectangles: runs along y, merged along x while they are equal."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_CellRectangle = tuple[int, int, int, int]


def rectangles(mask: NDArray[np.bool_]) -> tuple[_CellRectangle, ...]:
    """Return disjoint rectangles (i0, j0, i1, j1), ends excluded, that cover exactly a mask.

    Both directions of runs are tried; the shorter answer wins.
    """
    upright = _merged(mask)
    flat = tuple((i0, j0, i1, j1) for j0, i0, j1, i1 in _merged(mask.T))
    return min(upright, flat, key=len)


def _merged(mask: NDArray[np.bool_]) -> tuple[_CellRectangle, ...]:
    done: list[_CellRectangle] = []
    open_runs: dict[tuple[int, int], int] = {}
    for i in range(mask.shape[0] + 1):
        runs = _runs(mask[i]) if i < mask.shape[0] else []
        for run in [run for run in open_runs if run not in runs]:
            done.append((open_runs.pop(run), run[0], i, run[1]))
        for run in runs:
            open_runs.setdefault(run, i)
    return tuple(sorted(done))


def _runs(row: NDArray[np.bool_]) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate(([0], row.view(np.int8), [0]))))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))
