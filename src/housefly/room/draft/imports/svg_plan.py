"""A floor plan drawn as SVG; paths and transforms are read by svgpathtools."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from housefly.config.text import read_file
from housefly.errors import MissingPartError, RoomError
from housefly.messages.words import UNSAID, Words, error_words, figure
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.drawing import LeftOut, PlanDrawing, PlanShape
from housefly.room.draft.imports.plan import plan_draft
from housefly.room.draft.imports.svg_lengths import METRES_PER_PX, absolute_metres, view_box
from housefly.room.draft.imports.svg_outlines import outlines
from housefly.room.draft.imports.svg_walk import SvgWalk
from housefly.room.draft.model import SiteDraft

_FILE_MAX = 20_000_000
_FAR_MAX = 1e12
"""Larger coordinates are none of a plan."""


def svg_plan(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the walls of an SVG; raises RoomError or MissingPartError."""
    return plan_draft(draft, read_svg(path), path.name, hints)


def read_svg(path: Path) -> PlanDrawing:
    """Return what an SVG draws; raises RoomError or MissingPartError."""
    try:
        import svgpathtools  # noqa: F401
    except ImportError as error:
        raise MissingPartError(
            Words("the reader of {kind} ({name})", kind="SVG", name="svgpathtools"),
            "pip install 'housefly[import]'",
        ) from error
    try:
        data = read_file(path, _FILE_MAX)
    except OSError as error:
        raise RoomError(
            Words("{name} cannot be read: {why}", name=path.name, why=str(error))
        ) from error
    if b"<!ENTITY" in data.replace(b"\0", b""):
        raise RoomError(Words("{name} defines entities; save it as plain SVG", name=path.name))
    try:
        return _drawing(ElementTree.fromstring(data))
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise RoomError(
            Words("{name} cannot be read as SVG: {why}", name=path.name, why=error_words(error))
        ) from error


def _drawing(root: ElementTree.Element) -> PlanDrawing:
    drawing = PlanDrawing()
    for placed in SvgWalk(root, drawing).placed():
        try:
            lines = [
                np.column_stack([line, np.ones(len(line))]) @ placed.matrix[:2].T
                for line in outlines(placed.element, placed.kind, placed.viewport)
            ]
        except Exception:  # whatever broken numbers make of their reader
            lines = []
        if not lines or not all(np.abs(line).max() < _FAR_MAX for line in lines):
            drawing.leave_out(LeftOut.BROKEN, placed.kind)
            continue
        for line in lines:
            points = tuple((float(x), -float(y)) for x, y in line)
            drawing.shapes.append(
                PlanShape(points, placed.layer, placed.kind, placed.names, placed.width)
            )
    drawing.unit, drawing.unit_words = _unit(root)
    return drawing


def _unit(root: ElementTree.Element) -> tuple[float | None, Words]:
    """Return metres per unit where the picture has a size in metres, and the words for it."""
    width = absolute_metres(root.get("width", ""))
    if width is None:
        return None, UNSAID
    box = view_box(root)
    unit = METRES_PER_PX if box is None else width / box[2]
    return unit, Words("{c} m each, as the file says", c=figure(unit, ".4g"))
