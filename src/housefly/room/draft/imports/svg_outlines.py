"""The shapes of SVG as straight lines between points."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from math import hypot
from xml.etree.ElementTree import Element

import numpy as np

from housefly.numeric import FloatArray
from housefly.room.draft.imports.svg_lengths import Viewport, attribute_length

_CURVE_PARTS = 16
"""A curve becomes so many straight lines."""
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_SEGMENTS_MAX = 100_000


def outlines(element: Element, kind: str, viewport: Viewport) -> list[FloatArray]:
    """Return the lines of one shape, each of shape (n, 2); raises what broken numbers raise."""
    return [np.asarray(line, dtype=np.float64) for line in _OUTLINES[kind](element, viewport)]


def _path(element: Element, _: Viewport) -> Iterator[list[tuple[float, float]]]:
    from svgpathtools import Line, parse_path

    segments = parse_path(element.get("d", ""))
    if len(segments) > _SEGMENTS_MAX:
        raise ValueError("too many parts")
    line: list[tuple[float, float]] = []
    for segment in segments:
        start = segment.start.real, segment.start.imag
        if line and line[-1] != start:
            yield line
            line = []
        line = line or [start]
        parts = 1 if isinstance(segment, Line) else _CURVE_PARTS
        for n in range(1, parts):
            point = segment.point(n / parts)
            line.append((point.real, point.imag))
        line.append((segment.end.real, segment.end.imag))
    if line:
        yield line


def _rect(element: Element, viewport: Viewport) -> Iterator[list[tuple[float, float]]]:
    wide, high = viewport or (None, None)
    x, y = attribute_length(element, "x", wide), attribute_length(element, "y", high)
    width = attribute_length(element, "width", wide)
    height = attribute_length(element, "height", high)
    if width < 0.0 or height < 0.0:
        raise ValueError("a rectangle has no negative sides")
    yield [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]


def _line(element: Element, viewport: Viewport) -> Iterator[list[tuple[float, float]]]:
    wide, high = viewport or (None, None)
    yield [
        (attribute_length(element, f"x{end}", wide), attribute_length(element, f"y{end}", high))
        for end in (1, 2)
    ]


def _round(element: Element, viewport: Viewport) -> Iterator[FloatArray]:
    wide, high = viewport or (None, None)
    across = None if viewport is None else hypot(*viewport) / 2**0.5
    middle = attribute_length(element, "cx", wide), attribute_length(element, "cy", high)
    radius = element.get("r")
    if radius is not None:
        radii = 2 * (attribute_length(element, "r", across),)
    else:
        radii = attribute_length(element, "rx", wide), attribute_length(element, "ry", high)
    turn = np.linspace(0.0, 2.0 * np.pi, 2 * _CURVE_PARTS + 1)
    yield np.column_stack([np.cos(turn), np.sin(turn)]) * radii + middle


def _polyline(element: Element, _: Viewport) -> Iterator[FloatArray]:
    numbers = [float(number) for number in _NUMBER.findall(element.get("points", ""))]
    if len(numbers) >= 2:
        yield np.reshape(numbers[: len(numbers) // 2 * 2], (-1, 2))


def _polygon(element: Element, viewport: Viewport) -> Iterator[FloatArray]:
    for points in _polyline(element, viewport):
        yield np.vstack([points, points[:1]])


_OUTLINES: dict[str, Callable[[Element, Viewport], Iterator[object]]] = {
    "path": _path,
    "rect": _rect,
    "line": _line,
    "circle": _round,
    "ellipse": _round,
    "polyline": _polyline,
    "polygon": _polygon,
}
SHAPES = frozenset(_OUTLINES)
"""Names of the elements that draw a shape."""
