"""Directions and turns of tracking held against the drone's own, compiled.

A body or a map that is defined turned, and one that is mirrored, show the drone's ways and turns
otherwise than it felt them.
"""

from __future__ import annotations

from math import atan2, sqrt
from typing import Any

from housefly.numeric import compiled, wrapped
from housefly.pilot.estimation.displacement import TIMING_ERROR, speed_change
from housefly.pilot.estimation.onboard_odometry import flow_bias_variance

DIRECTION_WAY_MIN = 0.12
"""A direction is read from no shorter way than this [m]."""
DIRECTION_SIGMAS = 12.0
"""... and from none shorter than this many standard deviations: 5 degrees."""
TURN_MIN = 0.15
"""Turns are compared from here on [rad]."""


@compiled
def direction_error(new: Any, row: Any, noise: float) -> float:
    """Return the angle between the two displacements [rad], -1 when one of them is too short."""
    px, py, ox, oy = new.px - row.px, new.py - row.py, new.ox - row.ox, new.oy - row.oy
    seconds, white = new.at - row.at, new.variance - row.variance
    sigma = sqrt(white + flow_bias_variance(seconds) + 2.0 * noise * noise)
    least = max(DIRECTION_WAY_MIN, DIRECTION_SIGMAS * sigma)
    if ox * ox + oy * oy < least * least or px * px + py * py < 0.25 * least * least:
        return -1.0
    slack = TIMING_ERROR * speed_change(new, row) / sqrt(ox * ox + oy * oy)
    return max(0.0, abs(atan2(ox * py - oy * px, ox * px + oy * py)) - slack)


@compiled
def turn_error(new: Any, row: Any) -> float:
    """Return how far the two turns differ [rad], -1 when that is nothing to speak of."""
    error = abs(wrapped((new.yaw - row.yaw) - (new.psi - row.psi)))
    return error if error > TURN_MIN else -1.0


@compiled
def turns_back(new: Any, row: Any) -> bool:
    """Return whether tracking shows the mirror image of the drone's own turn."""
    tracked, onboard = new.yaw - row.yaw, new.psi - row.psi
    return bool(abs(onboard) > TURN_MIN and abs(tracked + onboard) < 0.5 * abs(onboard))
