"""Polygons on the floor plan."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2


def in_polygon(polygon: tuple[Vec2, ...], x: Any, y: Any) -> NDArray[np.bool_]:
    """Return which points are inside: a ray along x crosses an odd number of edges.

    Args:
        polygon: corners, either way round [m].
        x: of the points [m].
        y: likewise, in a shape that broadcasts with that of ``x``.
    """
    inside = np.zeros(np.broadcast_shapes(np.shape(x), np.shape(y)), dtype=np.bool_)
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1], strict=True):
        if y0 != y1:
            across = (y0 > y) != (y1 > y)
            inside ^= across & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
    return inside
