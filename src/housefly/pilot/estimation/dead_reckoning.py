"""Where the drone is by its own motion alone since tracking was believed last."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp

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


FLOOR_NEAR, FLOOR_TIME = 0.12, 2.0
"""What shows so near to where the floor is expected is floor [m], and draws the height to it within
this [s].
"""
_STEP_MAX = 0.1


@dataclass(frozen=True, slots=True)
class ReckonedHeight:
    """The height by what was commanded: a sonar that glides over somebody tells of no climb.

    Attributes:
        now: [s].
        height: [m].
        climb: [m/s].
    """

    now: float
    height: float
    climb: float = 0.0

    def advanced(
        self, now: float, commanded: float, lag: float, sink_gain: float, floor: float
    ) -> ReckonedHeight:
        """Return the height a moment later.

        Args:
            now: [s].
            commanded: climb rate asked for since [m/s].
            lag: pole of the drone's answer [1/s].
            sink_gain: what the drone makes of a commanded sinking, over what was commanded.
            floor: height of the drone if its sonar sees the floor [m]; nan where it tells nothing.
        """
        dt = min(max(now - self.now, 0.0), _STEP_MAX)
        wanted = commanded * (sink_gain if commanded < 0.0 else 1.0)
        climb = wanted + (self.climb - wanted) * exp(-lag * dt)
        height = self.height + dt * climb
        if abs(floor - height) < FLOOR_NEAR:
            height += (1.0 - exp(-dt / FLOOR_TIME)) * (floor - height)
        return ReckonedHeight(now, height, climb)
