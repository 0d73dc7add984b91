"""The motion of a drone that is moved by hand: a velocity for a moment, then to rest by itself.

    velocity ── held ──┐
                       └── braking ── rest

Each motion ends at rest, so what was checked once needs nobody to end it.
"""

from __future__ import annotations

from math import sqrt
from typing import Any, NamedTuple

import numpy as np

from housefly.config.limits import LimitsConfig
from housefly.numeric import FloatArray, clipped, compiled, norm
from housefly.pilot.planning.trajectory.kinematic_state import TICK, KinematicState

ACCELERATION_MAX = 1.0
"""Moved by hand it speeds up and brakes no harder than it can be counted on to [m/s^2] ..."""
JERK_MAX = 6.0
"""... and no more suddenly than it leans in comfort [m/s^3]."""
CLIMB_SHARE = 0.7
"""Control keeps the rest of the largest climb rate."""
LONGEST = 4.0
"""No such motion takes longer [s]."""
_STILL, _UNPUSHED = 2e-3, 0.1
"""It is at rest when slower than this and hardly accelerated [m/s, m/s^2]."""


class HeldLimits(NamedTuple):
    """What a motion by hand may ask of the drone.

    Attributes:
        speed: largest, level and in all [m/s].
        climb: largest, up or down [m/s].
        acceleration: level [m/s^2].
        vertical_acceleration: up or down [m/s^2].
        jerk: [m/s^3].
    """

    speed: float
    climb: float
    acceleration: float
    vertical_acceleration: float
    jerk: float


def held_limits(limits: LimitsConfig) -> HeldLimits:
    """Return what a motion by hand may ask for on a site."""
    return HeldLimits(
        speed=min(limits.nudge_speed, limits.speed),
        climb=min(limits.nudge_speed, CLIMB_SHARE * limits.vertical_speed_max),
        acceleration=min(limits.acceleration, ACCELERATION_MAX),
        vertical_acceleration=min(limits.vertical_acceleration, ACCELERATION_MAX),
        jerk=min(limits.jerk, JERK_MAX),
    )


def held_velocity(wish: FloatArray, limits: HeldLimits) -> FloatArray:
    """Return a velocity that was asked for within the limits [m/s], shape (3,)."""
    length = norm(wish)
    within = wish * min(1.0, limits.speed / max(length, 1e-9))
    within[2] = clipped(float(within[2]), limits.climb)
    return within


@compiled
def _pushed(v: float, target: float, acceleration: float, jerk: float) -> float:
    """Return the acceleration that leads to a speed and ends there with half the jerk [m/s^2]."""
    missing = target - v
    wanted = min(sqrt(jerk * abs(missing)), acceleration, abs(missing) / TICK)
    return wanted if missing > 0.0 else -wanted


@compiled
def _fill(rows: Any, wish: FloatArray, held: int, pushes: FloatArray, jerk: float) -> int:
    for n in range(1, rows.shape[0]):
        still = n > held
        for axis in range(3):
            p, v, a = rows[n - 1, axis], rows[n - 1, 3 + axis], rows[n - 1, 6 + axis]
            target = wish[axis] if n <= held else 0.0
            aim = _pushed(v + 0.5 * TICK * a, target, pushes[axis], jerk)
            push = a + clipped(aim - a, jerk * TICK)
            faster = v + 0.5 * TICK * (a + push)
            rows[n, axis] = p + 0.5 * TICK * (v + faster) + TICK * TICK * (a - push) / 12.0
            rows[n, 3 + axis], rows[n, 6 + axis] = faster, push
            still = still and abs(faster) < _STILL and abs(push) < _UNPUSHED
        if still:
            return n
    return int(rows.shape[0]) - 1


def held_motion(
    start: KinematicState, velocity: FloatArray, held: float, limits: HeldLimits
) -> FloatArray:
    """Return the motion that holds a velocity for a while and comes to rest, shape (n, 9).

    Args:
        start: where it begins.
        velocity: to hold [m/s], shape (3,); within the limits.
        held: for so long [s].
        limits: of the motion.
    """
    rows = np.zeros((round(LONGEST / TICK), 9))
    rows[0] = np.concatenate(start)
    level = limits.acceleration / sqrt(2.0)  # along both axes together no more than the limit
    pushes = np.array([level, level, limits.vertical_acceleration])
    last = _fill(rows, velocity, round(held / TICK), pushes, limits.jerk / sqrt(3.0))
    rows[last, 3:] = 0.0
    return np.ascontiguousarray(rows[: last + 1])
