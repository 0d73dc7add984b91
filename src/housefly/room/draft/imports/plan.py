"""The shapes of a floor plan as walls, whatever file they came from."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import pairwise
from math import ceil, dist, hypot

import numpy as np

from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.messages.words import Words, figure, joined, literal
from housefly.room.draft.imports.cells import boxes_of_cells
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.drawing import LeftOut, PlanDrawing, PlanShape, left_out_notes
from housefly.room.draft.imports.strays import without_strays
from housefly.room.draft.imports.units import plan_unit
from housefly.room.draft.model import DraftBox, DraftWall, SiteDraft
from housefly.room.reach import flood

_LINES_MAX = 2000
_LINE_MIN, _GAP = 0.02, 0.001
"""Shapes that are not longer are left out; ends that are nearer to each other are one [m]."""
_LINE_THICKNESS, _WIDTH_MAX = 0.03, 0.6
"""Walls in a plan are drawn by their faces; each face becomes so thick, and as thick as it is drawn
up to that width, beyond which it is no wall's [m].
"""
_EDGE = 0.1
"""Of the cells that tell inside from outside [m]."""
_INSIDE_SHARE = 0.4
"""With less of the floor inside, the outer walls have a hole."""
_LAYERS_MAX = 20

_PARTS = (
    # English, German, Dutch, French, Spanish, Portuguese, Italian
    "wall", "partition", "mauer", "wand", "waend", "muur", "cloison", "paroi", "muro", "muraille",
    "pared", "parede", "tabique", "parete", "pareti", "tramezz", "muratura",
    # Swedish, Norwegian, Danish, Finnish, Polish, Czech, Russian, Turkish
    "vagg", "vegg", "væg", "seina", "scian", "stena", "steny", "стен", "duvar",
    # Japanese, Chinese, Korean
    "壁", "間仕切", "墙", "牆", "墻", "隔断", "벽",
)  # fmt: skip
_WHOLE = frozenset({"mur", "murs", "muri", "zed", "zdi"})
"""French, Italian, Czech: inside of longer words they mean something else."""
_LETTERS = re.compile(r"[^\W\d_]+")


def plan_draft(draft: SiteDraft, drawing: PlanDrawing, name: str, hints: ImportHints) -> Imported:
    """Return the draft with a plan's shapes as walls; what is left out is counted in the notes.

    Args:
        draft: what is known besides.
        drawing: of the plan.
        name: of the file.
        hints: what was said about it.

    Raises:
        RoomError: there are no shapes or too many, or the unit cannot be told.
    """
    if not drawing.shapes:
        notes = (*drawing.notes, *left_out_notes(drawing.left_out))
        empty = Words(
            "{name} holds no lines: are its walls drawn as lines or shapes, not as a picture?",
            name=name,
        )
        raise RoomError(joined("; ", (empty, *notes)))
    on_walls, layer_note = _of_walls(drawing, hints)
    chosen, strays = without_strays(on_walls)
    for shape in strays:
        drawing.leave_out(LeftOut.FAR, shape.kind)
    ends = np.array([point for shape in chosen for point in shape.points])
    low, high = ends.min(axis=0), ends.max(axis=0)
    unit, unit_note = plan_unit(
        (float(high[0] - low[0]), float(high[1] - low[1])), name, hints, drawing
    )
    walls = tuple(_walls(chosen, (float(low[0]), float(low[1])), unit, drawing))
    if len(walls) > _LINES_MAX:
        raise RoomError(
            Words(
                "{name} has {n} lines, at most {m} are read: say which layers hold the walls; it"
                " has: {thing}",
                name=name,
                n=figure(len(walls)),
                m=figure(_LINES_MAX),
                thing=_layers(drawing.shapes),
            )
        )
    length, width = (float(side) * unit for side in high - low)
    outside, outside_note = _outside(walls, length, width, draft.height)
    notes = (
        *drawing.notes,
        layer_note,
        unit_note,
        outside_note,
        *left_out_notes(drawing.left_out),
        Words(
            "{name}: {a} m x {b} m, {n} lines became walls up to the ceiling (doors and windows"
            " too, where they are drawn on the same layer)",
            name=name,
            a=figure(length, ".2f"),
            b=figure(width, ".2f"),
            n=figure(len(walls)),
        ),
    )
    bounds = (0.0, 0.0, round(length, 3), round(width, 3))
    return Imported(replace(draft, bounds=bounds, walls=walls, scanned=outside), notes)


def _outside(
    walls: tuple[DraftWall, ...], length: float, width: float, height: float
) -> tuple[tuple[DraftBox, ...], Words]:
    """Return boxes where no way leads to from inside, and a word on whether the walls close."""
    nx, ny = ceil(length / _EDGE) + 2, ceil(width / _EDGE) + 2  # a border of open cells around
    is_open = np.ones((nx, ny), dtype=np.bool_)
    for wall in walls:
        (x0, y0), (x1, y1) = wall.start, wall.end
        count = int(hypot(x1 - x0, y1 - y0) / _EDGE * 4) + 2
        along = np.linspace(0.0, 1.0, count)
        i = np.clip(np.floor((x0 + along * (x1 - x0)) / _EDGE).astype(int) + 1, 1, nx - 2)
        j = np.clip(np.floor((y0 + along * (y1 - y0)) / _EDGE).astype(int) + 1, 1, ny - 2)
        is_open[i, j] = False
    outside = np.asarray(flood(is_open, 0, 0), dtype=np.bool_)[1:-1, 1:-1]
    inside = is_open[1:-1, 1:-1] & ~outside
    if inside.sum() < _INSIDE_SHARE * inside.size:
        return (), Words(
            "its outer walls do not close, so nothing says what is outside: look at the map, and"
            " draw walls where they are missing"
        )
    return (
        boxes_of_cells(outside, _EDGE, height, "unexplored"),
        Words("what is outside of its walls is not flown in"),
    )


def _of_walls(drawing: PlanDrawing, hints: ImportHints) -> tuple[list[PlanShape], Words]:
    """Return the shapes on layers of walls, and which these are; others are left out."""
    shapes = drawing.shapes
    if hints.layers:
        are_walls = [names_any(shape.names or shape.layer, hints.layers) for shape in shapes]
    else:
        are_walls = [names_wall(shape.names or shape.layer) for shape in shapes]
    if not any(are_walls):
        if hints.layers:
            raise RoomError(
                Words(
                    "no layer's name holds {name}; there are: {thing}",
                    name=" or ".join(map(repr, hints.layers)),
                    thing=_layers(shapes),
                )
            )
        if not any(shape.layer for shape in shapes):
            return shapes, Words("every line is taken for a wall: no layer is called so")
        return shapes, Words(
            "every line is taken for a wall: no layer is called so; say layers= if only some hold"
            " them: {name}",
            name=_layers(shapes),
        )
    chosen = [shape for shape, is_wall in zip(shapes, are_walls, strict=True) if is_wall]
    for shape, is_wall in zip(shapes, are_walls, strict=True):
        if not is_wall:
            drawing.leave_out(LeftOut.NO_WALL_LAYER, repr(shape.layer))
    return chosen, Words("walls are taken from the layers {name}", name=_layers(chosen))


def _layers(shapes: list[PlanShape]) -> Words:
    names = sorted({shape.layer for shape in shapes})
    shown = ", ".join(map(repr, names[:_LAYERS_MAX]))
    more = len(names) - _LAYERS_MAX
    return Words("{name} and {n} more", name=shown, n=figure(more)) if more > 0 else literal(shown)


def _walls(
    shapes: list[PlanShape], low: Vec2, unit: float, drawing: PlanDrawing
) -> Iterator[DraftWall]:
    """Yield the straight parts of shapes as walls, each once; what is too small is left out."""
    seen = set[tuple[Vec2, Vec2]]()
    for shape, line, count in _joined(shapes, _GAP / unit):
        width = shape.width * unit
        thickness = round(width, 4) if _LINE_THICKNESS < width <= _WIDTH_MAX else _LINE_THICKNESS
        points = _thinned([((x - low[0]) * unit, (y - low[1]) * unit) for x, y in line])
        if len(points) < 2:
            drawing.left_out[LeftOut.TOO_SMALL, shape.kind] += count
        for start, end in pairwise(points):
            if (start, end) not in seen:
                seen |= {(start, end), (end, start)}
                yield DraftWall(start, end, thickness)


def _joined(shapes: list[PlanShape], gap: float) -> Iterator[tuple[PlanShape, list[Vec2], int]]:
    """Yield shapes with their points; those that go on where the one before ends are one.

    A curve is often drawn as many lines, each of them too short for a wall. With the first of the
    shapes and all points comes how many they are. Ends nearer than the gap are one.
    """
    waiting = iter(shapes)
    first = next(waiting, None)
    while first is not None:
        points, count, after = list(first.points), 1, next(waiting, None)
        while after is not None and (after.kind, after.width) == (first.kind, first.width):
            longer = _prolonged(points, list(after.points), gap)
            if longer is None:
                break
            points, count, after = longer, count + 1, next(waiting, None)
        yield first, points, count
        first = after


def _prolonged(line: list[Vec2], other: list[Vec2], gap: float) -> list[Vec2] | None:
    """Return two lines as one where an end of the one is an end of the other, else None."""
    if dist(line[-1], other[0]) <= gap:
        line.extend(other[1:])
    elif dist(line[-1], other[-1]) <= gap:
        line.extend(other[-2::-1])
    elif dist(line[0], other[-1]) <= gap:
        return other[:-1] + line
    elif dist(line[0], other[0]) <= gap:
        return other[:0:-1] + line
    else:
        return None
    return line


def _thinned(points: list[Vec2]) -> list[Vec2]:
    """Return points without those that are hardly away from the one before; the last one stays."""
    kept = points[:1]
    for point in points[1:]:
        if dist(kept[-1], point) >= _LINE_MIN:
            kept.append(point)
    if len(kept) > 1:
        kept[-1] = points[-1]
    return [(round(x, 4), round(y, 4)) for x, y in kept]


def names_wall(text: str) -> bool:
    """Return whether a layer's name holds a word for wall; accents and case do not matter."""
    plain = _folded(text)
    return any(part in plain for part in _FOLDED) or not _WHOLE.isdisjoint(_LETTERS.findall(plain))


def names_any(text: str, words: tuple[str, ...]) -> bool:
    """Return whether a layer's name holds one of some words; accents and case do not matter."""
    plain = _folded(text)
    return any(_folded(word) in plain for word in words)


@cache
def _folded(text: str) -> str:
    """Return a text in small letters without accents."""
    apart = unicodedata.normalize("NFKD", text)
    return "".join(sign for sign in apart if not unicodedata.combining(sign)).casefold()


_FOLDED = tuple(_folded(part) for part in _PARTS)
