"""A floor plan drawn as DXF, read by ezdxf."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

from housefly.errors import MissingPartError, RoomError
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.plan import PlanLine, plan_draft
from housefly.room.draft.model import SiteDraft

_DRAWN = frozenset({"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE"})
_INSERTS_MAX, _DRAWN_MAX = 5000, 100_000
"""Blocks inside of blocks are few lines in a file, and endlessly many on the plan."""
_SAG_SHARE = 1e-3
"""Curves are followed to this share of the drawing's size."""
_UNITS = {1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1.0, 14: 0.1}
"""Metres per unit by the file's own $INSUNITS; any other number says nothing."""


def dxf_plan(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the walls of a DXF; raises RoomError or MissingPartError."""
    try:
        from ezdxf import bbox, filemanagement
        from ezdxf import path as curves
    except ImportError as error:
        raise MissingPartError(
            "the reader of DXF (ezdxf)", "pip install 'housefly[import]'"
        ) from error
    try:
        document = filemanagement.readfile(path)
        space = document.modelspace()
        drawn = list(_entities(space))
        extents = bbox.extents(drawn, fast=True)
        size = max(extents.size.x, extents.size.y) if extents.has_data else 1.0
        lines = [
            PlanLine((a.x, a.y), (b.x, b.y), entity.dxf.layer)
            for entity in drawn
            for a, b in pairwise(curves.make_path(entity).flattening(size * _SAG_SHARE))
        ]
    except Exception as error:  # a broken file makes its reader fail in any way
        raise RoomError(f"{path.name} cannot be read as DXF: {error}") from error
    unit = _UNITS.get(int(document.header.get("$INSUNITS", 0)))
    declared = (unit, f"{unit:g} m each, as the file says") if unit else None
    return plan_draft(draft, lines, path.name, hints, declared)


def _entities(space: Any) -> Iterator[Any]:
    """Yield what is drawn, also inside of inserted blocks; raises ValueError for too many."""
    waiting, inserts, drawn = [iter(space)], 0, 0
    while waiting:
        entity = next(waiting[-1], None)
        if entity is None:
            waiting.pop()
        elif entity.dxftype() == "INSERT":
            inserts += 1
            if inserts > _INSERTS_MAX:
                raise ValueError(
                    f"more than {_INSERTS_MAX} blocks are inserted; leave out what is no wall"
                )
            waiting.append(iter(entity.virtual_entities()))
        elif entity.dxftype() in _DRAWN:
            drawn += 1
            if drawn > _DRAWN_MAX:
                raise ValueError(f"more than {_DRAWN_MAX} shapes; leave out what is no wall")
            yield entity
