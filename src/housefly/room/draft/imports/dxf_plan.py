"""A floor plan drawn as DXF, read by ezdxf."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from housefly.errors import MissingPartError, RoomError
from housefly.geometry import Vec2
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.drawing import LeftOut, PlanDrawing, PlanShape
from housefly.room.draft.imports.dxf_entities import PlacedEntity, placed_entities
from housefly.room.draft.imports.plan import plan_draft
from housefly.room.draft.model import SiteDraft

_SAG_SHARE, _OWN_SAG_SHARE = 1e-3, 2e-2
"""Curves are followed to these shares of the drawing's size and of their own."""
_UNITS = {
    1: 0.0254, 2: 0.3048, 3: 1609.344, 4: 0.001, 5: 0.01, 6: 1.0, 7: 1000.0, 9: 2.54e-5,
    10: 0.9144, 13: 1e-6, 14: 0.1, 15: 10.0, 16: 100.0, 21: 0.3048006, 22: 0.0254, 23: 0.9144018,
}  # fmt: skip
"""Metres per unit by the file's own $INSUNITS; any other number says nothing."""
_FEET_AND_INCHES = (3, 4)
"""$LUNITS of engineering and architectural lengths, which are counted in inches."""


def dxf_plan(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the walls of a DXF; raises RoomError or MissingPartError."""
    return plan_draft(draft, read_dxf(path), path.name, hints)


def read_dxf(path: Path) -> PlanDrawing:
    """Return what the model space of a DXF draws; raises RoomError or MissingPartError."""
    try:
        from ezdxf import filemanagement, recover
    except ImportError as error:
        raise MissingPartError(
            "the reader of DXF (ezdxf)", "pip install 'housefly[import]'"
        ) from error
    try:
        try:
            document, mended = filemanagement.readfile(path), 0
        except Exception:  # a file that is not quite as the format wants it
            document, auditor = recover.readfile(path)
            mended = len(auditor.errors) + len(auditor.fixes)
        drawing = dxf_drawing(document)
    except Exception as error:  # a broken file makes its reader fail in any way
        raise RoomError(f"{path.name} cannot be read as DXF: {error}") from error
    if mended:
        drawing.notes += (
            f"the file is damaged; faults in it that were mended or left out: {mended}",
        )
    if not _ends(path):
        drawing.notes += ("the file ends in the middle: it was cut off",)
    return drawing


def _ends(path: Path) -> bool:
    """Return whether the mark of a DXF's end is there."""
    with path.open("rb") as file:
        file.seek(max(0, path.stat().st_size - 100))
        return b"EOF" in file.read()


def dxf_drawing(document: Any) -> PlanDrawing:
    """Return what the model space of an ezdxf document draws; raises what broken ones raise."""
    drawing = PlanDrawing()
    entities = list(placed_entities(document, drawing))
    traced = [(placed, _paths(placed, drawing)) for placed in entities]
    size = _size([path for _, paths in traced for path in paths])
    for placed, paths in traced:
        kept = [line for path in paths if (line := _points(path, size * _SAG_SHARE))]
        drawing.shapes.extend(
            PlanShape(line, placed.layer, placed.kind, width=placed.width) for line in kept
        )
    drawing.unit, drawing.unit_words = _unit(document.header)
    return drawing


def _paths(placed: PlacedEntity, drawing: PlanDrawing) -> list[Any]:
    """Return the curves of an entity; one that cannot be followed is left out."""
    from ezdxf import path as curves

    try:
        if placed.kind in ("HATCH", "MPOLYGON"):
            paths = list(curves.from_hatch(placed.entity))
        else:
            paths = [curves.make_path(placed.entity)]
        paths = [path for path in paths if len(path)]
        is_finite = all(
            np.isfinite([point.x, point.y]).all()
            for path in paths
            for point in path.control_vertices()
        )
    except Exception:  # whatever a broken entity makes of its reader
        is_finite, paths = False, []
    if not (is_finite and paths):
        drawing.leave_out(LeftOut.BROKEN, placed.kind)
        return []
    return paths


def _size(paths: list[Any]) -> float:
    """Return about how large the drawing is, whatever few things lie far away."""
    points = np.array([(p.x, p.y) for path in paths for p in path.control_vertices()])
    if points.size == 0:
        return 1.0
    return 3.0 * float(np.median(np.abs(points - np.median(points, axis=0)), axis=0).max())


def _points(path: Any, sag: float) -> tuple[Vec2, ...]:
    vertices = np.array([(p.x, p.y) for p in path.control_vertices()])
    own = float(np.ptp(vertices, axis=0).max())
    within = min(sag, _OWN_SAG_SHARE * own) or _OWN_SAG_SHARE * own
    flat = (
        list(path.flattening(within)) if path.has_curves and own > 0.0 else path.control_vertices()
    )
    points = [(float(point.x), float(point.y)) for point in flat]
    return (*(a for a, b in pairwise(points) if a != b), points[-1])


def _unit(header: Any) -> tuple[float | None, str]:
    """Return metres per unit as the file says them, and its words."""
    unit = _UNITS.get(int(header.get("$INSUNITS", 0)))
    if unit is not None:
        return unit, f"{unit:.4g} m each, as the file says"
    if int(header.get("$LUNITS", 2)) in _FEET_AND_INCHES:
        return 0.0254, "inches, as the file writes its lengths"
    return None, ""
