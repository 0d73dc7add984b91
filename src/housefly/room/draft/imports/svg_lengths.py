"""Lengths of SVG in user units, and the transform of a view box."""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

import numpy as np

from housefly.numeric import FloatArray

Viewport = tuple[float, float] | None
"""Width and height that percentages are of, in user units; None where they are not known."""

_LENGTH = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z]*|%)\s*")
_PX = {
    "": 1.0, "px": 1.0, "in": 96.0, "mm": 96.0 / 25.4, "cm": 96.0 / 2.54, "q": 96.0 / 101.6,
    "pt": 96.0 / 72.0, "pc": 16.0, "m": 96.0 / 0.0254,
}  # fmt: skip
METRES_PER_PX = 0.0254 / 96.0
_ALIGN = {"xMin": 0.0, "xMid": 0.5, "xMax": 1.0, "YMin": 0.0, "YMid": 0.5, "YMax": 1.0}


def user_length(text: str, whole: float | None) -> float:
    """Return a length in user units; raises ValueError for what is none.

    Args:
        text: a number with or without unit.
        whole: what a percentage is of.
    """
    match = _LENGTH.fullmatch(text)
    if match is None:
        raise ValueError(f"{text!r} is no length")
    number, unit = float(match[1]), match[2].lower()
    if unit == "%" and whole is not None:
        return number / 100.0 * whole
    if unit not in _PX:
        raise ValueError(f"{text!r}: a length in {unit} says nothing here")
    return number * _PX[unit]


def attribute_length(element: Element, key: str, whole: float | None, default: str = "0") -> float:
    """Return an attribute's length in user units; raises ValueError for what is none."""
    return user_length(element.get(key, default), whole)


def absolute_metres(text: str) -> float | None:
    """Return a length that has a unit of the world in metres, None for any other."""
    match = _LENGTH.fullmatch(text)
    if match is None or match[2].lower() in ("", "%", "px") or match[2].lower() not in _PX:
        return None
    length = float(match[1]) * _PX[match[2].lower()] * METRES_PER_PX
    return length if length > 0.0 else None


def view_box(element: Element) -> tuple[float, float, float, float] | None:
    """Return x, y, width and height of what is shown, None without or with a bad one."""
    parts = re.split(r"[\s,]+", element.get("viewBox", "").strip())
    try:
        x, y, width, height = map(float, parts)
    except ValueError:
        return None
    is_sane = all(map(np.isfinite, (x, y, width, height))) and width > 0.0 and height > 0.0
    return (x, y, width, height) if is_sane else None


def viewport_of(element: Element, around: Viewport, width: str, height: str) -> Viewport:
    """Return what percentages inside an svg or symbol are of."""
    box = view_box(element)
    if box is not None:
        return box[2], box[3]
    try:
        return (
            user_length(width, around[0] if around else None),
            user_length(height, around[1] if around else None),
        )
    except ValueError:
        return around


def fitted(element: Element, around: Viewport, width: str, height: str) -> FloatArray:
    """Return the matrix that fits an inner svg's or symbol's view box into its place."""
    box = view_box(element)
    if box is None:
        return np.identity(3)
    try:
        place = viewport_of(Element("svg"), around, width, height)
    except ValueError:
        place = None
    if place is None or min(place) <= 0.0:
        return _matrix(1.0, 1.0, -box[0], -box[1])
    scales = np.array([place[0] / box[2], place[1] / box[3]])
    words = element.get("preserveAspectRatio", "xMidYMid meet").split()
    if "none" not in words:
        scales[:] = scales.max() if "slice" in words else scales.min()
    align = words[0] if words else ""
    free = np.array(place) - scales * box[2:]
    shift = free * (_ALIGN.get(align[:4], 0.5), _ALIGN.get(align[4:], 0.5))
    x, y = shift - scales * box[:2]
    return _matrix(float(scales[0]), float(scales[1]), float(x), float(y))


def _matrix(a: float, d: float, x: float, y: float) -> FloatArray:
    return np.array([[a, 0.0, x], [0.0, d, y], [0.0, 0.0, 1.0]])
