"""What the tests of references share: one that travels along a path, as ``pilot.step`` moves it."""

from __future__ import annotations

from math import nan

from housefly.geometry import Vec2
from housefly.pilot.behavior.path_profile import path_profile
from housefly.pilot.behavior.path_progress import (
    PathProgress,
    TrajectorySetpoint,
    progress_advanced,
    progress_headed,
    setpoint_at,
)
from housefly.pilot.behavior.waypoints import paper_heading, waypoint_advanced, waypoint_setpoint

DT = 0.02


class PathFollower:
    """The reference of mode default on one path, wanting a speed [m/s]."""

    def __init__(self, waypoints: tuple[Vec2, ...], speed: float = 0.5) -> None:
        self._profile, self._speed = path_profile(waypoints), speed
        self._progress = PathProgress(0.0, 0.0, 0.0, 0, nan)

    def step(self, x: float, y: float, moving: bool = True, dt: float = DT) -> TrajectorySetpoint:
        """Return the reference dt [s] later, the drone being at (x, y) [m]."""
        moved = progress_advanced(self._progress, self._profile, self._speed, x, y, moving, dt)
        self._progress = progress_headed(moved, self._profile)
        return setpoint_at(self._progress, self._profile)


class WaypointFollower:
    """The reference of mode paper on one path, for a drone with a heading [rad]."""

    def __init__(self, waypoints: tuple[Vec2, ...], yaw: float, eps3: float) -> None:
        self._waypoints, self._eps3 = path_profile(waypoints).waypoints, eps3
        self._index, self._yaw = 0, paper_heading(yaw)

    def step(self, x: float, y: float) -> TrajectorySetpoint:
        """Return the reference after one look at a drone at (x, y) [m]."""
        self._index, self._yaw = waypoint_advanced(
            self._index, self._yaw, self._waypoints, x, y, self._eps3
        )
        return waypoint_setpoint(self._index, self._yaw, self._waypoints)
