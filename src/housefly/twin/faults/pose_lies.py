"""What tracking that lies makes of a true pose; pure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import cos, floor, nan, sin

from housefly.geometry import Quaternion, Vec2, quaternion_from_euler, quaternion_product
from housefly.messages import Pose
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import FaultKind

PoseLie = Callable[[Fault, Pose, float, Vec2], Pose]
"""Fault, true pose, time since the fault began [s], place of the pad [m]: the pose reported."""

_NO_ROTATION = 1.7
"""Length of a quaternion that is no rotation."""


def body_lie(fault: Fault) -> PoseLie | None:
    """Return what a fault makes of the drone's pose; None when it leaves it."""
    return _OF_THE_DRONE.get((fault.aspect, fault.kind))


def room_lie(fault: Fault) -> PoseLie | None:
    """Return what a fault makes of every body's pose; None when it leaves them."""
    return _OF_THE_ROOM.get((fault.aspect, fault.kind))


def _moved(pose: Pose, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Pose:
    px, py, pz = pose.position
    return replace(pose, position=(px + x, py + y, pz + z))


def _aside(fault: Fault, pose: Pose, by: float) -> Pose:
    x, y = fault.direction()
    return _moved(pose, by * x, by * y)


def _steps(fault: Fault, since: float) -> float:
    """Return how far steps once a second have led [m]; the first comes at once."""
    return fault.size * (1 + floor(since))


def _not_numbers(fault: Fault, pose: Pose, since: float, pad: Vec2) -> Pose:
    return replace(pose, position=(nan, nan, nan))


def _no_rotation(fault: Fault, pose: Pose, since: float, pad: Vec2) -> Pose:
    w, x, y, z = pose.orientation
    return replace(
        pose, orientation=(w * _NO_ROTATION, x * _NO_ROTATION, y * _NO_ROTATION, z * _NO_ROTATION)
    )


def _body_turned(fault: Fault, pose: Pose, since: float, pad: Vec2) -> Pose:
    return replace(pose, orientation=quaternion_product(pose.orientation, _about_up(fault.size)))


def _y_mirrored(fault: Fault, pose: Pose, since: float, pad: Vec2) -> Pose:
    x, y, z = pose.position
    return replace(pose, position=(x, 2.0 * pad[1] - y, z))


def _room_mirrored(fault: Fault, pose: Pose, since: float, pad: Vec2) -> Pose:
    w, x, y, z = pose.orientation
    return replace(_y_mirrored(fault, pose, since, pad), orientation=(w, -x, y, -z))


def _room_turned(fault: Fault, pose: Pose, since: float, pad: Vec2) -> Pose:
    c, s = cos(fault.size), sin(fault.size)
    x, y = pose.position[0] - pad[0], pose.position[1] - pad[1]
    place = (pad[0] + c * x - s * y, pad[1] + s * x + c * y, pose.position[2])
    return Pose(place, quaternion_product(_about_up(fault.size), pose.orientation))


def _about_up(angle: float) -> Quaternion:
    return quaternion_from_euler(0.0, 0.0, angle)


_WRONG, _GARBAGE = FaultKind.WRONG, FaultKind.GARBAGE
_OF_THE_DRONE: dict[tuple[str, FaultKind], PoseLie] = {
    ("", _GARBAGE): _not_numbers,
    ("orientation", _GARBAGE): _no_rotation,
    ("position", _WRONG): lambda fault, pose, since, pad: _aside(fault, pose, fault.size),
    ("x", _WRONG): lambda fault, pose, since, pad: _moved(pose, x=fault.size),
    ("y", _WRONG): lambda fault, pose, since, pad: _moved(pose, y=fault.size),
    ("z", _WRONG): lambda fault, pose, since, pad: _moved(pose, z=fault.size),
    ("drift", _WRONG): lambda fault, pose, since, pad: _aside(fault, pose, fault.size * since),
    ("drift_x", _WRONG): lambda fault, pose, since, pad: _moved(pose, x=fault.size * since),
    ("drift_y", _WRONG): lambda fault, pose, since, pad: _moved(pose, y=fault.size * since),
    ("drift_z", _WRONG): lambda fault, pose, since, pad: _moved(pose, z=fault.size * since),
    ("steps", _WRONG): lambda fault, pose, since, pad: _aside(fault, pose, _steps(fault, since)),
    ("steps_x", _WRONG): lambda fault, pose, since, pad: _moved(pose, x=_steps(fault, since)),
    ("steps_y", _WRONG): lambda fault, pose, since, pad: _moved(pose, y=_steps(fault, since)),
    ("yaw", _WRONG): _body_turned,
}
_OF_THE_ROOM: dict[tuple[str, FaultKind], PoseLie] = {
    ("axes", _WRONG): _y_mirrored,
    ("map", _WRONG): _room_mirrored,
    ("map_yaw", _WRONG): _room_turned,
    ("origin_x", _WRONG): lambda fault, pose, since, pad: _moved(pose, x=fault.size),
    ("origin_y", _WRONG): lambda fault, pose, since, pad: _moved(pose, y=fault.size),
    ("origin_z", _WRONG): lambda fault, pose, since, pad: _moved(pose, z=fault.size),
}
