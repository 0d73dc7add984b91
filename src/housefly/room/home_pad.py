"""The home pad on the floor, where the drone starts and lands; it does not collide."""

from __future__ import annotations

from dataclasses import replace

from housefly.geometry import Vec2
from housefly.room.model import Solid
from housefly.room.parts import paint, pillar, place_parts

HOME_PAD_RADIUS = 0.40
"""Radius of the pad [m]."""
_PAD = (
    pillar("rim", (0.0, 0.0), 0.0, 0.004, 2 * HOME_PAD_RADIUS, paint(0.94, 0.94, 0.92)),
    pillar("disc", (0.0, 0.0), 0.004, 0.006, 0.74, paint(0.13, 0.38, 0.42)),
    pillar("dot", (0.0, 0.0), 0.006, 0.008, 0.20, paint(0.94, 0.94, 0.92)),
)


def home_pad(home: Vec2) -> tuple[Solid, ...]:
    """Return the pad's discs around a position [m]."""
    return tuple(replace(solid, collides=False) for solid in place_parts("home pad", _PAD, *home))
