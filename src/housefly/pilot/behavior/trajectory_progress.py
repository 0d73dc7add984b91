"""How the moving reference travels along a trajectory in space, compiled.

The trajectory is flown as planned, slower, or to a stop on its own curve (``time_scale``); the
reference waits for a drone that is off it, and for nothing else.
"""

from __future__ import annotations

from math import sqrt

from housefly.numeric import compiled
from housefly.pilot.behavior.braking import REFERENCE_BRAKING
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.path_progress import LAG_MAX, TrajectorySetpoint, leg_from
from housefly.pilot.planning.trajectory.kinematic_state import TICK
from housefly.pilot.planning.trajectory.time_scale import (
    TRAJECTORY_START,
    TimeScale,
    motion_at,
    row_at,
    scale_advanced,
)

__all__ = ["TRAJECTORY_START"]
HEADING_COLUMN = 9
"""Of a profile's motion."""


@compiled
def is_in_space(profile: PathProfile) -> bool:
    """Return whether a profile is that of a trajectory in space."""
    return len(profile.motion) > 1


@compiled
def trajectory_advanced(
    scale: TimeScale,
    leg: int,
    profile: PathProfile,
    wanted: float,
    x: float,
    y: float,
    z: float,
    dt: float,
) -> tuple[TimeScale, int]:
    """Return how far the trajectory has been flown after dt [s], and the number of the leg.

    Args:
        scale: before.
        leg: before.
        profile: of the trajectory.
        wanted: rate at which its time is to pass, 0 to 1.
        x: where the drone is [m].
        y: likewise.
        z: likewise.
        dt: [s].
    """
    at = motion_at(scale, profile.motion, TICK)
    off = sqrt((x - at.x) ** 2 + (y - at.y) ** 2 + (z - at.z) ** 2)
    rate = wanted if off <= LAG_MAX else 0.0
    scale = scale_advanced(scale, profile.motion, TICK, rate, REFERENCE_BRAKING, dt)
    return scale, leg_from(leg, scale.time, profile.marks)


@compiled
def trajectory_setpoint(scale: TimeScale, leg: int, profile: PathProfile) -> TrajectorySetpoint:
    """Return the reference at this point of a trajectory."""
    rows = profile.motion
    at, end = motion_at(scale, rows, TICK), TICK * (rows.shape[0] - 1)
    row, _ = row_at(scale.time, TICK, rows.shape[0])
    finished = scale.time >= end - 1e-9
    return TrajectorySetpoint(
        x=at.x,
        y=at.y,
        vx=at.vx,
        vy=at.vy,
        ax=at.ax,
        ay=at.ay,
        yaw=rows[row + 1, HEADING_COLUMN],
        waypoint=leg + 1,
        finished=finished,
        z=at.z,
        vz=at.vz,
        az=at.az,
    )
