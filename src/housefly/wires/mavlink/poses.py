"""ODOMETRY, as a mocap room sends it: where the vehicle was, and how fast it moved; and what
other ground stations send in its place.

ArduPilot drops it silently unless its frames are LOCAL_FRD and BODY_FRD, and takes its velocity for
true: so that is the slope of the last poses, and unknown is left to the first.
"""

from __future__ import annotations

from collections import deque
from math import isfinite, nan
from typing import Any

from housefly.errors import WireError
from housefly.geometry import Vec3, normalized, quaternion_from_euler, rotate
from housefly.messages import Pose
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.frames import (
    across_attitude,
    across_body,
    across_orientation,
    across_world,
)
from housefly.wires.mavlink.framing import finite

LOCAL_FRD, BODY_FRD = 20, 12
_MOCAP = 5
_SPAN = 0.12
"""The velocity is the slope of the poses of so long [s]."""
_UNKNOWN = (nan,) * 21


def pose_message(pose: Pose, velocity: Vec3, captured_at: float) -> Any:
    """Return the message of a pose.

    Args:
        pose: in our world.
        velocity: in our world [m/s]; zero before it is known.
        captured_at: when it was there, by our clock [s].
    """
    w, x, y, z = pose.orientation
    own = across_body(rotate((w, -x, -y, -z), velocity))
    return dialect().MAVLink_odometry_message(
        int(1e6 * captured_at),
        *(LOCAL_FRD, BODY_FRD),
        *across_world(pose.position),
        list(across_orientation(pose.orientation)),
        *own,
        *(nan, nan, nan),
        list(_UNKNOWN),
        list(_UNKNOWN),
        *(0, _MOCAP, 100),
    )


def pose_in(message: Any) -> tuple[Pose, float]:
    """Return the pose of a message and when it was so by the sender's clock [s].

    Raises:
        WireError: other frames than these, a number that is not finite, or no orientation.
    """
    if (message.frame_id, message.child_frame_id) != (LOCAL_FRD, BODY_FRD):
        raise WireError(
            f"ODOMETRY of frames {message.frame_id} and {message.child_frame_id}; allowed:"
            f" {LOCAL_FRD} and {BODY_FRD}"
        )
    north, east, down = finite(message, "x", "y", "z")
    w, x, y, z = (float(part) for part in message.q)
    length = w * w + x * x + y * y + z * z
    if not (isfinite(length) and 0.9 < length < 1.1):
        raise WireError(f"ODOMETRY.q is {(w, x, y, z)}; allowed: a unit quaternion")
    turned = across_orientation(normalized((w, x, y, z)))
    return Pose(across_world((north, east, down)), turned), message.time_usec / 1e6


def vision_in(message: Any) -> tuple[Pose, float]:
    """Return the pose of a VISION_POSITION_ESTIMATE and when it was so; raises WireError."""
    north, east, down = finite(message, "x", "y", "z")
    roll, pitch, heading = finite(message, "roll", "pitch", "yaw")
    turned = quaternion_from_euler(*across_attitude((roll, pitch, heading)))
    return Pose(across_world((north, east, down)), turned), message.usec / 1e6


class PoseSpeed:
    """The velocity of a body by its last poses: the slope of a line through them."""

    def __init__(self) -> None:
        self._seen: deque[tuple[float, Vec3]] = deque()

    def after(self, position: Vec3, at: float) -> Vec3:
        """Take in a position of a time [s]; return the velocity [m/s], zero while unknown."""
        while self._seen and not 0.0 < at - self._seen[0][0] <= _SPAN:
            self._seen.popleft()
        self._seen.append((at, position))
        count = len(self._seen)
        middle = sum(time for time, _ in self._seen) / count
        spread = sum((time - middle) ** 2 for time, _ in self._seen)
        if not spread:
            return 0.0, 0.0, 0.0
        x, y, z = (
            sum((time - middle) * place[axis] for time, place in self._seen) / spread
            for axis in range(3)
        )
        return x, y, z
