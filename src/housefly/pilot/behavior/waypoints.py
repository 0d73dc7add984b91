"""The reference of mode paper: the centre of the next cell, at rest, heading 0 or pi."""

from __future__ import annotations

from math import pi, sqrt

from housefly.numeric import FloatArray, compiled, wrapped
from housefly.pilot.behavior.path_progress import TrajectorySetpoint, standing_setpoint


@compiled
def paper_heading(yaw: float) -> float:
    """Return whichever of 0 and pi is nearer to a heading [rad]."""
    return 0.0 if abs(wrapped(yaw)) <= pi / 2 else pi


@compiled
def waypoint_advanced(
    index: int, yaw: float, points: FloatArray, x: float, y: float, eps3: float
) -> tuple[int, float]:
    """Return waypoint and heading [rad]: the next ones when q4 holds, nearer than eps3 [m].

    Args:
        index: waypoint that the drone is sent to.
        yaw: 0 or pi.
        points: waypoints [m], shape (n, 2).
        x: where the drone is [m].
        y: likewise.
        eps3: tolerance of place [m].
    """
    dx, dy = x - points[index, 0], y - points[index, 1]
    if index == len(points) - 1 or not sqrt(dx * dx + dy * dy) < eps3:
        return index, yaw
    leg = points[index + 1, 0] - points[index, 0]
    turned = yaw if abs(leg) < 1e-6 else (0.0 if leg > 0.0 else pi)
    return index + 1, turned


@compiled
def waypoint_setpoint(index: int, yaw: float, points: FloatArray) -> TrajectorySetpoint:
    """Return the reference that stands on a waypoint."""
    is_last = index == len(points) - 1
    return standing_setpoint(points[index, 0], points[index, 1], yaw, index, is_last)
