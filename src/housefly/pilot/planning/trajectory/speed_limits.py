"""The highest speed at each place of a curve."""

from __future__ import annotations

from math import cbrt
from typing import NamedTuple

import numpy as np

from housefly.numeric import FloatArray, compiled_with_arrays, elementwise
from housefly.pilot.planning.trajectory.curve import ArcCurve


class MotionLimits(NamedTuple):
    """What a trajectory may ask of the drone.

    Attributes:
        speed: [m/s].
        vertical_speed: [m/s].
        acceleration: of tilt, drag included: what holds the speed against the air counts [m/s^2].
        vertical_acceleration: [m/s^2].
        jerk: [m/s^3].
        drag: deceleration by the air for every m/s [1/s].
        narrow_speed: highest speed where the hull is no farther from things than it must be [m/s].
        wide: clearance from which on things slow nobody down [m].
    """

    speed: float
    vertical_speed: float
    acceleration: float
    vertical_acceleration: float
    jerk: float
    drag: float
    narrow_speed: float
    wide: float


def speed_limits(
    curve: ArcCurve, limits: MotionLimits, clearance: FloatArray, keep: float, zones: FloatArray
) -> FloatArray:
    """Return the highest speed at each sample of a curve [m/s], shape (n,).

    Args:
        curve: to fly.
        limits: of the drone.
        clearance: of the hull at each sample [m], shape (n,).
        keep: what the hull keeps from everything [m].
        zones: highest speed at each sample by order [m/s], shape (n,).
    """
    bend = np.linalg.norm(curve.bends[:, :2], axis=1)
    vertical_bend = np.abs(curve.bends[:, 2])
    steep = np.abs(curve.along[:, 2])
    share = np.clip((clearance - keep) / max(limits.wide - keep, 1e-9), 0.0, 1.0)
    fastest = np.minimum(limits.speed, zones)
    fastest = np.minimum(
        fastest, limits.narrow_speed + share * max(limits.speed - limits.narrow_speed, 0.0)
    )
    fastest = np.minimum(fastest, limits.vertical_speed / np.maximum(steep, 1e-9))
    fastest = np.minimum(fastest, _turning_speed(bend, limits.acceleration, limits.drag))
    fastest = np.minimum(
        fastest, np.sqrt(limits.vertical_acceleration / np.maximum(vertical_bend, 1e-9))
    )
    cubes = limits.jerk / np.maximum(_bend_change(curve), 1e-9)
    slower = np.flatnonzero(cubes < fastest * fastest * fastest)
    fastest[slower] = elementwise(cbrt, cubes[slower])
    return np.where(curve.stands > 0.0, 0.0, fastest)


def _bend_change(curve: ArcCurve) -> FloatArray:
    """Return how quickly the bend changes along a curve, the larger side of each sample [1/m^2]."""
    apart = np.maximum(np.diff(curve.marks), 1e-9)
    change = np.linalg.norm(np.diff(curve.bends, axis=0), axis=1) / apart
    larger: FloatArray = np.maximum(np.append(change, 0.0), np.insert(change, 0, 0.0))
    return larger


def _turning_speed(bend: FloatArray, acceleration: float, drag: float) -> FloatArray:
    """Return the speed at which a bend [1/m] and the drag take all the acceleration [m/s]."""
    # Of the two ways to write the root of the quadratic, the one that does not cancel.
    root = np.sqrt((drag * drag) ** 2 + 4.0 * bend**2 * acceleration**2)
    speeds: FloatArray = np.sqrt(2.0 * acceleration**2 / (drag**2 + root))
    return speeds


@compiled_with_arrays
def lowered_around(marks: FloatArray, fastest: FloatArray, time: float) -> FloatArray:
    """Return the lowest limit within half the way that each limit covers in a time [s].

    What is averaged over that time afterwards keeps the limit.
    """
    lowered = fastest.copy()
    for i in range(marks.size):
        reach = 0.5 * fastest[i] * time
        j = i
        while j >= 0 and marks[i] - marks[j] <= reach:
            lowered[j] = min(lowered[j], fastest[i])
            j -= 1
        j = i
        while j < marks.size and marks[j] - marks[i] <= reach:
            lowered[j] = min(lowered[j], fastest[i])
            j += 1
    return lowered
