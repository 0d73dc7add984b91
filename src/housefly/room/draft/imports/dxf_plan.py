"""A floor plan drawn as DXF, read by ezdxf."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from housefly.errors import MissingPartError, RoomError
from housefly.geometry import Vec2
from housefly.messages.words import UNSAID, Words, error_words, figure
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.drawing import LeftOut, PlanDrawing, PlanShape
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

_DRAWN = frozenset({
    "LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "HELIX",
    "SOLID", "TRACE", "3DFACE", "HATCH", "MPOLYGON",
})  # fmt: skip
_EXPLODED = frozenset({"MLINE", "ACAD_PROXY_ENTITY"})
"""They consist of others."""
_INSERTS_MAX, _DRAWN_MAX = 5000, 100_000
"""Blocks inside of blocks are few lines in a file, and endlessly many on the plan."""
_LEVELS_MAX = 50


def dxf_plan(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the walls of a DXF; raises RoomError or MissingPartError."""
    return plan_draft(draft, read_dxf(path), path.name, hints)


def read_dxf(path: Path) -> PlanDrawing:
    """Return what the model space of a DXF draws; raises RoomError or MissingPartError."""
    try:
        from ezdxf import filemanagement, recover
    except ImportError as error:
        raise MissingPartError(
            Words("the reader of {kind} ({name})", kind="DXF", name="ezdxf"),
            "pip install 'housefly[import]'",
        ) from error
    try:
        try:
            document, mended = filemanagement.readfile(path), 0
        except Exception:  # a file that is not quite as the format wants it
            document, auditor = recover.readfile(path)
            mended = len(auditor.errors) + len(auditor.fixes)
        drawing = dxf_drawing(document)
    except Exception as error:  # a broken file makes its reader fail in any way
        raise RoomError(
            Words("{name} cannot be read as DXF: {why}", name=path.name, why=error_words(error))
        ) from error
    if mended:
        drawing.notes += (
            Words(
                "the file is damaged; faults in it that were mended or left out: {n}",
                n=figure(mended),
            ),
        )
    if not _ends(path):
        drawing.notes += (Words("the file ends in the middle: it was cut off"),)
    return drawing


def _ends(path: Path) -> bool:
    """Return whether the mark of a DXF's end is there."""
    with path.open("rb") as file:
        file.seek(max(0, path.stat().st_size - 100))
        return b"EOF" in file.read()


def dxf_drawing(document: Any) -> PlanDrawing:
    """Return what the model space of an ezdxf document draws; raises what broken ones raise."""
    drawing = PlanDrawing()
    entities = list(_placed_entities(document, drawing))
    traced = [(placed, _paths(placed, drawing)) for placed in entities]
    size = _size([path for _, paths in traced for path in paths])
    for placed, paths in traced:
        kept = [line for path in paths if (line := _points(path, size * _SAG_SHARE))]
        drawing.shapes.extend(
            PlanShape(line, placed.layer, placed.kind, width=placed.width) for line in kept
        )
    drawing.unit, drawing.unit_words = _unit(document.header)
    return drawing


def _paths(placed: _PlacedEntity, drawing: PlanDrawing) -> list[Any]:
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


def _unit(header: Any) -> tuple[float | None, Words]:
    """Return metres per unit as the file says them, and its words."""
    unit = _UNITS.get(int(header.get("$INSUNITS", 0)))
    if unit is not None:
        return unit, Words("{c} m each, as the file says", c=figure(unit, ".4g"))
    if int(header.get("$LUNITS", 2)) in _FEET_AND_INCHES:
        return 0.0254, Words("inches, as the file writes its lengths")
    return None, UNSAID


@dataclass(frozen=True, slots=True)
class _PlacedEntity:
    """An entity where it is drawn, its kind, the layer that it shows on, and its width."""

    entity: Any
    kind: str
    layer: str
    width: float


@dataclass(frozen=True, slots=True)
class _Level:
    """What is still to be walked of a block: its layer, and whether it is hidden."""

    entities: Iterator[Any]
    layer: str
    is_hidden: bool


