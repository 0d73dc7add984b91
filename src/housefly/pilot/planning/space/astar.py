"""A* between cells of a grid, in the plane (8 moves) or in space (26), exact and compiled.

Open cells wait in buckets by the length of the way through them, so no heap is needed; inside a
bucket the newest leaves first. A cell that turns out to be nearer is opened again, so the order
inside a bucket costs time and never length. Ties are settled by that order alone: the same grid
gives the same answer on every machine.
"""

from __future__ import annotations

from math import sqrt
from typing import Any

import numpy as np

from housefly.numeric import compiled, compiled_with_arrays
from housefly.pilot.planning.space.moves import Moves

BUCKET = 0.5
"""Lengths that share a bucket differ by less than this [cell edges]."""
CELL_MARK = np.dtype(
    [("length", "f8"), ("mark", "i4"), ("after", "i4"), ("before", "i4"), ("move", "i4")]
)
"""What a search writes at a cell, side by side because it is read together: length of the way to it
[cell edges]; whether it is open or closed; its neighbours in its bucket; the move that led there.
"""
_SAME = 1e-10
"""A way must be shorter by this to count as shorter [cell edges]: sums of roots are not exact."""
_SQRT2, SQRT3 = sqrt(2.0), sqrt(3.0)


@compiled
def octile_distance(dx: int, dy: int, dz: int) -> float:
    """Return the length [cell edges] of a shortest way in empty space, for counts of cells."""
    most, least = max(dx, dy, dz), min(dx, dy, dz)
    middle = dx + dy + dz - most - least
    return float(SQRT3 * least + _SQRT2 * (middle - least) + (most - middle))


@compiled_with_arrays
def shortest_length(
    free: Any,
    weights: Any,
    start: int,
    goal: int,
    shape: Any,
    moves: Moves,
    stamp: int,
    heads: Any,
    marks: Any,
) -> float:
    """Return the length of a shortest way [cell edges], infinite when there is none.

    A cell's ``mark`` is ``stamp`` where it is open and ``stamp + 1`` where it is closed. The open
    cells of a bucket are a list: ``after`` is -1 at its end, ``before`` -2 less the bucket at its
    head.
    """
    weighted = weights.size == free.size
    mask, count = heads.size - 1, moves.lengths.size
    row, plane = shape[2], shape[1] * shape[2]
    gi, gj, gk = goal // plane, goal % plane // row, goal % row
    for bucket in range(heads.size):
        heads[bucket] = -1
    i, j, k = start // plane, start % plane // row, start % row
    bucket = int(octile_distance(abs(i - gi), abs(j - gj), abs(k - gk)) / BUCKET)
    heads[bucket & mask] = start
    first_mark = marks[start]
    first_mark.after, first_mark.before = -1, -2 - (bucket & mask)
    first_mark.mark, first_mark.length, first_mark.move = stamp, 0.0, -1
    waiting, best = 1, np.inf
    while waiting > 0 and bucket * BUCKET < best:
        cell = heads[bucket & mask]
        if cell < 0:
            bucket += 1
            continue
        following = marks[cell].after
        heads[bucket & mask] = following
        if following >= 0:
            marks[following].before = -2 - (bucket & mask)
        marks[cell].mark = stamp + 1
        waiting -= 1
        here = marks[cell].length
        i, j, k = cell // plane, cell % plane // row, cell % row
        if here + octile_distance(abs(i - gi), abs(j - gj), abs(k - gk)) >= best - _SAME:
            continue
        around = 0
        for m in range(count):
            if free[cell + moves.offsets[m]]:
                around |= 1 << m
        for m in range(count):
            if around & moves.needs[m] != moves.needs[m]:
                continue
            to = cell + moves.offsets[m]
            step = moves.lengths[m]
            if weighted:
                step *= 1.0 + 0.5 * (weights[cell] + weights[to])
            length = here + step
            there = marks[to]
            known = there.mark >= stamp
            if known and length >= there.length - _SAME:
                continue
            if there.mark == stamp:
                before, after = there.before, there.after
                if after >= 0:
                    marks[after].before = before
                if before >= 0:
                    marks[before].after = after
                else:
                    heads[-2 - before] = after
                waiting -= 1
            there.length, there.move, there.mark = length, m, stamp
            ahead = octile_distance(
                abs(i + moves.steps[m, 0] - gi),
                abs(j + moves.steps[m, 1] - gj),
                abs(k + moves.steps[m, 2] - gk),
            )
            if to == goal:
                best = length
            slot = max(bucket, int((length + ahead) / BUCKET)) & mask
            first = heads[slot]
            there.after, there.before = first, -2 - slot
            if first >= 0:
                marks[first].before = to
            heads[slot] = to
            waiting += 1
    return best


@compiled_with_arrays
def walked_back(marks: Any, offsets: Any, goal: int, out: Any) -> int:
    """Write the cells from ``goal`` back to the start into ``out``; return how many."""
    cell, count = goal, 1
    out[0] = cell
    while marks[cell].move >= 0:
        cell -= offsets[marks[cell].move]
        out[count] = cell
        count += 1
    return count
