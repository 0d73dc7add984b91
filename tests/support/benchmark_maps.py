"""Maps with known answers from ../shared/data/maps: grids, voxels, and a grid that changes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import floor, log10
from pathlib import Path

import numpy as np

Cell3 = tuple[int, int, int]
Mask = np.ndarray


@dataclass(frozen=True, slots=True)
class Query:
    """Two cells and the length of a shortest way between them, as the file has it."""

    start: Cell3
    goal: Cell3
    length: float

    def agrees(self, length: float) -> bool:
        """Return whether a length is the one asked for: to 1e-3, or to the six digits printed."""
        half_digit = 0.5 * 10.0 ** (floor(log10(max(self.length, 1.0))) - 5)
        return abs(length - self.length) <= max(1e-3, 1.0001 * half_digit)


def read_grid(path: Path) -> Mask:
    """Return which cells are free, shape (width, height)."""
    return _free(path.read_text().splitlines()[4:])


def grid_queries(path: Path) -> Iterator[Query]:
    """Yield the queries of a .scen file."""
    for line in path.read_text().splitlines()[1:]:
        words = line.split()
        if len(words) == 9:
            x0, y0, x1, y1 = (int(word) for word in words[4:8])
            yield Query((x0, y0, 0), (x1, y1, 0), float(words[8]))


def read_voxels(path: Path) -> Mask:
    """Return which voxels are free."""
    head, *lines = path.read_text().splitlines()
    free = np.ones([int(word) for word in head.split()[1:]], dtype=np.bool_)
    taken = np.array([line.split() for line in lines if line.strip()], dtype=np.int64)
    free[tuple(taken.T)] = False
    return free


def voxel_queries(path: Path) -> Iterator[Query]:
    """Yield the queries of a .3dscen file."""
    for line in path.read_text().splitlines()[2:]:
        words = line.split()
        if len(words) >= 7:
            x0, y0, z0, x1, y1, z1 = (int(word) for word in words[:6])
            yield Query((x0, y0, z0), (x1, y1, z1), float(words[6]))


def dynamic_queries(folder: Path) -> Iterator[tuple[Mask, Query]]:
    """Yield a changing map, new only when it changed, and the queries asked of it."""
    patches = _patches((folder / "dao_arena2.patch").read_text().splitlines())
    lines = (folder / "dao_arena2.scen").read_text().splitlines()
    height, width = (int(line.split()[1]) for line in lines[1:3])
    free = np.ones((width, height), dtype=np.bool_)
    for line in lines[6:]:
        words = line.split()
        if words[0] == "P":
            patch, x, y = patches[int(words[2])], int(words[3]), int(words[4])
            free = free.copy()
            free[x : x + patch.shape[0], y : y + patch.shape[1]] = patch
        else:
            x0, y0, x1, y1 = (int(word) for word in words[2:6])
            yield free, Query((x0, y0, 0), (x1, y1, 0), float(words[6]))


def _patches(lines: list[str]) -> list[Mask]:
    found, at = [], 2
    while at < len(lines):
        height = int(lines[at + 1].split()[1])
        found.append(_free(lines[at + 4 : at + 4 + height]))
        at += 4 + height
    return found


def _free(rows: list[str]) -> Mask:
    return np.array([[cell in ".GS" for cell in row] for row in rows]).T.copy()
