"""Furniture is a table of parts in its own frame; ``place_parts`` puts it into the room.

The frame of a piece of furniture: origin on the floor under its middle, x to its front, y to its
left, z up.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, sin

from housefly.geometry import Vec3, wrap_angle
from housefly.room.model import Colour, Shape, Solid


def paint(red: float, green: float, blue: float, alpha: float = 1.0) -> Colour:
    """Return a colour; 0 to 1 each."""
    return (red, green, blue, alpha)


WHITE = paint(0.93, 0.93, 0.91)
CREAM = paint(0.94, 0.91, 0.84)
CHARCOAL = paint(0.16, 0.17, 0.19)
STEEL = paint(0.68, 0.70, 0.72)
OAK = paint(0.72, 0.53, 0.34)
WALNUT = paint(0.42, 0.28, 0.19)
BIRCH = paint(0.85, 0.74, 0.58)
TEAL = paint(0.16, 0.42, 0.45)
SAND = paint(0.82, 0.74, 0.62)
LEAF = paint(0.22, 0.46, 0.22)
BRICK = paint(0.71, 0.33, 0.24)
GLASS = paint(0.72, 0.86, 0.92, 0.35)


@dataclass(frozen=True, slots=True)
class Part:
    """One box or cylinder of a piece of furniture, in the frame of that piece [m, rad]."""

    name: str
    position: Vec3
    size: Vec3
    colour: Colour
    texture: str = ""
    shape: Shape = Shape.BOX
    yaw: float = 0.0
    collides: bool = True


def box(
    name: str, low: Vec3, high: Vec3, colour: Colour, texture: str = "", collides: bool = True
) -> Part:
    """Return the box between two opposite corners."""
    position = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2)
    size = (high[0] - low[0], high[1] - low[1], high[2] - low[2])
    return Part(name, position, size, colour, texture, collides=collides)


def pillar(
    name: str,
    centre: tuple[float, float],
    bottom: float,
    top: float,
    diameter: float,
    colour: Colour,
    texture: str = "",
) -> Part:
    """Return an upright cylinder between two heights."""
    position = (centre[0], centre[1], (bottom + top) / 2)
    return Part(name, position, (diameter, diameter, top - bottom), colour, texture, Shape.CYLINDER)


def place_parts(
    thing: str, parts: Iterable[Part], x: float, y: float, yaw: float = 0.0, name: str = ""
) -> tuple[Solid, ...]:
    """Return the solids of a piece of furniture at (x, y) [m], turned by yaw [rad].

    Args:
        thing: what it is; shown on the map.
        parts: its parts in its own frame.
        x: position of its origin in the world [m].
        y: likewise.
        yaw: direction of its front [rad].
        name: prefix of the names of its solids; ``thing`` when empty.
    """
    return tuple(_solid(thing, name or thing, part, x, y, yaw) for part in parts)


def _solid(thing: str, prefix: str, part: Part, x: float, y: float, yaw: float) -> Solid:
    px, py, pz = part.position
    return Solid(
        name=f"{prefix} {part.name}",
        thing=thing,
        shape=part.shape,
        position=(
            round(x + px * cos(yaw) - py * sin(yaw), 6),
            round(y + px * sin(yaw) + py * cos(yaw), 6),
            pz,
        ),
        size=part.size,
        yaw=wrap_angle(yaw + part.yaw),
        colour=part.colour,
        collides=part.collides,
        texture=part.texture,
    )
