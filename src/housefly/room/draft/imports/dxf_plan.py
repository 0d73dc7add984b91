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
_INSERTS_MAX = 5000
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
        extents = bbox.extents(space, fast=True)
        size = max(extents.size.x, extents.size.y) if extents.has_data else 1.0
        lines = [
            PlanLine((a.x, a.y), (b.x, b.y), entity.dxf.layer)
            for entity in _entities(space)
            for a, b in pairwise(curves.make_path(entity).flattening(size * _SAG_SHARE))
        ]
    except Exception as error:  # a broken file makes its reader fail in any way
        raise RoomError(f"{path.name} cannot be read as DXF: {error}") from error
    unit = _UNITS.get(int(document.header.get("$INSUNITS", 0)))
    declared = (unit, f"{unit:g} m each, as the file says") if unit else None
    return plan_draft(draft, lines, path.name, hints, declared)


def _entities(space: Any) -> Iterator[Any]:
    """Yield what is drawn, also inside of inserted blocks."""
    waiting, count = list(space), 0
    while waiting:
        entity = waiting.pop(0)
        if entity.dxftype() == "INSERT" and count < _INSERTS_MAX:
            count += 1
            waiting.extend(entity.virtual_entities())
        elif entity.dxftype() in _DRAWN:
            yield entity
