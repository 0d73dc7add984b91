"""What an SVG shows: its shapes, also those that are used from elsewhere, each where it stands."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from xml.etree.ElementTree import Element

import numpy as np

from housefly.messages.words import Words, figure
from housefly.numeric import FloatArray
from housefly.room.draft.imports.drawing import LeftOut, PlanDrawing
from housefly.room.draft.imports.svg_lengths import (
    Viewport,
    attribute_length,
    fitted,
    viewport_of,
)
from housefly.room.draft.imports.svg_outlines import SHAPES
from housefly.room.draft.imports.svg_style import SvgStyle, style_of, style_rules

_SVG = "{http://www.w3.org/2000/svg}"
_HREFS = ("{http://www.w3.org/1999/xlink}href", "href")
_GROUPS = frozenset({"svg", "g", "a", "switch"})
_NOT_DRAWN = frozenset({
    "defs", "symbol", "title", "desc", "metadata", "style", "script", "clipPath", "mask", "marker",
    "pattern", "filter", "linearGradient", "radialGradient", "view", "cursor", "font", "animate",
    "animateTransform", "animateMotion", "set", "solidcolor", "color-profile",
})  # fmt: skip
_ELEMENTS_MAX = 100_000
_LEVELS_MAX = 100


@dataclass(frozen=True, slots=True)
class PlacedShape:
    """A shape, and what holds where it stands.

    Attributes:
        element, kind: the shape.
        matrix: from its coordinates to the picture's, shape (3, 3).
        layer: name of the nearest group that has one, else its own.
        names: all words in the names of it and of what is around.
        width: of its line, in the picture's units.
        viewport: that its percentages are of.
    """

    element: Element
    kind: str
    matrix: FloatArray
    layer: str
    names: str
    width: float
    viewport: Viewport


@dataclass(frozen=True, slots=True)
class _Around:
    matrix: FloatArray
    style: SvgStyle
    layer: str
    names: tuple[str, ...]
    viewport: Viewport
    level: int


class SvgWalk:
    """One walk through a picture.

    Args:
        root: its outermost element.
        drawing: counts what is left out.
    """

    def __init__(self, root: Element, drawing: PlanDrawing) -> None:
        self._root, self._drawing = root, drawing
        self._rules = style_rules(root)
        self._by_id = {one.get("id", ""): one for one in root.iter() if one.get("id")}
        self._visited = 0

    def placed(self) -> Iterator[PlacedShape]:
        """Yield what is shown; raises ValueError for too much, or too deeply nested."""
        root = self._root
        viewport = viewport_of(root, None, root.get("width", ""), root.get("height", ""))
        style = style_of(root, "svg", SvgStyle(), self._rules)
        around = _Around(np.identity(3), style, "", (), viewport, 0)
        waiting = [(child, around) for child in reversed(root)]
        while waiting:
            element, around = waiting.pop()
            found = self._visited_element(element, around)
            if isinstance(found, PlacedShape):
                yield found
            else:
                waiting.extend(reversed(found))

    def _visited_element(
        self, element: Element, around: _Around
    ) -> PlacedShape | list[tuple[Element, _Around]]:
        """Return a shape, or what is inside of an element; what is neither is left out."""
        tag = _tag(element)
        if tag in _NOT_DRAWN or tag == "":
            return []
        self._visited += 1
        if self._visited > _ELEMENTS_MAX:
            raise ValueError(
                Words("more than {n} elements; leave out what is no wall", n=figure(_ELEMENTS_MAX))
            )
        if around.level > _LEVELS_MAX:
            raise ValueError(
                Words("groups are nested deeper than {n} levels", n=figure(_LEVELS_MAX))
            )
        try:
            here = self._inside(element, tag, around)
        except ValueError:
            self._drawing.leave_out(LeftOut.BROKEN, tag)
            return []
        if tag in _GROUPS:
            return [(child, here) for child in element]
        if tag == "use":
            return self._used(element, here)
        if here.style.is_hidden:
            self._drawing.leave_out(LeftOut.HIDDEN, tag)
        elif tag not in SHAPES:
            self._drawing.leave_out(LeftOut.NO_SHAPE, tag)
        elif _is_background(element, tag):
            self._drawing.leave_out(LeftOut.NO_SHAPE, Words("rect as large as the page"))
        else:
            scale = float(abs(np.linalg.det(here.matrix[:2, :2]))) ** 0.5
            names, width = " ".join(here.names), here.style.width * scale
            return PlacedShape(element, tag, here.matrix, here.layer, names, width, here.viewport)
        return []

    def _inside(self, element: Element, tag: str, around: _Around) -> _Around:
        """Return what holds for an element; raises ValueError for a broken transform."""
        from svgpathtools.parser import parse_transform

        matrix = around.matrix
        if "transform" in element.attrib:
            matrix = matrix @ parse_transform(element.get("transform"), strict=True)
        here = _Around(
            matrix,
            style_of(element, tag, around.style, self._rules),
            _layer(element, tag, around.layer),
            (*around.names, *_names(element)),
            around.viewport,
            around.level + 1,
        )
        if tag == "svg":
            here = replace(here, matrix=matrix @ _shifted(element, around.viewport))
            return _fitted(element, here, element)
        return here

    def _used(self, use: Element, around: _Around) -> list[tuple[Element, _Around]]:
        name = next((use.get(key, "") for key in _HREFS if use.get(key)), "")
        used = self._by_id.get(name[1:]) if name[:1] == "#" else None
        if used is None:
            self._drawing.leave_out(
                LeftOut.BROKEN,
                Words("{kind} of {name}, which is not in it", kind="use", name=repr(name)),
            )
            return []
        try:
            matrix = around.matrix @ _shifted(use, around.viewport)
        except ValueError:
            self._drawing.leave_out(LeftOut.BROKEN, "use")
            return []
        here = replace(around, matrix=matrix)
        if _tag(used) != "symbol":
            return [(used, here)]
        here = _fitted(used, self._inside(used, "symbol", here), use)
        return [(child, here) for child in used]


def _fitted(element: Element, around: _Around, sized: Element) -> _Around:
    """Return what holds inside of a view box; ``sized`` says how large it is shown."""
    width, height = sized.get("width", "100%"), sized.get("height", "100%")
    return replace(
        around,
        matrix=around.matrix @ fitted(element, around.viewport, width, height),
        viewport=viewport_of(element, around.viewport, width, height),
    )


def _shifted(element: Element, viewport: Viewport) -> FloatArray:
    wide, high = viewport or (None, None)
    x, y = attribute_length(element, "x", wide), attribute_length(element, "y", high)
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


def _tag(element: Element) -> str:
    """Return the name of an element of SVG, "" for one of another kind."""
    tag = element.tag if isinstance(element.tag, str) else ""
    if tag.startswith(_SVG):
        return tag[len(_SVG) :]
    return "" if tag.startswith("{") else tag


def _names(element: Element) -> Iterator[str]:
    for key, value in element.attrib.items():
        if key in ("id", "class", "data-name") or key.endswith("}label"):
            yield value


def _layer(element: Element, tag: str, around: str) -> str:
    """Return the name of the layer that an element is on."""
    if tag not in ("g", "symbol") and around:
        return around
    label = next((value for key, value in element.attrib.items() if key.endswith("}label")), "")
    return label or element.get("data-name") or element.get("id") or around


def _is_background(element: Element, tag: str) -> bool:
    return tag == "rect" and element.get("width") == element.get("height") == "100%"
