"""A trajectory in space as the profile that is flown and the path that people are shown."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2

import numpy as np

from housefly.messages.steering import Path
from housefly.numeric import FloatArray, elementwise
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.yaw_reference import YAW_REFERENCE_RATE
from housefly.pilot.planning.trajectory.heading import headings
from housefly.pilot.planning.trajectory.kinematic_state import TICK

WAYPOINT_SPACING = 0.25
"""A trajectory is shown by a point about every so often [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class SpacePath(Path):
    """A path through the height of the room; on wires and in recordings it is a ``Path``.

    It equals the ``Path`` that is recorded of it.

    Attributes:
        heights: at the waypoints [m].
        times: when it is planned to pass them, since its start [s].
        speeds: planned there [m/s].
    """

    heights: tuple[float, ...]
    times: tuple[float, ...]
    speeds: tuple[float, ...]

    def __eq__(self, other: object) -> bool:
        """Return whether the other is the same way, heights and times apart."""
        return isinstance(other, Path) and _recorded(self) == _recorded(other)

    def __hash__(self) -> int:
        """Return a number that equal paths share."""
        return hash(_recorded(self))

    def __str__(self) -> str:
        """Return it as people read it: how long, in what time, how high, how near to things."""
        low, high = min(self.heights), max(self.heights)
        return (
            f"{self.length:.2f} m in {self.times[-1]:.1f} s, {low:.2f} to {high:.2f} m high,"
            f" {self.clearance:.2f} m clear, {len(self.waypoints)} waypoints"
        )


def _recorded(path: Path) -> tuple[object, ...]:
    return path.waypoints, path.length, path.clearance


def trajectory_profile(
    rows: FloatArray, start_yaw: float, arrival_yaw: float, yaws: FloatArray | None = None
) -> PathProfile:
    """Return a motion as the profile that is flown, with the heading along it.

    Args:
        rows: place, velocity and acceleration every ``TICK``, shape (n, 9), n at least 2.
        start_yaw: heading at the start [rad].
        arrival_yaw: wanted at the end [rad]; nan keeps that of the motion.
        yaws: to hold on the last rows, where a door leaves no choice [rad], shape (k,).
    """
    if yaws is None:
        yaws = headings(rows, TICK, start_yaw, arrival_yaw, YAW_REFERENCE_RATE)
    else:
        yaws = np.concatenate((np.full(len(rows) - len(yaws), start_yaw), yaws))
    shown = _shown(rows)
    points = np.ascontiguousarray(rows[shown, :2])
    steps = np.diff(points, axis=0)
    lengths = np.maximum(np.linalg.norm(steps, axis=1), 1e-9)
    return PathProfile(
        points=points,
        marks=TICK * shown.astype(float),
        speeds=np.linalg.norm(rows[shown, 3:6], axis=1),
        along=steps / lengths[:, None],
        headings=elementwise(atan2, steps[:, 1], steps[:, 0]),
        waypoints=points,
        motion=np.ascontiguousarray(np.column_stack((rows, yaws))),
    )


def trajectory_path(rows: FloatArray, clearance: float) -> SpacePath:
    """Return a motion as people are shown it.

    Args:
        rows: place, velocity and acceleration every ``TICK``, shape (n, 9), n at least 2.
        clearance: smallest distance from the drone's middle to a solid [m].
    """
    shown = _shown(rows)
    places = rows[shown, :3].tolist()
    return SpacePath(
        waypoints=tuple((x, y) for x, y, _ in places),
        length=float(_travelled(rows)[-1]),
        clearance=clearance,
        heights=tuple(z for _, _, z in places),
        times=tuple((TICK * shown).tolist()),
        speeds=tuple(np.linalg.norm(rows[shown, 3:6], axis=1).tolist()),
    )


def retimed(
    path: SpacePath, marks: FloatArray, time: float, begin: float, rate: float
) -> SpacePath:
    """Return a path with the times at which it is passed when it is not flown as planned.

    Args:
        path: shown until now.
        marks: the trajectory's own time at each waypoint [s], shape (n,).
        time: that has been flown of it [s].
        begin: when it is flown on, since the start [s].
        rate: of its time from then on, above 0.
    """
    times = np.where(marks <= time, path.times, begin + (marks - time) / rate)
    return replace(path, times=tuple(times.tolist()))


def _travelled(rows: FloatArray) -> FloatArray:
    """Return how far the motion has come at each row [m], shape (n,)."""
    steps = np.linalg.norm(np.diff(rows[:, :3], axis=0), axis=1)
    return np.concatenate(([0.0], np.cumsum(steps)))


def _shown(rows: FloatArray) -> np.ndarray:
    """Return the numbers of the rows that are shown, the first and the last among them."""
    travelled = _travelled(rows)
    count = max(1, round(travelled[-1] / WAYPOINT_SPACING))
    wanted = np.linspace(0.0, travelled[-1], count + 1)[1:-1]
    between = np.searchsorted(travelled, wanted)
    return np.unique(np.concatenate(([0], between, [len(rows) - 1])))
