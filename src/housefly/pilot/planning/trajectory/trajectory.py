"""A trajectory: where the drone is to be at each time, checked on the curve that is flown."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from housefly.numeric import FloatArray, norm
from housefly.pilot.planning.space.any_angle import in_voxel_edges
from housefly.pilot.planning.space.clearance import hull_clearances
from housefly.pilot.planning.space.voxels import CLEARANCE_CAP, VoxelMap, VoxelMask
from housefly.pilot.planning.trajectory.bspline import moving_start
from housefly.pilot.planning.trajectory.control_points import control_points, stopping_points
from housefly.pilot.planning.trajectory.corridor import corridor
from housefly.pilot.planning.trajectory.curve import arc_curve
from housefly.pilot.planning.trajectory.speed_limits import MotionLimits
from housefly.pilot.planning.trajectory.timing import STANDING, TICK, KinematicState, timed_motion

STRIDES = (0.2, 0.4, 0.1)
"""About how far the control points of a curve are apart [m]; in flight the others are tried where
the first leads to nothing.
"""
CLEARANCE_GIVE = 0.02
"""A curve may come this much nearer than ``keep``: voxels end at their middles [m]."""

_BEND_MAX = 100.0
"""A start on a tighter bend, which is one at a crawl, stops first [1/m]."""
_HALF_DIAGONAL = 0.8661
"""Of a voxel, over its edge."""


@dataclass(frozen=True, slots=True, eq=False)
class Trajectory:
    """A motion from a state to rest at a goal.

    Attributes:
        rows: place [m], velocity [m/s] and acceleration [m/s^2] every ``TICK``, shape (n, 9).
        length: of the curve [m].
        clearance: of the hull, the smallest on the way [m].
        stops: it is the polyline that stands at every corner, because no curve was good enough.
        yaws: the heading to hold at each row [rad], shape (n,), where the way leads through a
            door that is too narrow for the hull's disc; None where the heading is free.
    """

    rows: FloatArray
    length: float
    clearance: float
    stops: bool = False
    yaws: FloatArray | None = None

    @property
    def duration(self) -> float:
        """How long it takes [s]."""
        return TICK * (len(self.rows) - 1)


def at_rest(place: FloatArray) -> KinematicState:
    """Return the state that stands at a place [m]."""
    return KinematicState(place, np.zeros(3), np.zeros(3))


def trajectory_along(
    voxels: VoxelMap,
    free: VoxelMask,
    rows: FloatArray,
    corners: FloatArray,
    start: KinematicState,
    limits: MotionLimits,
    zones: Callable[[FloatArray], FloatArray] | None = None,
) -> Trajectory | None:
    """Return a smooth trajectory near a way; None when no way of flying it keeps the limits.

    Args:
        voxels: the map.
        free: its free voxels, shape (nx, ny, nz).
        rows: everything in the room, for the last look, shape (n, 11).
        corners: of a way through free voxels, from the start to the goal [m], shape (m, 3).
        start: where the drone is and how it moves.
        limits: of the drone.
        zones: return the highest speeds by order [m/s], shape (k,), at places [m], shape (k, 3).
    """
    boxes = corridor(free, in_voxel_edges(voxels, corners))
    boxes = boxes * voxels.resolution + np.array(voxels.origin)
    boxes[0] = np.minimum(boxes[0, 0], corners[0]), np.maximum(boxes[0, 1], corners[0])
    boxes[-1] = np.minimum(boxes[-1, 0], corners[-1]), np.maximum(boxes[-1, 1], corners[-1])
    is_standing = norm(start.velocity) < STANDING
    if not is_standing and _bend_of(start) > _BEND_MAX:
        return None
    is_chain = bool((boxes[1:, 0] <= boxes[:-1, 1]).all() and (boxes[:-1, 0] <= boxes[1:, 1]).all())
    strides = (STRIDES[:1] if is_standing else STRIDES) if is_chain else ()
    choices = [
        (control_points(boxes, _first_points(start, stride), corners[-1], stride), False)
        for stride in strides
    ]
    if is_standing:
        choices.append((stopping_points(corners), True))
    for points, stops in choices:
        curve = arc_curve(points)
        clearance = hull_clearances(rows, curve.places, voxels.hull, CLEARANCE_CAP)
        # A way through free voxels may pass half a voxel's diagonal beside their middles.
        give = _HALF_DIAGONAL * voxels.resolution if stops else CLEARANCE_GIVE
        if clearance.min() < voxels.keep - give:
            continue
        speeds = None if zones is None else zones(curve.places)
        motion = timed_motion(curve, clearance, voxels.keep, start, limits, speeds)
        if motion is not None:
            return Trajectory(motion, float(curve.marks[-1]), float(clearance.min()), stops)
    return None


def _bend_of(start: KinematicState) -> float:
    """Return the bend of the curve on which a state moves [1/m]."""
    speed = norm(start.velocity)
    return norm(np.cross(start.velocity, start.acceleration)) / (speed * speed * speed)


def _first_points(start: KinematicState, stride: float) -> FloatArray:
    speed = norm(start.velocity)
    if speed < STANDING:
        return np.repeat(start.place[None, :], 3, axis=0)
    along = start.velocity / speed
    aside = start.acceleration - (start.acceleration * along).sum() * along
    return moving_start(start.place, along, aside / speed**2, stride)
