"""What a DXF shows: entities of the model space and of inserted blocks, each on its layer."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from housefly.room.draft.imports.drawing import LeftOut, PlanDrawing

_DRAWN = frozenset({
    "LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "HELIX",
    "SOLID", "TRACE", "3DFACE", "HATCH", "MPOLYGON",
})  # fmt: skip
_EXPLODED = frozenset({"MLINE", "ACAD_PROXY_ENTITY"})
"""They consist of others."""
_INSERTS_MAX, _DRAWN_MAX = 5000, 100_000
"""Blocks inside of blocks are few lines in a file, and endlessly many on the plan."""
_LEVELS_MAX = 50


@dataclass(frozen=True, slots=True)
class PlacedEntity:
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


def placed_entities(document: Any, drawing: PlanDrawing) -> Iterator[PlacedEntity]:
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
            raise ValueError(f"blocks are nested deeper than {_LEVELS_MAX} levels")
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

    def placed(self, entity: Any, level: _Level) -> PlacedEntity | _Level | None:
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
            return PlacedEntity(entity, kind, layer, _width(entity, kind))
        return None

    def _block(self, insert: Any, layer: str, level: _Level) -> _Level | None:
        for _ in insert.attribs:
            self._leave_out(LeftOut.NO_SHAPE, "ATTRIB")
        block = insert.block()
        if block is None or block.block.is_xref:
            self._leave_out(LeftOut.BROKEN, f"INSERT of {insert.dxf.name!r}, which is not in it")
            return None
        self._inserts += max(1, insert.mcount)
        if self._inserts > _INSERTS_MAX:
            raise ValueError(
                f"more than {_INSERTS_MAX} blocks are inserted; leave out what is no wall"
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
            raise ValueError(f"more than {_DRAWN_MAX} shapes; leave out what is no wall")


def _is_invisible(entity: Any) -> bool:
    return bool(entity.dxf.get("invisible", 0))


def _is_mesh(entity: Any, kind: str) -> bool:
    return kind == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline)


def _width(entity: Any, kind: str) -> float:
    return float(entity.dxf.get("const_width", 0.0)) if kind == "LWPOLYLINE" else 0.0
