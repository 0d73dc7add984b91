"""The lines of a floor plan as walls, whatever file they came from."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, hypot

import numpy as np

from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.room.draft.imports.cells import boxes_of_cells
from housefly.room.draft.imports.contracts import USUAL_UNITS, Imported, ImportHints
from housefly.room.draft.model import DraftBox, DraftWall, SiteDraft
from housefly.room.reach import flood

_LINES_MAX = 2000
_LINE_MIN = 0.02
"""Shorter lines are left out [m]."""
_LINE_THICKNESS = 0.03
"""Walls in a plan are drawn by their faces; each face becomes so thick [m]."""
_SIDES = (1.5, 80.0)
_SAID_SIDES = (1.0, 200.0)
"""Of a plan whose unit was said [m]."""
_EDGE = 0.1
"""Of the cells that tell inside from outside [m]."""
_INSIDE_SHARE = 0.4
"""With less of the floor inside, the outer walls have a hole."""
WALL_WORDS = ("wall", "mauer", "wand", "mur", "muro", "pared", "parete")
"""Words in the names of layers that hold walls."""


@dataclass(frozen=True, slots=True)
class PlanLine:
    """A straight line of a plan in the file's unit, y up, and the layer that it is on."""

    start: Vec2
    end: Vec2
    layer: str


def plan_draft(
    draft: SiteDraft,
    lines: list[PlanLine],
    name: str,
    hints: ImportHints,
    declared: tuple[float, str] | None = None,
) -> Imported:
    """Return the draft with a plan's lines as walls.

    Args:
        draft: what is known besides.
        lines: of the plan.
        name: of the file.
        hints: what was said about it.
        declared: metres per unit as the file says them, and its words for it.

    Raises:
        RoomError: there are no lines or too many, or the unit cannot be told.
    """
    if not lines:
        raise RoomError(
            f"{name} holds no lines: are its walls drawn as lines or shapes, not as a picture?"
        )
    chosen, layer_note = _of_walls(lines, hints)
    ends = np.array([[*line.start, *line.end] for line in chosen]).reshape(-1, 2)
    if not np.isfinite(ends).all():
        raise RoomError(f"{name} has a line with an end that is not finite")
    low, high = ends.min(axis=0), ends.max(axis=0)
    unit, unit_note = _unit(high - low, name, hints, declared)
    walls = tuple(wall for line in chosen if (wall := _wall(line, low, unit)) is not None)
    if len(walls) > _LINES_MAX:
        layers = sorted({line.layer for line in lines})
        raise RoomError(
            f"{name} has {len(walls)} lines, at most {_LINES_MAX} are read: say which layers hold"
            f" the walls; it has: {', '.join(map(repr, layers[:20]))}"
        )
    length, width = (float(side) * unit for side in high - low)
    outside, outside_note = _outside(walls, length, width, draft.height)
    notes = (
        layer_note,
        unit_note,
        outside_note,
        f"{name}: {length:.2f} m x {width:.2f} m, {len(walls)} lines became walls up to the ceiling"
        " (doors and windows too, where they are drawn on the same layer)",
    )
    bounds = (0.0, 0.0, round(length, 3), round(width, 3))
    return Imported(replace(draft, bounds=bounds, walls=walls, scanned=outside), notes)


def _outside(
    walls: tuple[DraftWall, ...], length: float, width: float, height: float
) -> tuple[tuple[DraftBox, ...], str]:
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
        return (), (
            "its outer walls do not close, so nothing says what is outside: look at the map, and"
            " draw walls where they are missing"
        )
    return (
        boxes_of_cells(outside, _EDGE, height, "unexplored"),
        "what is outside of its walls is not flown in",
    )


def _of_walls(lines: list[PlanLine], hints: ImportHints) -> tuple[list[PlanLine], str]:
    words = hints.layers or WALL_WORDS
    chosen = [line for line in lines if any(word.lower() in line.layer.lower() for word in words)]
    if chosen:
        taken = sorted({line.layer for line in chosen})
        return chosen, f"walls are taken from the layers {', '.join(map(repr, taken[:10]))}"
    if hints.layers:
        layers = sorted({line.layer for line in lines})
        raise RoomError(
            f"no layer's name holds {' or '.join(map(repr, hints.layers))}; there are:"
            f" {', '.join(map(repr, layers[:20]))}"
        )
    return lines, "every line is taken for a wall: no layer is called so"


def _unit(
    extent: np.ndarray[tuple[int], np.dtype[np.float64]],
    name: str,
    hints: ImportHints,
    declared: tuple[float, str] | None,
) -> tuple[float, str]:
    length, width = (float(side) for side in extent)
    if hints.unit is not None:
        said = [hints.unit * side for side in (length, width)]
        if not all(_SAID_SIDES[0] <= side <= _SAID_SIDES[1] for side in said):
            raise RoomError(
                f"{name} is {said[0]:.4g} m x {said[1]:.4g} m with unit={hints.unit:g}; allowed:"
                f" {_SAID_SIDES[0]:g} to {_SAID_SIDES[1]:g} m: say another unit"
            )
        return hints.unit, f"one unit is {hints.unit:g} m, as you said"
    choices = ([declared] if declared else []) + [
        (unit, f"taken for {words}") for unit, words in USUAL_UNITS.items()
    ]
    for unit, words in choices:
        if all(_SIDES[0] <= unit * side <= _SIDES[1] for side in (length, width)):
            return unit, (
                f"its numbers ({length:.4g} x {width:.4g}) are {words}: measure one wall, and say"
                " the unit if it is not so long"
            )
    raise RoomError(
        f"{name} measures {length:.4g} x {width:.4g}: no room in any usual unit; say how many"
        " metres one unit is"
    )


def _wall(
    line: PlanLine, low: np.ndarray[tuple[int], np.dtype[np.float64]], unit: float
) -> DraftWall | None:
    (x0, y0), (x1, y1) = line.start, line.end
    start = round((x0 - low[0]) * unit, 4), round((y0 - low[1]) * unit, 4)
    end = round((x1 - low[0]) * unit, 4), round((y1 - low[1]) * unit, 4)
    if hypot(end[0] - start[0], end[1] - start[1]) < _LINE_MIN:
        return None
    return DraftWall(
        (float(start[0]), float(start[1])), (float(end[0]), float(end[1])), _LINE_THICKNESS
    )
