"""Where a carried thing may be left: the top of a piece of furniture."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, sin

from housefly.geometry import Vec2, Vec3


@dataclass(frozen=True, slots=True)
class Surface:
    """The top of one solid.

    Attributes:
        thing: id of the thing that it belongs to.
        name: of that thing.
        centre: world [m].
        half: half length and half width before rotation [m]; equal for a disc.
        top: height [m].
        yaw: direction of its length [rad].
        disc: whether it is round.
        seat: whether it belongs to a chair, a sofa or a bed.
    """

    thing: str
    name: str
    centre: Vec2
    half: Vec2
    top: float
    yaw: float = 0.0
    disc: bool = False
    seat: bool = False

    def distance(self, point: Vec2) -> float:
        """Return how far outside the top a point of the floor plan lies [m], 0 above it."""
        x, y, _ = self.nearest(point)
        return hypot(point[0] - x, point[1] - y)

    def nearest(self, point: Vec2) -> Vec3:
        """Return the point of the top that is nearest to a point of the floor plan [m]."""
        dx, dy = point[0] - self.centre[0], point[1] - self.centre[1]
        if self.disc:
            scale = min(1.0, self.half[0] / max(hypot(dx, dy), 1e-9))
            return self.centre[0] + scale * dx, self.centre[1] + scale * dy, self.top
        c, s = cos(self.yaw), sin(self.yaw)
        along = max(-self.half[0], min(self.half[0], dx * c + dy * s))
        across = max(-self.half[1], min(self.half[1], dy * c - dx * s))
        x, y = self.centre[0] + along * c - across * s, self.centre[1] + along * s + across * c
        return x, y, self.top
