"""A solid seen from above."""

from __future__ import annotations

from math import cos, pi, sin

from housefly.geometry import Vec2
from housefly.room.model import Shape, Solid

_SIDES = 24
_CIRCLE = tuple((cos(n * 2.0 * pi / _SIDES), sin(n * 2.0 * pi / _SIDES)) for n in range(_SIDES))
_SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))


def outline(solid: Solid) -> tuple[Vec2, ...]:
    """Return the corners of a solid's plan, counterclockwise, world xy [m]; 24 for a cylinder."""
    x, y, _ = solid.position
    a, b = solid.size[0] / 2.0, solid.size[1] / 2.0
    c, s = cos(solid.yaw), sin(solid.yaw)
    shape = _CIRCLE if solid.shape is Shape.CYLINDER else _SQUARE
    return tuple((x + c * a * u - s * b * v, y + s * a * u + c * b * v) for u, v in shape)
