"""A floor plan drawn as SVG, read by svgpathtools."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

from housefly.config.text import read_text_file
from housefly.errors import MissingPartError, RoomError
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.plan import PlanLine, plan_draft
from housefly.room.draft.model import SiteDraft

_TEXT_MAX = 20_000_000
_CURVE_PARTS = 8
"""A curve becomes so many straight lines."""


def svg_plan(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the walls of an SVG; raises RoomError or MissingPartError."""
    return plan_draft(draft, list(_lines(path)), path.name, hints)


def _lines(path: Path) -> Iterator[PlanLine]:
    try:
        from svgpathtools import Document
    except ImportError as error:
        raise MissingPartError(
            "the reader of SVG (svgpathtools)", "pip install 'housefly[import]'"
        ) from error
    try:
        text = read_text_file(path)
    except (OSError, UnicodeDecodeError) as error:
        raise RoomError(f"{path.name} cannot be read: {error}") from error
    if len(text) > _TEXT_MAX or "<!ENTITY" in text:
        raise RoomError(f"{path.name} is too long, or defines entities; save it as plain SVG")
    try:
        document = Document.from_svg_string(text)
        paths = list(document.paths())
    except Exception as error:  # a broken file makes its reader fail in any way
        raise RoomError(f"{path.name} cannot be read as SVG: {error}") from error
    parents = {child: parent for parent in document.tree.iter() for child in parent}
    for shape in paths:
        layer = _layer(shape.element, parents)
        for segment in shape:
            yield from _straight(segment, layer)


def _straight(segment: Any, layer: str) -> Iterator[PlanLine]:
    parts = 1 if type(segment).__name__ == "Line" else _CURVE_PARTS
    points = [segment.point(n / parts) for n in range(parts + 1)]
    for a, b in pairwise(points):
        yield PlanLine((a.real, -a.imag), (b.real, -b.imag), layer)


def _layer(element: Any, parents: dict[Any, Any]) -> str:
    """Return the names of an element and of the groups around it."""
    words = []
    node = element
    while node is not None:
        words += [
            value
            for key, value in node.attrib.items()
            if key in ("id", "class") or key.endswith("}label")
        ]
        node = parents.get(node)
    return " ".join(reversed(words))
