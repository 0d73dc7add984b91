"""Where the drone is kept while the safety gate holds it, and what its driver has to know of it."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan, cos, hypot, nan, sin

from housefly.geometry import GRAVITY, Vec2
from housefly.messages.sensing import Estimate
from housefly.messages.steering import KnownMotion
from housefly.pilot.behavior.braking import SINK_LEAD, coasted
from housefly.pilot.estimation.estimator_state import PoseEstimate
from housefly.pilot.step import Guidance

HOVER_PUSH_MAX = 0.35
"""Against a larger steady push the drone's own hover drifts away [m/s^2]: it knows of none."""
TO_FLOOR = -0.2
"""Height to want where our setpoint sinks to the floor [m]: the drone touches it still sinking."""


@dataclass(frozen=True, slots=True)
class KeptPlace:
    """Where the drone comes to rest and stays: place [m], height [m], heading [rad]."""

    place: Vec2
    height: float
    yaw: float

    @classmethod
    def of(cls, estimate: Estimate, coast_time: float) -> KeptPlace:
        """Return where a drone comes to rest that brakes now, by its coast time [s]."""
        x, y, z = estimate.position
        return cls(coasted((x, y), estimate.velocity[:2], coast_time), z, estimate.yaw)

    def guidance(self, mission: Guidance) -> Guidance:
        """Return the guidance of a drone that is kept here; a path comes to rest meanwhile."""
        x, y = self.place
        return mission._replace(
            x=x, y=y, yaw=self.yaw, height=self.height, speed_factor=0.0, kept=True
        )


def sinking(estimate: Estimate) -> Guidance:
    """Return the guidance of a drone that brakes and sinks by the motion that was known last."""
    x, y, z = estimate.position
    return Guidance(
        active=True,
        following=False,
        x=x,
        y=y,
        yaw=estimate.yaw,
        arrival_yaw=nan,
        height=z - SINK_LEAD,
        speed_factor=0.0,
        kept=True,
    )


def known_motion(
    here: PoseEstimate, push: Vec2, knows_place: bool, knows_speed: bool
) -> KnownMotion:
    """Return what a driver has to know of a drone.

    Args:
        here: by tracking.
        push: steady push in the plane [m/s^2].
        knows_place: tracking is believed.
        knows_speed: the drone's own speed is believed.
    """
    if not knows_place:
        return KnownMotion(hovers=knows_speed)
    c, s = cos(here.yaw), sin(here.yaw)
    ahead, aside = c * push[0] + s * push[1], c * push[1] - s * push[0]
    return KnownMotion(
        forward=c * here.vx + s * here.vy,
        left=c * here.vy - s * here.vx,
        theta=-atan(ahead / GRAVITY),
        phi=atan(aside / GRAVITY),
        hovers=knows_speed and hypot(*push) < HOVER_PUSH_MAX,
    )
