"""Checks poses from a tracking system before anything steers by them."""

from __future__ import annotations

from math import hypot, isfinite

from housefly.errors import WireError
from housefly.geometry import Quaternion, Vec3, normalized
from housefly.messages import Pose
from housefly.wires.axes import z_up_orientation, z_up_position

POSITION_MAX = 1000.0
"""Positions beyond this on any axis [m] are refused: no tracked room is a kilometre long."""
_NORM_TOLERANCE = 0.01
"""Largest deviation of a quaternion's length from 1."""


def checked_pose(position: Vec3, orientation: Quaternion, y_up: bool) -> Pose:
    """Return the pose with z up and w >= 0.

    Args:
        position: in the sender's axes [m].
        orientation: (w, x, y, z) in the sender's axes.
        y_up: whether the sender's y axis points up.

    Raises:
        WireError: a value is not finite, a kilometre away, or not a rotation.
    """
    if not all(isfinite(value) and abs(value) <= POSITION_MAX for value in position):
        raise WireError(f"position {position} m is not within a kilometre")
    if not abs(hypot(*orientation) - 1.0) <= _NORM_TOLERANCE:
        raise WireError(f"orientation {orientation} is not a unit quaternion")
    w, x, y, z = normalized(orientation)
    turned = (w, x, y, z) if w >= 0 else (-w, -x, -y, -z)
    if y_up:
        return Pose(z_up_position(position), z_up_orientation(turned))
    return Pose(position, turned)
