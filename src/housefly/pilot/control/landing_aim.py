"""Where to hand a landing over, so that the drone's own last bit drifts onto the spot.

The drone's own hover brakes against its speed over the ground and knows nothing of a steady push
d: v' = d - b v from rest, so that in T seconds it drifts d (T - (1 - exp(-b T)) / b) / b.
"""

from __future__ import annotations

from math import exp

from housefly.config.airframe import Airframe
from housefly.geometry import Vec2
from housefly.numeric import clipped

AIM_MAX = 0.2
"""The aim is never farther beside the spot than this along an axis [m]."""


def landing_drift(push: Vec2, height: float, brake: float, airframe: Airframe) -> Vec2:
    """Return how far the drone's own landing drifts [m].

    Args:
        push: steady push in the plane [m/s^2].
        height: where its own landing begins [m].
        brake: how quickly its hover stops it, drag included [1/s].
        airframe: of the drone.
    """
    seconds = max(height - airframe.body.standing_height, 0.0) / airframe.landing.sink_rate
    reach = (seconds - (1.0 - exp(-brake * seconds)) / brake) / brake
    return clipped(push[0] * reach, AIM_MAX), clipped(push[1] * reach, AIM_MAX)
