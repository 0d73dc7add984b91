"""How the reference travels through a trajectory: as planned, slower, or to a stop on the curve.

The trajectory's own time runs at a rate between 0 and 1. At 1 it is flown as planned; to slow down
or to stop, the rate falls as quickly as the drone can be counted on to brake, and no more suddenly
than it can lean. The curve stays the same, so a stop from any state on it needs no other check.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from housefly.numeric import FloatArray, clipped, compiled
from housefly.pilot.planning.trajectory.kinematic_state import hermite

_JERK = 6.0
"""How quickly braking and speeding up set in; they end half as quickly, so that the rate never
shoots over [m/s^3].
"""
_SLOWEST = 0.2
"""Below this speed the rate changes as at it [m/s]."""


class TimeScale(NamedTuple):
    """How far a trajectory has been flown.

    Attributes:
        time: of the trajectory's own [s].
        rate: of its passing, 0 to 1.
        change: of the rate [1/s].
    """

    time: float
    rate: float
    change: float


TRAJECTORY_START = TimeScale(time=0.0, rate=1.0, change=0.0)
"""At the first row of a trajectory."""


class MotionSetpoint(NamedTuple):
    """Place [m], velocity [m/s] and acceleration [m/s^2] to track."""

    x: float
    y: float
    z: float
    vx: float
    vy: float
    vz: float
    ax: float
    ay: float
    az: float


@compiled
def row_at(time: float, tick: float, count: int) -> tuple[int, float]:
    """Return the row before a time [s], never the last, and the share of the tick since."""
    scaled = min(max(time / tick, 0.0), count - 1.0)
    at = min(int(scaled), count - 2)
    return at, scaled - at


@compiled
def scale_advanced(
    scale: TimeScale, rows: FloatArray, tick: float, wanted: float, braking: float, dt: float
) -> TimeScale:
    """Return how far a trajectory has been flown after a time.

    Args:
        scale: before.
        rows: of the trajectory, shape (n, 9), n at least 2.
        tick: time between two rows [s].
        wanted: rate, 0 stops.
        braking: deceleration to count on [m/s^2].
        dt: [s].
    """
    if dt <= 0.0:
        return scale
    end = tick * (rows.shape[0] - 1)
    missing = min(max(wanted, 0.0), 1.0) - scale.rate
    if missing == 0.0 and scale.change == 0.0:
        # Nearly every tick; all that follows comes to this.
        return TimeScale(min(scale.time + scale.rate * dt, end), scale.rate, 0.0)
    at, _ = row_at(scale.time, tick, rows.shape[0])
    vx, vy, vz = rows[at, 3], rows[at, 4], rows[at, 5]
    speed = max((vx * vx + vy * vy + vz * vz) ** 0.5, _SLOWEST)
    # Half the jerk from here to the wanted rate: change^2 = jerk |missing|.
    ending = min((_JERK / speed * abs(missing)) ** 0.5, abs(missing) / dt, braking / speed)
    aim = ending if missing > 0.0 else -ending
    change = scale.change + clipped(aim - scale.change, _JERK / speed * dt)
    rate = min(max(scale.rate + change * dt, 0.0), 1.0)
    time = min(scale.time + 0.5 * (scale.rate + rate) * dt, end)
    return TimeScale(time=time, rate=rate, change=change)


@compiled
def motion_at(scale: TimeScale, rows: FloatArray, tick: float) -> MotionSetpoint:
    """Return what to track at this point of a trajectory."""
    at, u = row_at(scale.time, tick, rows.shape[0])
    return MotionSetpoint(
        x=_place(rows, at, u, 0, tick),
        y=_place(rows, at, u, 1, tick),
        z=_place(rows, at, u, 2, tick),
        vx=scale.rate * _mean(rows, at, u, 3),
        vy=scale.rate * _mean(rows, at, u, 4),
        vz=scale.rate * _mean(rows, at, u, 5),
        ax=_push(rows, at, u, 0, scale),
        ay=_push(rows, at, u, 1, scale),
        az=_push(rows, at, u, 2, scale),
    )


@compiled
def _mean(rows: Any, at: int, u: float, column: int) -> float:
    return (1.0 - u) * float(rows[at, column]) + u * float(rows[at + 1, column])


@compiled
def _place(rows: Any, at: int, u: float, axis: int, tick: float) -> float:
    slope0, slope1 = tick * rows[at, 3 + axis], tick * rows[at + 1, 3 + axis]
    return hermite(rows[at, axis], rows[at + 1, axis], slope0, slope1, u)


@compiled
def _push(rows: Any, at: int, u: float, axis: int, scale: TimeScale) -> float:
    velocity, acceleration = _mean(rows, at, u, 3 + axis), _mean(rows, at, u, 6 + axis)
    return scale.rate * scale.rate * acceleration + scale.change * velocity


def stopping_rows(scale: TimeScale, rows: FloatArray, tick: float, braking: float) -> FloatArray:
    """Return the motion that comes to rest on a trajectory, the present row first, shape (m, 9).

    Args:
        scale: how far the trajectory has been flown.
        rows: of the trajectory, shape (n, 9) or wider.
        tick: time between two rows, and between two of the motion [s].
        braking: deceleration to count on [m/s^2].
    """
    motion = [motion_at(scale, rows, tick)]
    end = tick * (len(rows) - 1)
    while scale.rate > 0.0 and scale.time < end:
        scale = scale_advanced(scale, rows, tick, 0.0, braking, tick)
        motion.append(motion_at(scale, rows, tick))
    stopped = np.array(motion)
    stopped[-1, 3:] = 0.0
    return stopped
