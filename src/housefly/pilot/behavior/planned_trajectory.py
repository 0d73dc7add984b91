"""What a path in space is to those who show it."""

from __future__ import annotations

from housefly.messages.steering import Path, PlannedTrajectory, TrajectoryPoint
from housefly.pilot.behavior.trajectory_profile import SpacePath


def planned_trajectory(path: Path | None, now: float) -> PlannedTrajectory | None:
    """Return a path with its heights, times and speeds as of now [s]; None of one in the plane."""
    if not isinstance(path, SpacePath):
        return None
    points = zip(path.waypoints, path.heights, path.times, path.speeds, strict=True)
    return PlannedTrajectory(
        now, tuple(TrajectoryPoint((x, y, z), time, speed) for (x, y), z, time, speed in points)
    )
