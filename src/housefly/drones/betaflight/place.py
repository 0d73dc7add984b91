"""Holding a place that tracking sees, by lean; pure. For what nobody steers: rising, landing."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan, cos, sin, tan

from housefly.drones.betaflight.observer import UNSEEN, AxisState, advanced, corrected
from housefly.geometry import GRAVITY, Vec2
from housefly.messages import Pose

STIFFNESS, DAMPING = 1.2, 2.0
"""Acceleration per distance [1/s^2], and per speed [1/s]."""
REACH = 0.5
"""A place that is farther away pulls no more than one that is so far [m]."""


@dataclass(frozen=True, slots=True)
class PlaceLoop:
    """Where it is, how fast, and where it is to stay.

    Attributes:
        x, y: in the world.
        yaw: heading [rad].
        held: place that is held [m]; None for none.
        drag: linear [1/s].
    """

    drag: float
    x: AxisState = UNSEEN
    y: AxisState = UNSEEN
    yaw: float = 0.0
    held: Vec2 | None = None

    def at(self, now: float, phi: float, theta: float) -> PlaceLoop:
        """Return it carried on to now [s], leaning as reported [rad]."""
        ahead, left = GRAVITY * tan(theta), -GRAVITY * tan(phi)
        c, s = cos(self.yaw), sin(self.yaw)
        return replace(
            self,
            x=advanced(self.x, now, c * ahead - s * left, self.drag),
            y=advanced(self.y, now, s * ahead + c * left, self.drag),
        )

    def seen(self, pose: Pose, captured_at: float) -> PlaceLoop:
        """Return it once tracking has said where it was, at a time [s]."""
        x, y, _ = pose.position
        return replace(
            self,
            x=corrected(self.x, x, captured_at),
            y=corrected(self.y, y, captured_at),
            yaw=pose.yaw,
        )

    def holding(self, place: Vec2 | None = None) -> PlaceLoop:
        """Return it holding a place [m], or where it comes to rest from here."""
        rest = (
            self.x.place + self.x.speed * DAMPING / (STIFFNESS + DAMPING),
            self.y.place + self.y.speed * DAMPING / (STIFFNESS + DAMPING),
        )
        return replace(self, held=self.held or place or rest)

    def lean(self, tilt_max: float) -> Vec2:
        """Return phi and theta [rad] that hold the place, no more than a largest tilt [rad]."""
        if self.held is None:
            return 0.0, 0.0
        ax, ay = (
            -STIFFNESS * min(max(axis.place - held, -REACH), REACH)
            - DAMPING * axis.speed
            - axis.push
            for axis, held in zip((self.x, self.y), self.held, strict=True)
        )
        c, s = cos(self.yaw), sin(self.yaw)
        ahead, left = c * ax + s * ay, c * ay - s * ax
        return _limited(-atan(left / GRAVITY), tilt_max), _limited(atan(ahead / GRAVITY), tilt_max)


def _limited(angle: float, most: float) -> float:
    return min(max(angle, -most), most)