def _placed_entities(document: Any, drawing: PlanDrawing) -> Iterator[_PlacedEntity]:
    """Yield what is drawn and count in the drawing what is left out.

    As in CAD, what a block has on layer 0 shows on the layer that the block is inserted on; a
    frozen layer hides whole blocks, one that is off only what shows on it.

    Raises:
        ValueError: there are too many blocks or shapes, or they are nested too deeply.
    """
    walk = _Walk(document, drawing)
    levels = [_Level(iter(document.modelspace()), "0", False)]
    while levels:
        entity = next(levels[-1].entities, None)
        if entity is None:
            levels.pop()
            continue
        if len(levels) > _LEVELS_MAX:
            raise ValueError(
                Words("blocks are nested deeper than {n} levels", n=figure(_LEVELS_MAX))
            )
        found = walk.placed(entity, levels[-1])
        if isinstance(found, _Level):
            levels.append(found)
        elif found is not None:
            yield found


class _Walk:
    def __init__(self, document: Any, drawing: PlanDrawing) -> None:
        self._layers = {layer.dxf.name.casefold(): layer for layer in document.layers}
        self._drawing = drawing
        self._inserts = self._drawn = 0

    def placed(self, entity: Any, level: _Level) -> _PlacedEntity | _Level | None:
        """Return an entity as drawn, the content of a block, or None for what is left out."""
        kind = str(entity.dxftype())
        own = str(entity.dxf.get("layer", "0"))
        layer = level.layer if own == "0" else own
        if kind == "INSERT":
            return self._block(entity, layer, level)
        if level.is_hidden or self._is_hidden(entity, layer):
            self._leave_out(LeftOut.HIDDEN, kind)
        elif kind in _EXPLODED or _is_mesh(entity, kind):
            return _Level(self._parts(entity, kind), layer, False)
        elif kind not in _DRAWN:
            self._leave_out(LeftOut.NO_SHAPE, kind)
        else:
            self._count()
            return _PlacedEntity(entity, kind, layer, _width(entity, kind))
        return None

    def _block(self, insert: Any, layer: str, level: _Level) -> _Level | None:
        for _ in insert.attribs:
            self._leave_out(LeftOut.NO_SHAPE, "ATTRIB")
        block = insert.block()
        if block is None or block.block.is_xref:
            self._leave_out(LeftOut.BROKEN, _not_in_it(insert))
            return None
        self._inserts += max(1, insert.mcount)
        if self._inserts > _INSERTS_MAX:
            raise ValueError(
                Words(
                    "more than {n} blocks are inserted; leave out what is no wall",
                    n=figure(_INSERTS_MAX),
                )
            )
        found = self._layers.get(layer.casefold())
        is_hidden = level.is_hidden or _is_invisible(insert) or bool(found and found.is_frozen())
        return _Level(self._inserted(insert), layer, is_hidden)

    def _inserted(self, insert: Any) -> Iterator[Any]:
        copies = insert.multi_insert() if insert.mcount > 1 else (insert,)
        for copy in copies:
            yield from copy.virtual_entities(skipped_entity_callback=self._skipped)

    def _skipped(self, entity: Any, _: str) -> None:
        kind = str(entity.dxftype())
        self._leave_out(LeftOut.BROKEN if kind in _DRAWN else LeftOut.NO_SHAPE, kind)

    def _parts(self, entity: Any, kind: str) -> Iterator[Any]:
        try:
            parts = list(entity.virtual_entities())
        except Exception:  # whatever a broken entity makes of its reader
            parts = []
        if not parts:
            self._leave_out(LeftOut.BROKEN, kind)
        yield from parts

    def _is_hidden(self, entity: Any, layer: str) -> bool:
        found = self._layers.get(layer.casefold())
        is_shown = found is None or not (found.is_frozen() or found.is_off())
        return _is_invisible(entity) or not is_shown

    def _leave_out(self, reason: LeftOut, kind: str) -> None:
        self._count()
        self._drawing.leave_out(reason, kind)

    def _count(self) -> None:
        self._drawn += 1
        if self._drawn > _DRAWN_MAX:
            raise ValueError(
                Words("more than {n} shapes; leave out what is no wall", n=figure(_DRAWN_MAX))
            )


def _not_in_it(insert: Any) -> Words:
    return Words("{kind} of {name}, which is not in it", kind="INSERT", name=repr(insert.dxf.name))


def _is_invisible(entity: Any) -> bool:
    return bool(entity.dxf.get("invisible", 0))


def _is_mesh(entity: Any, kind: str) -> bool:
    return kind == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline)


def _width(entity: Any, kind: str) -> float:
    return float(entity.dxf.get("const_width", 0.0)) if kind == "LWPOLYLINE" else 0.0
