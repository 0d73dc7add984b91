"""Where the drone is by its own motion alone since tracking was believed last."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec2, Vec3


@dataclass(frozen=True, slots=True)
class ReckonedPose:
    """The last believed pose, carried on by optical flow, gyros and sonar.

    Attributes:
        position: world; its height leaves steps of the floor out [m].
        velocity: in the plane, world [m/s].
        yaw: heading [rad].
        deviation: one sigma of the place, grown since tracking was believed [m].
    """

    position: Vec3
    velocity: Vec2
    yaw: float
    deviation: float
