"""A motion along a curve as fast as the limits allow: checked tick by tick, eased where needed."""

from __future__ import annotations

from math import inf

import numpy as np

from housefly.numeric import FloatArray, norm
from housefly.pilot.planning.trajectory.curve import ArcCurve
from housefly.pilot.planning.trajectory.kinematic_state import TICK as TICK
from housefly.pilot.planning.trajectory.kinematic_state import KinematicState as KinematicState
from housefly.pilot.planning.trajectory.motion import flown_motion
from housefly.pilot.planning.trajectory.speed_limits import (
    MotionLimits,
    lowered_around,
    speed_limits,
)
from housefly.pilot.planning.trajectory.speed_profile import averaged, swept, timed

STANDING = 1e-6
"""A slower start is at rest [m/s]."""
_LONGEST = 600.0
"""No motion takes longer [s]; a crawl that has to turn on the spot would."""
_TRIES = 6
"""So often a motion is eased until it keeps its limits."""
_TOLERANCE = 1.03
"""Limits may be passed by this factor: they are looked at every tick only."""
_MISMATCH = 0.1
"""Accelerations are those of the velocities to this [m/s^2]; a curve that turns within millimetres
fails.
"""
_CRAWL = 0.02
"""Slower motion may turn as it likes [m/s]."""


def timed_motion(
    curve: ArcCurve,
    clearance: FloatArray,
    keep: float,
    start: KinematicState,
    limits: MotionLimits,
    zones: FloatArray | None = None,
) -> FloatArray | None:
    """Return place, velocity and acceleration every ``TICK``, shape (n, 9).

    None when no way of easing it keeps the limits.

    Args:
        curve: to fly.
        clearance: of the hull at each of its samples [m], shape (n,).
        keep: what the hull keeps from everything [m].
        start: at the first sample.
        limits: of the drone.
        zones: highest speed at each sample by order [m/s], shape (n,); None for no orders.
    """
    slowest = np.full(curve.marks.size, inf) if zones is None else zones
    share = 1.0
    for _ in range(_TRIES):
        eased = limits._replace(
            acceleration=share * limits.acceleration,
            vertical_acceleration=share * limits.vertical_acceleration,
        )
        motion = _motion_within(curve, clearance, keep, start, eased, limits, slowest)
        if motion is None:
            return None
        excess = _excess(motion, limits)
        if excess <= _TOLERANCE:
            return motion if _mismatch(motion) <= _MISMATCH else None
        share *= 0.98 / excess
    return None


def _motion_within(
    curve: ArcCurve,
    clearance: FloatArray,
    keep: float,
    start: KinematicState,
    eased: MotionLimits,
    limits: MotionLimits,
    zones: FloatArray,
) -> FloatArray | None:
    """Return the averaged time-optimal motion, or None when it cannot slow down in time.

    The motion that is averaged runs half a window ahead of its average, and begins with a speed and
    an acceleration whose average is the start's.
    """
    window = 2.0 * limits.acceleration / limits.jerk
    speed = norm(start.velocity)
    push = float((start.acceleration * start.velocity).sum()) / speed if speed > STANDING else 0.0
    lead = 0.5 * speed * window + push * window**2 / 12.0
    raw_speed = speed + 0.5 * push * window
    fastest = lowered_around(
        curve.marks, speed_limits(curve, eased, clearance, keep, zones), window
    )
    first = int(np.searchsorted(curve.marks, lead, side="right"))
    if first >= curve.marks.size:
        return None
    marks = np.concatenate(([lead], curve.marks[first:]))
    pick = np.concatenate(([max(first - 1, 0)], np.arange(first, curve.marks.size)))
    # Twice the same mark: it waits there for a window, so that the average stands, too.
    waits = 1 + (curve.stands[pick] > 0.0).astype(np.int64)
    waits[0] = waits[-1] = 1
    marks, pick = np.repeat(marks, waits), np.repeat(pick, waits)
    fast = fastest[pick]
    fast[0] = max(fast[0], raw_speed) if speed > STANDING else fast[0]
    bend = np.linalg.norm(curve.bends[pick, :2], axis=1)
    steep = np.abs(curve.along[pick, 2])
    raw = swept(marks, fast, bend, steep, eased, raw_speed)
    if raw[0] < raw_speed - STANDING:
        return None
    at_start = np.array([raw_speed, push])
    times = timed(marks, raw, window)
    if times[-1] > _LONGEST:
        return None
    travelled = averaged(times, marks, raw, window, at_start, TICK)
    return flown_motion(curve, travelled)


def _excess(motion: FloatArray, limits: MotionLimits) -> float:
    """Return by which factor a motion passes the limits of acceleration and jerk, at most."""
    tilt = motion[:, 6:8] + limits.drag * motion[:, 3:5]
    flat = np.linalg.norm(tilt, axis=1).max() / limits.acceleration
    upright = np.abs(motion[:, 8]).max() / limits.vertical_acceleration
    jerk = np.linalg.norm(np.diff(motion[:, 6:], axis=0), axis=1).max() / TICK / limits.jerk
    return float(max(flat, upright, jerk))


def _mismatch(motion: FloatArray) -> float:
    """Return how far accelerations are from the change of velocities, at most [m/s^2]."""
    moves = np.linalg.norm(motion[:-1, 3:6], axis=1) > _CRAWL
    change = np.diff(motion[:, 3:6], axis=0) / TICK
    apart = np.abs(change - 0.5 * (motion[1:, 6:] + motion[:-1, 6:])).max(axis=1)
    return float(apart[moves].max(initial=0.0))
